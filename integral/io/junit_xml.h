// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes JUnit's XML, the form of outcomes that CI systems show.
#ifndef INTEGRAL_IO_JUNIT_XML_H
#define INTEGRAL_IO_JUNIT_XML_H

#include <optional>
#include <string>
#include <vector>

namespace integral {

enum class JUnitOutcome { passed, failure, error, skipped };

/// One test case. The first line of `messages` is its headline.
struct JUnitCase {
    std::string group, name; ///< unique together; CI systems sort by group (JUnit's classname)
    JUnitOutcome outcome = JUnitOutcome::passed;
    std::string type;                  ///< of a failure or error, one word
    std::vector<std::string> messages; ///< unless it passed
    std::optional<double> seconds;     ///< nothing: unknown
    std::string output;                ///< printed text; empty: none
};

/// A document with one suite. The suite has the sum of the seconds if a case has any.
std::string junit_xml(const std::string& suite, const std::vector<JUnitCase>& cases);

} // namespace integral

#endif
