// SPDX-License-Identifier: AGPL-3.0-or-later
// For commands that still look their options up in a variables_map. To be deleted with the last of
// them.
#ifndef INTEGRAL_CLI_UNCONVERTED_H
#define INTEGRAL_CLI_UNCONVERTED_H

#include "integral/cli/command.h"

namespace integral {

options::variables_map read_arguments(const Command& command, const Words& words);
Words inputs_of(const options::variables_map& arguments);
std::string text_of(const options::variables_map& arguments, const char* option);
bool given(const options::variables_map& arguments, const char* option);
int in_range(const options::variables_map& arguments, const char* option, int least, int most);
void print_result(const options::variables_map& arguments, const std::string& text);

/// A Command's `run` by a function that takes the variables_map.
template <int (*work)(const options::variables_map&)>
int run_from_map(const Command& command, const Words& words)
{
    const options::variables_map arguments = read_arguments(command, words);
    CommonOptions read;
    read.inputs = inputs_of(arguments);
    read.help = given(arguments, "help");
    return help_is_given(command, read) ? int(exit_done) : work(arguments);
}

/// A group of options that several commands have, out of a variables_map.
template <class Group> Group read_group(const options::variables_map& arguments)
{
    Group read;
    options::options_description all;
    declare(all, read);
    for (const auto& option : all.options())
        if (arguments.count(option->long_name()))
            option->semantic()->notify(arguments[option->long_name()].value());
    return read;
}

} // namespace integral

#endif
