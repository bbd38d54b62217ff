// SPDX-License-Identifier: AGPL-3.0-or-later
// The figures of a comparison with multi-view images, for people and for programs.
#ifndef INTEGRAL_LABORATORY_MULTIVIEW_TEXT_H
#define INTEGRAL_LABORATORY_MULTIVIEW_TEXT_H

#include "integral/laboratory/multiview.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace integral {

std::string multiview_text(const MultiviewResult& result);
nlohmann::ordered_json multiview_json(const MultiviewResult& result);

} // namespace integral

#endif
