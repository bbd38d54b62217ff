// SPDX-License-Identifier: AGPL-3.0-or-later
// Results of a suite become its references.
#ifndef INTEGRAL_COMPARE_SUITE_ACCEPT_H
#define INTEGRAL_COMPARE_SUITE_ACCEPT_H

#include "integral/compare/suite_pair.h"

#include <functional>
#include <string>
#include <vector>

namespace integral {

/// Called after each picture: its name, its reference's path, and whether there was none before.
using Accepted = std::function<void(const std::string& name, const std::string& reference,
                                    bool is_new)>;

/// Copies results over their references, with the geometry documents beside them. Each is given by
/// its name within the folder of results, or by its path. Nothing is copied unless every name is a
/// result that can be read. Throws InputError, OutputError.
void accept_results(const std::vector<std::string>& given, const SuiteFolders& folders,
                    const Accepted& accepted);

} // namespace integral

#endif
