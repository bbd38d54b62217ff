// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes results of a suite its references.
#ifndef INTEGRAL_COMPARE_SUITE_ACCEPT_H
#define INTEGRAL_COMPARE_SUITE_ACCEPT_H

#include "integral/compare/suite_pair.h"

#include <functional>
#include <string>
#include <vector>

namespace integral {

/// Called after each picture with its name, its reference's path, and the reference's new state:
/// "is new", "is replaced" or "is removed".
using Accepted = std::function<void(const std::string& name, const std::string& reference,
                                    const char* now)>;

/// Copies results over their references, with the geometry documents next to them, and removes the
/// references of results that are gone. Each is given by its name within the folder of results, or
/// by its path. Changes nothing unless every name is a readable result or a reference. Throws
/// InputError, OutputError.
void accept_results(const std::vector<std::string>& given, const SuiteFolders& folders,
                    const Accepted& accepted);

/// The names of the results without a reference.
std::vector<std::string> results_without_reference(const SuiteFolders& folders);

} // namespace integral

#endif
