// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/command.h"

#include "integral/base/file_bytes.h"

#include <cstdio>
#include <unistd.h>

namespace integral {

options::variables_map read_arguments(const Command& command, const std::vector<std::string>& words)
{
    options::options_description all = command.make_options();
    all.add_options()("input", options::value<std::vector<std::string>>());
    options::positional_options_description positional;
    positional.add("input", -1);
    namespace style = options::command_line_style;
    options::variables_map arguments;
    try {
        options::store(options::command_line_parser(words)
                           .options(all)
                           .positional(positional)
                           .style(style::unix_style & ~style::allow_guessing)
                           .run(),
                       arguments);
        options::notify(arguments);
    } catch (const options::error& error) {
        throw UsageError(error.what());
    }
    return arguments;
}

std::vector<std::string> inputs_of(const options::variables_map& arguments)
{
    return given(arguments, "input") ? arguments["input"].as<std::vector<std::string>>()
                                     : std::vector<std::string>();
}

std::string text_of(const options::variables_map& arguments, const char* option)
{
    return given(arguments, option) ? arguments[option].as<std::string>() : "";
}

bool given(const options::variables_map& arguments, const char* option)
{
    return arguments.count(option) > 0;
}

int in_range(const options::variables_map& arguments, const char* option, int least, int most)
{
    const int value = arguments[option].as<int>();
    if (value < least || value > most)
        throw UsageError(std::string("--") + option + " " + std::to_string(value) +
                         ": a whole number from " + std::to_string(least) + " to " +
                         std::to_string(most) + " is expected");
    return value;
}

void print_result(const options::variables_map& arguments, const std::string& text)
{
    const std::string output = text_of(arguments, "output");
    write_file(output.empty() ? "-" : output, text);
}

} // namespace integral
