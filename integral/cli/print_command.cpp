// SPDX-License-Identifier: AGPL-3.0-or-later
// integral print: so far pitch charts alone.
#include "integral/cli/print_chart.h"

namespace integral {
namespace {

options::options_description make_options()
{
    options::options_description all("Options");
    all.add_options()
        ("sheet", options::value<std::string>()->value_name("FILE.json"), "start from this geometry: a JSON document, or a frame")
        ("json", "print figures as JSON")
        ("output,o", options::value<std::string>()->value_name("FILE"), "the page (.png or .tiff), or with --even the sheet's file")
        ("help", "print this");
    add_chart_options(all);
    return all;
}

int run(const options::variables_map& arguments)
{
    if (!is_chart(arguments))
        throw UsageError("--chart or --even is expected");
    return make_chart(arguments);
}

} // namespace

const Command print_command = {
    "print", "pitch charts for lens sheets", "--chart [--sheet FILE.json] ... -o FILE | --even BARS@MM --pitch-range A,B --bars N ...",
    "Makes a chart that tells a lens sheet's pitch, and reads it.\n", 0, 1, make_options, run};

} // namespace integral
