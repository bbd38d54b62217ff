// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares a suite of pictures with their references: finds the pairs and their tolerances, and
// compares all of them.
#ifndef INTEGRAL_COMPARE_SUITE_RUN_H
#define INTEGRAL_COMPARE_SUITE_RUN_H

#include "integral/base/parallel.h"
#include "integral/compare/suite_report.h"

#include <optional>
#include <set>
#include <string>

namespace integral {

/// The suite's two folders. `references` is by default the folder of that name next to `results`.
/// Throws InputError where one of them is no folder, std::invalid_argument where they are the same.
/// `may_be_new`: the references may be missing, as they are about to be made.
SuiteFolders suite_folders(const std::string& results, const std::optional<std::string>& references,
                           bool may_be_new);

/// The pictures in a folder and in the folders below it, by their paths relative to it. Hidden
/// files and folders are left out, and so is the folder `other`. Throws InputError.
std::set<std::string> pictures_in(const std::string& folder, const std::string& other);

/// The references, as pictures_in; none where their folder is still to be made.
std::set<std::string> references_in(const SuiteFolders& folders);

struct SuiteTolerances {
    Tolerances tolerances;
    std::string file; ///< their document; empty: there are none
};

/// Reads the tolerances of `file`; by default of suite.json among the references, if it is there.
/// Throws InputError.
SuiteTolerances read_tolerances(const SuiteFolders& folders,
                                const std::optional<std::string>& file);

/// All pairs of the two folders with their limits, not yet compared. Throws InputError where there
/// is no picture.
Suite suite_of(const SuiteFolders& folders, const SuiteTolerances& limits);

/// Compares all pairs, `threads` at a time (0: one per core). Returns false if `progress` stopped
/// the work.
bool compare_suite(Suite& suite, const SuitePictures& pictures, const CompareSeen& compare_seen,
                   int threads, const Progress& progress = {});

} // namespace integral

#endif
