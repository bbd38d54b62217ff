// SPDX-License-Identifier: AGPL-3.0-or-later
// The integral program: finds the command, reads its options, and turns errors into exit statuses.
#include "integral/base/file_bytes.h"
#include "integral/base/first_steps.h"
#include "integral/cli/command.h"

#include <cstdio>
#include <iostream>
#include <new>
#include <sstream>

#ifndef PACKAGE_VERSION
#error "PACKAGE_VERSION must be defined, as configure does"
#endif

namespace integral {

const std::vector<const Command*>& all_commands()
{
    static const std::vector<const Command*> commands = {
        &sheet_command,   &replay_command,    &views_command,   &depth_command,   &print_command,
        &lcd_command,     &wireframe_command, &compare_command, &rectify_command, &mask_command,
        &resolve_command, &multiview_command, &tune_command,    &batch_command};
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

std::string overview()
{
    std::ostringstream text;
    text << "Usage: integral COMMAND [options] INPUT... -o OUTPUT\n\n"
            "Takes the micro-image frames of povray-integral to print, panel and eye.\n\n"
            "Commands:\n";
    for (const Command* command : all_commands())
        text << "  " << command->name << std::string(12 - std::string(command->name).size(), ' ')
             << command->summary << "\n";
    text << "\n`integral help COMMAND` explains one; `integral help --man` prints the man "
            "page,\n`integral --version` the version.\n\n"
            "Exit status: 0 done; 1 a comparison or check failed, or a batch has failed jobs; 2 "
            "wrong\n"
            "usage; 3 unreadable or malformed input; 4 the output could not be written; 130 "
            "interrupted.\n";
    return text.str();
}

/// The man page: what `integral help` says of the program and of each command, as roff.
std::string manual_page()
{
    const auto verbatim = [](const std::string& text) {
        std::string roff = ".nf\n";
        bool at_line_start = true;
        for (const char c : text) {
            if (at_line_start && (c == '.' || c == '\''))
                roff += "\\&";
            roff += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
            at_line_start = c == '\n';
        }
        return roff + ".fi\n";
    };
    std::string
        page = ".\\\" Written by `integral help --man`.\n"
               ".TH INTEGRAL 1 \"\" \"povray-integral\" \"User commands\"\n.SH NAME\n"
               "integral \\- takes micro-image frames to print, panel and eye\n.SH DESCRIPTION\n" +
               verbatim(overview());
    for (const Command* command : all_commands())
        page += ".SH \"INTEGRAL " + std::string(command->name) + "\"\n" +
                verbatim(help_for(*command));
    return page + ".SH \"SEE ALSO\"\n.BR povray-integral (1)\n";
}

/// Runs the program; `name` is how errors call it, and becomes that of the command.
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
        std::cout << (words.size() == 1     ? overview()
                      : words[1] == "--man" ? manual_page()
                                            : help_for(*find_command(words[1])));
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
