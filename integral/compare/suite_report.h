// SPDX-License-Identifier: AGPL-3.0-or-later
// The outcome of a suite's comparison: as a page, as JSON for programs, as XML for CI systems.
#ifndef INTEGRAL_COMPARE_SUITE_REPORT_H
#define INTEGRAL_COMPARE_SUITE_REPORT_H

#include "integral/compare/suite_pair.h"

namespace integral {

struct Suite {
    SuiteFolders folders;
    std::string tolerances;          ///< the file of tolerances; empty if there is none
    std::vector<SuitePair> pairs;    ///< by name
    std::vector<std::string> unused; ///< tolerances that match no file: "line 3: ..."
    /// HTML, CSS and a script that the pairs' comparators share in the report; empty without any.
    std::string comparator, comparator_style, comparator_script;
    bool passed() const;
};

/// "12 compared, 2 failed, 1 missing": the numbers of pairs of two files, of failed pairs among
/// them, and of files without a counterpart.
std::string suite_summary(const Suite& suite);

/// HTML: a paragraph for each fault.
std::string fault_lines(const std::vector<std::string>& faults);

/// One HTML page: a table, failed pairs first, then the pairs' pictures. `folder` is the folder of
/// the page, for its links to the files; empty: no links.
std::string suite_page(const Suite& suite, const std::string& folder);

/// All outcomes, faults, limits and figures, as a JSON document.
std::string suite_json(const Suite& suite);

/// JUnit's XML: a test case for each pair. A failed one contains `failure`, or `error` for a
/// damaged file.
std::string suite_junit(const Suite& suite);

} // namespace integral

#endif
