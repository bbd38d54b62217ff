// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the first difference between two JSON documents.
#ifndef INTEGRAL_BASE_JSON_DIFFERENCE_H
#define INTEGRAL_BASE_JSON_DIFFERENCE_H

#include "integral/base/json.h"

#include <optional>
#include <string>

namespace integral {

/// A value that differs: its path in the documents, such as "film.pixel_pitch_mm[0]", and both
/// values as JSON. A value that one document lacks is empty there.
struct JsonDifference {
    std::string path, first, second;
};

/// The first difference. Numbers count as equal if they differ by at most 1e-9 of the larger
/// magnitude, or of `least_magnitude` if both are smaller. `path`: of the values in their documents;
/// empty for the documents themselves.
std::optional<JsonDifference> json_difference(const Json& first, const Json& second,
                                              double least_magnitude, const std::string& path = "");

} // namespace integral

#endif
