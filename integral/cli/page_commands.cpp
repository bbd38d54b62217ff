// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/page_commands.h"

#include <regex>

namespace integral {
namespace {

/// The words that an option of a command may be given, separated by blanks; empty where any text is
/// possible. Where the value's word lists them itself (draft|good|best), no row of the table is
/// needed.
std::string choices_of(const std::string& command, const std::string& option,
                       const std::string& value)
{
    static const std::vector<std::pair<const char*, const char*>> known = {
        {"--arrangement KIND", "lenticular square hexagonal"},
        {"--plot KIND", "spread lens sheets resolution pixels-seen pixel-spread film"},
        {"wireframe --lens-model MODEL", "extended_pinhole pinhole hybrid full"},
        {"--lens-model MODEL", "extended_pinhole pinhole full"},
        {"--lens-mapping RULE", "auto closest accurate exhaustive"},
        {"--path KIND[,SPAN]", "turntable sweep sway circle dolly"},
        {"--orientation WAY", "portrait landscape auto"},
        {"--centre WHAT", "lens picture"},
        {"--marks KIND,...", "crop registration axis all"},
        {"--paper NAME|WxH", "4x6 6x8 5x7 8x10 A4 A6 letter postcard"},
        {"--intent INTENT", "perceptual relative saturation absolute"},
        {"--blend WAY", "linear nearest"},
        {"--sampling WAY", "linear nearest"},
        {"--card CARD", "views crosstalk colours pitch"},
        {"--faces STYLE", "wire hidden flat"},
        {"--shape KIND", "spherical aspheric"},
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
    if (shortest != option.name && shortest.size() == 2)
        option.letter = shortest;
    option.description = declared.description();
    if (declared.semantic()->max_tokens() == 0)
        return option;
    option.value = declared.semantic()->name();
    const std::size_t by_itself = option.value.find(" (=");
    if (by_itself != std::string::npos) {
        const std::string value = option.value.substr(by_itself + 3); // with the parenthesis
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
    PageCommand page{command.name, command.summary, command.usage, command.description, {}};
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
