// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/lcd_cards.h"

#include "integral/base/file_bytes.h"
#include "integral/cli/values.h"
#include "integral/panel/lens_readings.h"

#include <cmath>
#include <iostream>

namespace integral {
namespace {

constexpr std::size_t most_bars_read = 100;

/// One --even: the numbers of a card's bars.
std::vector<int> parse_bars(const std::string& text)
{
    constexpr char form[] = "BAR,BAR..., whole numbers of one card, as 7,20,";
    std::vector<int> bars;
    for (const double bar : parse_numbers("even", text, form, 1, most_bars_read)) {
        if (!(bar == std::floor(bar) && std::fabs(bar) < 1e6))
            throw_usage("even", text, form);
        bars.push_back(int(bar));
    }
    return bars;
}

/// The options that all commands of the procedure share.
std::string repeated_options(const LcdOptions& o)
{
    std::string text = "integral lcd --panel " + *o.panel;
    if (o.viewing_distance)
        text += " --viewing-distance " + *o.viewing_distance;
    text += " --card pitch";
    for (const std::string& even : o.even.value_or(std::vector<std::string>()))
        text += " --even " + even;
    return text;
}

/// The figures so far, if any card is read.
std::string figures_of(const LensCard& card) { return card.number > 1 ? lens_report(card) : ""; }

} // namespace

std::optional<LensCard> lens_card_of(const LcdOptions& o, const Panel& panel)
{
    if (panel.sheet.arrangement != Arrangement::lenticular) {
        throw_if_given({{"even", o.even}}, "is for lenticular panels");
        return std::nullopt;
    }
    LensCard card = usage_checked("--card pitch: ", [&] { return first_lens_card(panel); });
    if (o.even)
        for (const std::string& text : *o.even) {
            const std::vector<int> bars = parse_bars(text);
            card = usage_checked("--even " + text + ": ", [&] { return card_after(card, bars); });
        }
    return card;
}

bool writes_panel(const LcdOptions& o, const LensCard& card)
{
    const std::string output = o.output.value_or("");
    const bool is_description = extension_of(output) == "json";
    if (is_description && card.number == 1)
        throw UsageError("-o " + output +
                         ": a panel is described by readings, --even; the first card is a picture, "
                         "as -o card1.png");
    if (!is_description && card.number > lens_cards)
        throw UsageError("--even: all " + std::to_string(lens_cards) +
                         " cards are read; -o FILE.json writes the panel's description");
    if (is_description)
        throw_if_given({{"show", o.show}, {"html", o.html}},
                       "is for cards; -o FILE.json writes a description");
    return is_description;
}

void write_lens_panel(const LcdOptions& o, const LensCard& card)
{
    const std::string output = o.output.value_or("");
    write_file(output, to_json(card.panel));
    if (o.json) {
        std::cout << lens_card_json(card).dump(2) << '\n';
        return;
    }
    std::cout << lens_report(card);
    if (card.number > lens_cards)
        std::cout << "A test: integral lcd --panel " << output << " --card views -o test.png\n"
                  << "The camera's words: integral lcd --panel " << output << " --camera\n";
    else
        std::cout << "Card " << card.number << " would refine this: " << repeated_options(o)
                  << " -o card" << card.number << ".png\n";
}

Json lens_card_json(const LensCard& card)
{
    const LensSheet& sheet = card.panel.sheet;
    Json json = {{"card", card.number},
                 {"pitch_mm", sheet.pitch},
                 {"slant_degrees", sheet.slant},
                 {"offset_mm", {sheet.offset.x, sheet.offset.y}}};
    if (card.number > lens_cards)
        return json;
    Json blocks = Json::array();
    for (const LensBlock& block : lens_blocks(card)) {
        Json bars = Json::array();
        for (const LensBar& bar : block.bars)
            bars.push_back({{"number", bar.number},
                            {"left", bar.left},
                            {"top", bar.top},
                            {"width", bar.width},
                            {"height", bar.height}});
        blocks.push_back({{"upright", block.upright}, {"bars", bars}});
    }
    json["blocks"] = blocks;
    return json;
}

std::string lens_card_text(const LcdOptions& o, const LensCard& card)
{
    const bool last = card.number == lens_cards;
    return figures_of(card) + "Card " + std::to_string(card.number) + " of " +
           std::to_string(lens_cards) + ". " + lens_card_advice(card) + "\n" +
           (last ? "Then: " : "Next card: ") + repeated_options(o) + " --even " +
           (last ? "TOP,BOTTOM,LEFT,RIGHT -o panel.json\n"
                 : "LYING,UPRIGHT -o card" + std::to_string(card.number + 1) + ".png\n");
}

} // namespace integral
