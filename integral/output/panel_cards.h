// SPDX-License-Identifier: AGPL-3.0-or-later
// Test cards for panels: the views of which they are interlaced.
#ifndef INTEGRAL_OUTPUT_PANEL_CARDS_H
#define INTEGRAL_OUTPUT_PANEL_CARDS_H

#include "integral/lightfield/image.h"
#include "integral/output/panel.h"

#include <optional>
#include <vector>

namespace integral {

/// Each view its number, in black on a colour of its own. `aspect`: the panel's width by its
/// height. 8 bits, sRGB, as all cards.
std::vector<Image> view_number_card(int count, double aspect);

/// The colour of a view of that card.
Colour view_number_colour(int view, int count);

/// White: view `lit`, or without it every other one from the first on. The others are black, and
/// what an eye sees of white in their places is the display's crosstalk.
std::vector<Image> crosstalk_card(int count, std::optional<int> lit);

/// Four bands in view `lit`, red, green, blue and white from the top; the others black. Where a
/// panel's subpixels are taken to lie as they do, an eye that moves sees the bands light up
/// together and the white one without colours.
std::vector<Image> colour_card(int count, int lit);

/// Bars of lines of pitches about that which the panel's micro-images should have, in steps of
/// which neighbours differ by a quarter of a band along a bar: the even one tells. Upright, as the
/// viewer sees it. Throws std::invalid_argument where the panel is too coarse or small.
Image pitch_card(const Panel& panel);

} // namespace integral

#endif
