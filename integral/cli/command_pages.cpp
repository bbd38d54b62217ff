// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/command_pages.h"

#include <cctype>
#include <regex>
#include <sstream>

namespace integral {
namespace {

constexpr const char* exit_statuses =
    "0 done; 1 a comparison or check failed, or a batch has failed jobs; 2 wrong usage;\n"
    "3 unreadable or malformed input; 4 the output could not be written; 130 interrupted.\n";

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// Keeps lines that begin with a blank, such as an example of a file, and puts them between `begin`
/// and `end`; applies `rewrite` to all other lines.
template <class Rewrite>
std::string with_examples(const std::string& text, const char* begin, const char* end,
                          const Rewrite& rewrite)
{
    std::string page;
    bool in_example = false;
    for (const std::string& line : lines_of(text)) {
        const bool example = !line.empty() && line[0] == ' ';
        if (example != in_example)
            page += example ? begin : end;
        in_example = example;
        page += (example ? line : rewrite(line)) + "\n";
    }
    return page + (in_example ? end : "");
}

/// Converts prose to Markdown: options become code, and special characters are escaped.
std::string as_markdown(const std::string& text)
{
    static const std::regex special(R"([*<|\\])"),
        option(R"((^|[ (])(--?[a-z][a-z-]*(=[^ ,;)]+)?))");
    return std::regex_replace(std::regex_replace(text, special, R"(\$&)"), option, "$1`$2`");
}

std::string usage_of(const PageCommand& command)
{
    const std::string usage = "integral " + command.name + " " + command.usage;
    return std::regex_replace(usage, std::regex("\n +"), "\n");
}

/// Converts text to roff, in which no line may begin with a dot or an apostrophe.
std::string as_roff(const std::string& text)
{
    std::string roff;
    bool at_line_start = true;
    for (const char c : text) {
        if (at_line_start && (c == '.' || c == '\''))
            roff += "\\&";
        roff += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
        at_line_start = c == '\n';
    }
    return roff;
}

/// Converts prose to roff: an empty line begins a paragraph.
std::string prose_as_roff(const std::string& text)
{
    return with_examples(text, ".PP\n.nf\n", ".fi\n.PP\n", [](const std::string& line) {
        return line.empty() ? std::string(".PP") : as_roff(line);
    });
}

std::string manual_head(const std::string& name, const std::string& summary)
{
    std::string upper;
    for (const char c : name)
        upper += char(std::toupper(static_cast<unsigned char>(c)));
    return ".\\\" Written by `integral help --man`.\n.TH " + upper +
           " 1 \"\" \"povray-integral " PACKAGE_VERSION "\" \"User commands\"\n.SH NAME\n" +
           as_roff(name) + " \\- " + as_roff(summary) + "\n";
}

/// Cases of the completion script, one for each option with a value.
std::string value_cases(const PageCommand& command)
{
    std::string cases;
    for (const PageOption& option : command.options) {
        if (option.value.empty())
            continue;
        static const std::regex files("FILE|FOLDER|FRAME|VIEW|SCENE|DIFFERENCE|DEPTH");
        cases += "        " + option.name + (option.letter.empty() ? "" : "|" + option.letter) +
                 ") ";
        cases += option.name == "--panel"  ? "panels=yes files=yes"
                 : !option.choices.empty() ? "words='" + option.choices + "'"
                 : option.name == "--output" || std::regex_search(option.value, files) ? "files=yes"
                                                                                       : "any=yes";
        cases += " ;;\n";
    }
    return cases;
}

std::string option_words(const PageCommand& command)
{
    std::string words;
    for (const PageOption& option : command.options)
        words += (words.empty() ? "" : " ") + option.name;
    return words;
}

std::string names_of(const PageCommands& commands)
{
    std::string names;
    for (const PageCommand& command : commands)
        names += (names.empty() ? "" : " ") + command.name;
    return names;
}

} // namespace

std::string overview(const PageCommands& commands)
{
    std::ostringstream text;
    text << "Usage: integral COMMAND [options] INPUT... -o OUTPUT\n\n"
            "Takes the micro-image frames of povray-integral to print, panel and eye.\n\n"
            "Commands:\n";
    bool laboratory = false;
    for (const PageCommand& command : commands) {
        if (command.laboratory && !laboratory)
            text << "\nOf the laboratory:\n";
        laboratory = command.laboratory;
        text << "  " << command.name << std::string(12 - command.name.size(), ' ')
             << command.summary << "\n";
    }
    text << "\n`integral help COMMAND` explains one; `integral --version` prints the version.\n\n"
            "Exit status: "
         << exit_statuses;
    return text.str();
}

std::string markdown_head(const PageCommand& command)
{
    std::string page = "<!-- SPDX-License-Identifier: AGPL-3.0-or-later -->\n# integral " +
                       command.name + ": " + as_markdown(command.summary) + "\n\n```text\n" +
                       usage_of(command) + "\n```\n\n" +
                       with_examples(command.description, "\n```text\n", "```\n\n", as_markdown) +
                       "\n| option | does |\n|---|---|\n";
    for (const PageOption& option : command.options) {
        const std::string value = option.value.empty()
                                      ? ""
                                      : " " + std::regex_replace(option.value, std::regex("[|]"),
                                                                 "\\|");
        page += "| `" + (option.letter.empty() ? "" : option.letter + value + "`, `") +
                option.name + value + "` | " + as_markdown(option.description) + " |\n";
    }
    return page + "\n<!-- Above: written by `make command-pages`. Below: by hand. -->\n";
}

std::string manual_page(const PageCommands& commands)
{
    std::string page = manual_head("integral", "takes micro-image frames to print, panel and eye") +
                       ".SH SYNOPSIS\n.B integral\n\\fICOMMAND\\fR [\\fIoption\\fR ...] "
                       "\\fIinput\\fR ...\n.SH COMMANDS\n";
    for (const PageCommand& command : commands)
        page += ".TP\n.BR integral\\-" + as_roff(command.name) + " (1)\n" +
                as_roff(command.summary) + "\n";
    return page +
           ".PP\n\\fBintegral help\\fR \\fICOMMAND\\fR prints what such a page says.\n"
           ".SH \"EXIT STATUS\"\n" +
           as_roff(exit_statuses) + ".SH \"SEE ALSO\"\n.BR povray\\-integral (1)\n";
}

std::string manual_page(const PageCommand& command)
{
    std::string page = manual_head("integral-" + command.name, command.summary) + ".SH SYNOPSIS\n";
    for (const std::string& line : lines_of(usage_of(command)))
        page += ".HP\n" + as_roff(line) + "\n"; // folded, with further lines indented
    page += ".SH DESCRIPTION\n" + prose_as_roff(command.description) + ".SH OPTIONS\n";
    for (const PageOption& option : command.options) {
        const std::string value = option.value.empty() ? ""
                                                       : " \\fI" + as_roff(option.value) + "\\fR";
        page += ".TP\n" +
                (option.letter.empty() ? ""
                                       : "\\fB" + as_roff(option.letter) + "\\fR" + value + ", ") +
                "\\fB" + as_roff(option.name) + "\\fR" + value + "\n" +
                as_roff(option.description) + "\n";
    }
    return page + ".SH \"EXIT STATUS\"\n" + as_roff(exit_statuses) +
           ".SH \"SEE ALSO\"\n.BR integral (1),\n.BR povray\\-integral (1)\n";
}

std::string bash_completion(const PageCommands& commands)
{
    std::string script =
        R"sh(# Completion of the integral program for bash. Written by `integral help --bash`.
_integral()
{
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
    local options= words= panels= files= any=
    COMPREPLY=()
    # bash makes words of --option=value: the option, the sign and the value.
    [ "$word" != = ] || word=
    [ "$before" != = ] || before=${COMP_WORDS[COMP_CWORD-2]}
    if [ "$COMP_CWORD" = 1 ]; then
        words=')sh" +
        names_of(commands) +
        R"sh( help --version'
    elif [ "${COMP_WORDS[1]}" = help ]; then
        words=')sh" +
        names_of(commands) + "'\n    else\n    case ${COMP_WORDS[1]} in\n";
    for (const PageCommand& command : commands)
        script += "    " + command.name + ")\n        options='" + option_words(command) +
                  "'\n        case $before in\n" + value_cases(command) + "        esac ;;\n";
    return script + R"sh(    esac
    [ -z "$panels" ] || words=$("${COMP_WORDS[0]}" lcd --list 2>/dev/null |
        sed -n 's/^\([a-z0-9-]\{1,\}\) .*/\1/p')
    if [ -z "$words$files$any" ]; then
        case $word in -*) words=$options ;; *) files=yes ;; esac
    fi
    fi
    [ -z "$words" ] || COMPREPLY=($(compgen -W "$words" -- "$word"))
    if [ -n "$files" ]; then
        local path
        compopt -o filenames 2>/dev/null
        while IFS= read -r path; do COMPREPLY+=("$path"); done < <(compgen -f -- "$word")
    fi
}
complete -F _integral integral
)sh";
}

} // namespace integral
