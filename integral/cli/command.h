// SPDX-License-Identifier: AGPL-3.0-or-later
// What a command of the integral program is, and the conventions that all of them share.
#ifndef INTEGRAL_CLI_COMMAND_H
#define INTEGRAL_CLI_COMMAND_H

#include "integral/base/interrupt.h"
#include "integral/base/message_text.h"

#include <boost/program_options.hpp>

#include <stdexcept>
#include <string>
#include <vector>

namespace integral {

namespace options = boost::program_options;

enum ExitStatus {
    exit_done = 0,
    exit_check_failed = 1, ///< a comparison or check failed
    exit_usage = 2,
    exit_input = 3,         ///< unreadable or malformed input
    exit_output = 4,        ///< the output could not be written
    exit_interrupted = 130, ///< as a shell reports SIGINT
};

/// The command line makes no sense. One line, for standard error.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// One command. All that help says is here or in the options' own descriptions.
struct Command {
    const char* name;
    const char* summary;     ///< one line, for `integral help`
    const char* usage;       ///< what follows the name
    const char* description; ///< what it does, in lines of at most 80 columns
    int least_inputs, most_inputs;
    options::options_description (*make_options)();
    /// Does the work: returns an ExitStatus or throws one of the errors above, InputError or
    /// OutputError.
    int (*run)(const options::variables_map&);
};

extern const Command sheet_command, replay_command, views_command, print_command, lcd_command,
    compare_command, rectify_command, batch_command;

/// Every command, in the order in which `integral help` lists them.
const std::vector<const Command*>& all_commands();

/// Reads the words of a command's line. Throws UsageError for options that it does not have, and
/// for values of another kind.
options::variables_map read_arguments(const Command& command,
                                      const std::vector<std::string>& words);

/// The inputs of a command line, in order.
std::vector<std::string> inputs_of(const options::variables_map& arguments);

/// The value of a string option, or "" if it was not given.
std::string text_of(const options::variables_map& arguments, const char* option);

/// Whether an option was given.
bool given(const options::variables_map& arguments, const char* option);

/// The value of an option that is a whole number. Throws UsageError where it is not from `least` to
/// `most`.
int in_range(const options::variables_map& arguments, const char* option, int least, int most);

/// Prints a result to standard output, or to -o's FILE whole. Throws OutputError.
void print_result(const options::variables_map& arguments, const std::string& text);

} // namespace integral

#endif
