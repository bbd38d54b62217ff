// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/junit_xml.h"

#include "integral/base/number_text.h"
#include "integral/io/markup.h"

#include <algorithm>

namespace integral {
namespace {

std::string attribute(const char* name, const std::string& value)
{
    return std::string(" ") + name + "=\"" + markup_text(value) + "\"";
}

std::string time_attribute(const std::optional<double>& seconds)
{
    return seconds ? attribute("time", with_decimals(*seconds, 3)) : "";
}

const char* element_of(JUnitOutcome outcome)
{
    return outcome == JUnitOutcome::failure ? "failure"
           : outcome == JUnitOutcome::error ? "error"
                                            : "skipped";
}

std::string outcome_xml(const JUnitCase& one)
{
    const char* const element = element_of(one.outcome);
    std::string all;
    for (const std::string& message : one.messages)
        all += (all.empty() ? "" : "\n") + message;
    std::string xml = std::string("      <") + element;
    if (one.outcome != JUnitOutcome::skipped)
        xml += attribute("type", one.type);
    if (!one.messages.empty())
        xml += attribute("message", one.messages.front());
    return xml + ">" + markup_text(all) + "</" + element + ">\n";
}

std::string case_xml(const JUnitCase& one)
{
    std::string inside;
    if (one.outcome != JUnitOutcome::passed)
        inside += outcome_xml(one);
    if (!one.output.empty())
        inside += "      <system-out>" + markup_text(one.output) + "</system-out>\n";
    const std::string head = "    <testcase" + attribute("classname", one.group) +
                             attribute("name", one.name) + time_attribute(one.seconds);
    return head + (inside.empty() ? "/>\n" : ">\n" + inside + "    </testcase>\n");
}

} // namespace

std::string junit_xml(const std::string& suite, const std::vector<JUnitCase>& cases)
{
    const auto number = [&](JUnitOutcome outcome) {
        return std::to_string(std::count_if(cases.begin(), cases.end(), [&](const JUnitCase& one) {
            return one.outcome == outcome;
        }));
    };
    std::optional<double> seconds;
    std::string inside;
    for (const JUnitCase& one : cases) {
        if (one.seconds)
            seconds = seconds.value_or(0) + *one.seconds;
        inside += case_xml(one);
    }
    const std::string figures = attribute("tests", std::to_string(cases.size())) +
                                attribute("failures", number(JUnitOutcome::failure)) +
                                attribute("errors", number(JUnitOutcome::error)) +
                                attribute("skipped", number(JUnitOutcome::skipped)) +
                                time_attribute(seconds);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + figures + ">\n  <testsuite" +
           attribute("name", suite) + figures + ">\n" + inside + "  </testsuite>\n</testsuites>\n";
}

} // namespace integral
