// SPDX-License-Identifier: AGPL-3.0-or-later
// What a suite's comparison gave: as a page, for programs, for CI systems.
#ifndef INTEGRAL_COMPARE_SUITE_REPORT_H
#define INTEGRAL_COMPARE_SUITE_REPORT_H

#include "integral/compare/suite_pair.h"

namespace integral {

struct Suite {
    SuiteFolders folders;
    std::string tolerances;          ///< the file of tolerances; empty if there is none
    std::vector<SuitePair> pairs;    ///< by name
    std::vector<std::string> unused; ///< faults of tolerances that no file matches, "line 3: ..."
    bool passed() const;
};

/// "12 compared, 2 failed, 1 missing": pairs of two files, those of them that failed, files without
/// their counterpart.
std::string suite_summary(const Suite& suite);

/// One HTML page: a table, failed pairs first, then their pictures. `folder` is where the page will
/// lie, so that it links to the files themselves; empty: it does not.
std::string suite_page(const Suite& suite, const std::string& folder);

std::string suite_json(const Suite& suite);

/// JUnit's XML: a test case for each pair, `failure` or (a damaged file) `error` in it.
std::string suite_junit(const Suite& suite);

} // namespace integral

#endif
