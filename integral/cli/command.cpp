// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/command.h"

#include "integral/base/file_bytes.h"

#include <iostream>
#include <sstream>

namespace integral {
namespace {

/// Parses the words of a line, without filling any field yet.
options::variables_map parsed(const options::options_description& described, const Arguments& words)
{
    options::options_description all = described;
    all.add_options()("input", options::value<Arguments>());
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
    } catch (const options::error& error) {
        throw UsageError(error.what());
    }
    return arguments;
}

} // namespace

void declare_help(options::options_description& all, CommonOptions& read)
{
    add(all, "help", read.help, "print this");
}

void read_words(const options::options_description& described, const Arguments& words,
                Arguments& inputs)
{
    options::variables_map arguments = parsed(described, words);
    options::notify(arguments); // fills the fields
    if (arguments.count("input"))
        inputs = arguments["input"].as<Arguments>();
}

bool help_is_given(const Command& command, const CommonOptions& read)
{
    if (read.help) {
        std::cout << help_for(command);
        return true;
    }
    const int inputs = int(read.inputs.size());
    if (inputs < command.least_inputs || inputs > command.most_inputs)
        throw UsageError(std::string(inputs < command.least_inputs ? "an input is missing"
                                                                   : "there are too many inputs") +
                         "; usage: integral " + command.name + " " + command.usage);
    return false;
}

std::string help_for(const Command& command)
{
    std::ostringstream text;
    text << "Usage: integral " << command.name << " " << command.usage << "\n\n"
         << command.description << "\n"
         << command.make_options();
    return text.str();
}

void print_figures(const std::string& text, bool output_is_taken)
{
    if (output_is_taken)
        std::cerr << text << std::flush;
    else
        write_file("-", text);
}

void print_result(const std::optional<std::string>& output, const std::string& text)
{
    write_file(output && !output->empty() ? *output : "-", text);
}

} // namespace integral
