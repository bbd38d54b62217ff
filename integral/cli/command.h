// SPDX-License-Identifier: AGPL-3.0-or-later
// Defines the commands of the integral program and how they read their command lines.
//
// 1. A command's options are a plain struct, derived from CommonOptions, with its defaults in
//    place. It contains the values on the line: text, whole numbers, switches; std::optional if it
//    matters whether an option was given.
// 2. A function declare(description, struct) next to the struct adds each option, with its field
//    and its help. Options that several commands share form a struct with its own declare
//    (geometry_options.h). The structs of those commands have that struct as a member.
// 3. The command's run(struct) turns text into the plain structs of the rooms (View, PageRequest),
//    rejects nonsense with UsageError, makes one call of a room, and writes files and figures.
//    std::invalid_argument from a room is reported as a UsageError.
//
// So no command looks an option up by its name. Boost's variables_map, its table of the options on
// a line, exists only between reading the line and filling the struct (command.cpp).
#ifndef INTEGRAL_CLI_COMMAND_H
#define INTEGRAL_CLI_COMMAND_H

#include "integral/base/interrupt.h"
#include "integral/base/message_text.h"

#include <boost/program_options.hpp>

#include <optional>
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

/// The command line makes no sense. The text is one line, for standard error.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Calls `work` and turns std::invalid_argument from a room into a UsageError whose message begins
/// with `place`.
template <class Work> auto usage_checked(const std::string& place, const Work& work)
{
    try {
        return work();
    } catch (const std::invalid_argument& error) {
        throw UsageError(place + error.what());
    }
}

/// The words of a line that follow the command's name.
using Arguments = std::vector<std::string>;

/// Options of every command.
struct CommonOptions {
    Arguments inputs; ///< in order
    bool help = false;
};

/// One command. The help consists of these texts and the options' own descriptions.
struct Command {
    const char* name;
    const char* summary;     ///< one line, for `integral help`
    const char* usage;       ///< the part after the name
    const char* description; ///< lines of at most 80 columns
    int least_inputs, most_inputs;
    /// The options with their descriptions, for the help: described<STRUCT>.
    options::options_description (*make_options)();
    /// Reads the words and does the work: run_with<STRUCT, run>. Returns an ExitStatus; throws
    /// UsageError, InputError, OutputError or Interrupted.
    int (*run)(const Command& command, const Arguments& words);
    bool laboratory = false; ///< of the optical laboratory; listed last by `help`
};

extern const Command studio_command, sheet_command, replay_command, views_command, flip_command,
    layers_command, combine_command, print_command, lcd_command, depth_command, compare_command,
    tune_command, batch_command, wireframe_command, rectify_command, mask_command, resolve_command,
    multiview_command;

/// Every command, in the order of `integral help`.
const std::vector<const Command*>& all_commands();

/// The text of `integral help COMMAND`.
std::string help_for(const Command& command);

/// For a declare function: an option that fills a field. `word` names its value in the help.
template <class T> options::typed_value<T>* fills(T& field, const char* word)
{
    return options::value<T>(&field)->value_name(word);
}

/// The same for a field that stays empty if the option is not given.
template <class T> options::typed_value<T>* fills(std::optional<T>& field, const char* word)
{
    return options::value<T>()->value_name(word)->notifier(
        [&field](const T& read) { field = read; });
}

/// For a declare function: adds an option whose value fills a field.
template <class T>
void add(options::options_description& all, const char* name, T& field, const char* word,
         const char* help)
{
    all.add_options()(name, fills(field, word), help);
}

/// The same for an option without a value, which sets the field true.
inline void add(options::options_description& all, const char* name, bool& field, const char* help)
{
    all.add_options()(name, options::bool_switch(&field), help);
}

/// --help, which every command has as its last option.
void declare_help(options::options_description& all, CommonOptions& read);

/// Options that the program passes to itself, hidden from the help: a command with such options
/// overloads this for its own struct.
inline void declare_internal(options::options_description&, CommonOptions&) {}

/// Reads words into the fields named by `described`; other words become inputs. Throws UsageError
/// for unknown options and values of the wrong kind.
void read_words(const options::options_description& described, const Arguments& words,
                Arguments& inputs);

/// Prints the help, if the line requests it, and returns true. Throws UsageError for too few or too
/// many inputs.
bool help_is_given(const Command& command, const CommonOptions& read);

/// Descriptions of the options whose values are read into the struct Options, for a command's help.
template <class Options> options::options_description described()
{
    Options unused; // its fields are named by the descriptions, but never filled
    options::options_description all("Options");
    declare(all, unused);
    declare_help(all, unused);
    return all;
}

/// A command's struct, filled from the words of its line. Throws as read_words does.
template <class Options> Options read_options(const Arguments& words)
{
    Options read;
    options::options_description all("Options");
    declare(all, read);
    declare_help(all, read);
    declare_internal(all, read);
    read_words(all, words, read.inputs);
    return read;
}

/// A Command's `run`: reads the words into the command's struct and calls `work` with it.
template <class Options, int (*work)(const Options&)>
int run_with(const Command& command, const Arguments& words)
{
    const Options read = read_options<Options>(words);
    return help_is_given(command, read) ? int(exit_done)
                                        : usage_checked("", [&] { return work(read); });
}

/// Prints figures to standard output, or to standard error if a picture or report takes standard
/// output.
void print_figures(const std::string& text, bool output_is_taken);

/// Prints a result to standard output, or atomically to -o's FILE. Throws OutputError.
void print_result(const std::optional<std::string>& output, const std::string& text);

} // namespace integral

#endif
