// SPDX-License-Identifier: AGPL-3.0-or-later
// The integral program: finds the command, reads its options, and turns errors into exit statuses.
#include "integral/base/file_bytes.h"
#include "integral/base/first_steps.h"
#include "integral/base/notices.h"
#include "integral/cli/page_commands.h"

#include <cstdio>
#include <iostream>
#include <new>

#ifndef PACKAGE_VERSION
#error "PACKAGE_VERSION must be defined, as configure does"
#endif

namespace integral {

const std::vector<const Command*>& all_commands()
{
    static const std::vector<const Command*> commands = {
        &studio_command,  &sheet_command,   &replay_command,   &views_command,     &flip_command,
        &layers_command,  &combine_command, &print_command,    &lcd_command,       &depth_command,
        &compare_command, &tune_command,    &batch_command,    &wireframe_command, &rectify_command,
        &mask_command,    &resolve_command, &multiview_command};
    return commands;
}

namespace {

const Command* find_command(const std::string& name)
{
    for (const Command* command : all_commands())
        if (name == command->name)
            return command;
    std::string names;
    for (const Command* command : all_commands())
        names += std::string(names.empty() ? "" : ", ") + command->name;
    throw UsageError("there is no command " + name + "; there are: " + names + " (integral help)");
}

/// The text of `integral help WORDS...`. --man, --markdown and --bash are for the build, which uses
/// them to write man pages, manual pages and bash completion.
std::string help_about(const std::vector<std::string>& words)
{
    const std::string what = words.empty() ? "" : words[0];
    if (what.empty())
        return overview(page_commands());
    if (what == "--bash")
        return bash_completion(page_commands());
    if (what == "--man" && words.size() == 1)
        return manual_page(page_commands());
    if (what == "--man" || (what == "--markdown" && words.size() > 1)) {
        const PageCommand command = page_command(*find_command(words[1]));
        return what == "--man" ? manual_page(command) : markdown_head(command);
    }
    return help_for(*find_command(what));
}

/// Runs the program. `name` is the prefix of errors; it becomes the command's name.
int run_program(const std::vector<std::string>& words, std::string& name)
{
    if (words.empty()) {
        std::cout << first_steps();
        return exit_done;
    }
    if (words[0] == "--version") {
        std::cout << "integral " PACKAGE_VERSION "\n"
                     "License AGPL-3.0-or-later. There is no warranty.\n";
        return exit_done;
    }
    if (words[0] == "help" || words[0] == "--help" || words[0] == "-h") {
        std::cout << help_about({words.begin() + 1, words.end()});
        return exit_done;
    }
    const Command& command = *find_command(words[0]);
    name += std::string(" ") + command.name;
    return command.run(command, {words.begin() + 1, words.end()});
}

int guarded(const std::vector<std::string>& words)
{
    std::string name = "integral";
    const auto complain = [&](const std::string& what, int status) {
        std::cerr << name << ": " << one_line(what) << "\n";
        return status;
    };
    receive_notices([&](const std::string& what) { std::cerr << name << ": " << what << "\n"; });
    try {
        const int status = run_program(words, name);
        if (!std::cout.flush())
            throw OutputError("standard output: cannot be written");
        return status;
    } catch (const UsageError& error) {
        const bool has_help = name != "integral" &&
                              std::string(error.what()).find(';') == std::string::npos;
        return complain(error.what() + (has_help ? "; see integral help" + name.substr(8) : ""),
                        exit_usage);
    } catch (const InputError& error) {
        return complain(error.what(), exit_input);
    } catch (const OutputError& error) {
        return complain(error.what(), exit_output);
    } catch (const Interrupted& error) {
        return complain(error.what(), exit_interrupted);
    } catch (const std::bad_alloc& error) {
        return complain(reason_of(error), exit_input);
    } catch (const std::exception& error) {
        return complain(std::string("internal error: ") + error.what(), exit_check_failed);
    }
}

} // namespace
} // namespace integral

int main(int count, char** words)
{
    integral::catch_interrupts();
    return integral::guarded({words + 1, words + count});
}
