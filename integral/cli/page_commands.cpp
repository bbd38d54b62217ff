// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/page_commands.h"

#include "integral/cli/choices.h"
#include "integral/frame/names.h"
#include "integral/print/paper.h"
#include "integral/sheet/sheet_plots.h"

#include <regex>

namespace integral {
namespace {

/// The words of a table of choices, separated by blanks.
template <class Meaning, std::size_t count>
std::string words_of(const Choice<Meaning> (&choices)[count])
{
    std::string words;
    for (const auto& choice : choices)
        words += std::string(words.empty() ? "" : " ") + choice.word;
    return words;
}

/// The words of a list such as "a, b or c", separated by blanks.
std::string words_in(const std::string& list)
{
    return std::regex_replace(list, std::regex(", | or | and "), " ");
}

/// Keywords that a command's option accepts, separated by blanks; empty if any text is possible. An
/// option whose placeholder lists its keywords (draft|good|best) needs no table row.
std::string choices_of(const std::string& command, const std::string& option,
                       const std::string& value)
{
    static const std::vector<std::pair<const char*, std::string>> known = {
        {"--arrangement KIND", words_in(legal_names<Arrangement>())},
        {"--plot KIND", words_in(sheet_plot_kinds())},
        {"wireframe --lens-model MODEL", words_in(legal_names<LensModel>())},
        {"--lens-model MODEL", words_of(replay_lens_model_choices)},
        {"--lens-mapping RULE", words_in(legal_names<LensMapping>())},
        {"--path KIND[,SPAN]", words_of(path_choices)},
        {"--fit HOW", words_of(fit_choices)},
        {"--orientation WAY", words_of(orientation_choices)},
        {"--centre WHAT", words_of(centre_choices)},
        {"--marks KIND,...", words_of(marks_choices)},
        {"--paper NAME|WxH", words_in(paper_names())},
        {"--intent INTENT", words_of(intent_choices)},
        {"--white WHERE", words_of(white_choices)},
        {"--blend WAY", words_of(neighbours_choices)},
        {"--sampling WAY", words_of(neighbours_choices)},
        {"--card CARD", words_of(card_choices)},
        {"--faces STYLE", words_of(faces_choices)},
        {"--shape KIND", words_of(shape_choices)},
    };
    for (const auto& [name, words] : known)
        if (name == option + " " + value || name == command + " " + option + " " + value)
            return words;
    static const std::regex list("[a-z]+([|][a-z]+)*");
    return std::regex_match(value, list) ? std::regex_replace(value, std::regex("[|]"), " ") : "";
}

PageOption page_option(const std::string& command, const options::option_description& declared)
{
    PageOption option;
    option.name = "--" + declared.long_name();
    const std::string shortest = declared.canonical_display_name(
        options::command_line_style::allow_dash_for_short);
    if (shortest.size() == 2 && shortest[0] == '-') // not a long name of two letters
        option.letter = shortest;
    option.description = declared.description();
    if (declared.semantic()->max_tokens() == 0)
        return option;
    option.value = declared.semantic()->name();
    const std::size_t by_itself = option.value.find(" (=");
    if (by_itself != std::string::npos) {
        const std::string value = option.value.substr(by_itself + 3); // including the parenthesis
        if (option.description.find("default") == std::string::npos) {
            const bool joined = option.description.back() == ')';
            if (joined)
                option.description.pop_back();
            option.description += (joined ? "; default: " : " (default: ") + value;
        }
        option.value.resize(by_itself);
    }
    option.choices = choices_of(command, option.name, option.value);
    return option;
}

} // namespace

PageCommand page_command(const Command& command)
{
    PageCommand page{command.name, command.summary,   command.usage, command.description,
                     {},           command.laboratory};
    const options::options_description declared = command.make_options();
    for (const auto& option : declared.options())
        page.options.push_back(page_option(page.name, *option));
    return page;
}

PageCommands page_commands()
{
    PageCommands pages;
    for (const Command* command : all_commands())
        pages.push_back(page_command(*command));
    return pages;
}

} // namespace integral
