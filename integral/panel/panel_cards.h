// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes test cards for panels, most of them as views, which the caller interlaces.
#ifndef INTEGRAL_PANEL_PANEL_CARDS_H
#define INTEGRAL_PANEL_PANEL_CARDS_H

#include "integral/frame/image.h"
#include "integral/sheet/panel.h"

#include <optional>
#include <vector>

namespace integral {

/// Views that show their own numbers in black, each on another colour. `aspect`: the panel's width
/// divided by its height. All cards have 8 bits and are encoded as sRGB.
std::vector<Image> view_number_card(int count, double aspect);

/// The background colour of a view in view_number_card.
Colour view_number_colour(int view, int count);

/// View `lit` is white; without `lit`, every other view is white, beginning with the first. The
/// other views are black: white that an eye sees at their positions is the display's crosstalk.
std::vector<Image> crosstalk_card(int count, std::optional<int> lit);

/// View `lit` shows four bands, red, green, blue and white from the top; the other views are black.
/// If the panel's description gives the right subpixels, a moving eye sees all bands light up at
/// the same time, and the white band without colours.
std::vector<Image> colour_card(int count, int lit);

/// For lenses of any arrangement; lens_cards.h has better cards for lenticular ones.
/// Bars of lines, each bar with another pitch, about the pitch that the panel's micro-images should
/// have. The bar that looks even, without light and dark bands, has the right pitch; from bar to
/// bar, the number of bands changes by a quarter. The picture is upright, as the viewer sees it.
/// Throws std::invalid_argument if the panel is too coarse or too small.
Image pitch_card(const Panel& panel);

} // namespace integral

#endif
