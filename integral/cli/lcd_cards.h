// SPDX-License-Identifier: AGPL-3.0-or-later
// The cards of integral lcd --card pitch and their readings, --even.
#ifndef INTEGRAL_CLI_LCD_CARDS_H
#define INTEGRAL_CLI_LCD_CARDS_H

#include "integral/base/json.h"
#include "integral/cli/lcd_options.h"

namespace integral {

/// The card that follows the readings of --even; nothing if --card pitch makes a chart of pitches,
/// which is for lenses that are not lenticular. Throws UsageError for readings that make no sense.
std::optional<LensCard> lens_card_of(const LcdOptions& o, const Panel& panel);

/// Whether -o's file is the description of the panel that the readings give, not a card. Throws
/// UsageError if there is no reading, or no further card.
bool writes_panel(const LcdOptions& o, const LensCard& card);

/// Writes the panel's description to -o's file, and prints the figures and what to do next.
void write_lens_panel(const LcdOptions& o, const LensCard& card);

/// Figures and bars of a card, for programs.
Json lens_card_json(const LensCard& card);

/// The figures so far, what to look for on a card, and the command that takes the reading.
std::string lens_card_text(const LcdOptions& o, const LensCard& card);

} // namespace integral

#endif
