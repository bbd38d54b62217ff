// SPDX-License-Identifier: AGPL-3.0-or-later
// Three test cards from which the eye reads pitch, slant and phase of the lenses on a panel.
//
// The eye is at distance D in front of the panel's middle. It sees the film point F through the
// point P of a lens's axis, F = P (1 + t/sqrt(n^2 D^2 + (n^2 - 1) |P|^2)) (optics.md section 4):
// film and sheet differ by a magnification about the middle. The cards are drawn so that they are
// exact on the sheet, that is for P.
//
// The axes are the points with g.P = phase modulo 1. The wave vector g has the length 1/pitch and
// is turned by the slant. Where a bar's lines have the wave vector h, the eye sees the light of the
// place (h - g).P + const in their period: moire bands with the wave vector h - g. A lying bar has
// (h - g).x length bands, and an upright one (h - g).y length. So a lying bar is even if h.x is
// right, and an upright one if h.y is right, whatever the other component is, as long as the bar is
// thin.
#ifndef INTEGRAL_PANEL_LENS_CARDS_H
#define INTEGRAL_PANEL_LENS_CARDS_H

#include "integral/frame/image.h"
#include "integral/sheet/panel.h"

#include <string>
#include <vector>

namespace integral {

/// Errors that the first card allows for.
constexpr double first_pitch_error = 0.01; ///< relative
constexpr double first_slant_error = 1.5;  ///< degrees

constexpr int lens_cards = 3;

/// One step of the procedure. Cards 1 and 2 have a block of lying and a block of upright bars,
/// each bar with another wave vector about that of `panel`. Card 3 has four rows of short bars, at
/// the panel's sides, each bar with another phase.
struct LensCard {
    int number = 1; ///< 1 to lens_cards; more: all are read
    Panel panel;    ///< as the readings so far describe it
    Vec2 error;     ///< bounds of the error of the wave vector's components, 1/mm
};

/// The first card for a panel. Throws std::invalid_argument if its lenses are not lenticular.
LensCard first_lens_card(const Panel& panel);

/// The wave vector of a sheet's lenses, 1/mm.
Vec2 wave_vector(const LensSheet& sheet);

/// The point of the sheet through which an eye in front of the middle sees a film point: the point
/// on the lens's axis, if the film point is in the axis's image.
Vec2 sheet_point_of(Vec2 film_point, const LensSheet& sheet, double distance);

/// A bar of lines. The points with wave.(P - origin) = phase modulo 1 are the middles of light
/// lines.
struct LensBar {
    int number = 0; ///< as printed, from 1
    Vec2 wave;      ///< 1/mm
    Vec2 origin;    ///< mm, on the sheet
    double phase = 0;
    int left = 0, top = 0, width = 0, height = 0; ///< pixels
};

/// Bars that are compared with one another, numbered consecutively.
struct LensBlock {
    std::vector<LensBar> bars;
    bool upright = false;     ///< bars of cards 1 and 2 are upright; else they lie
    bool is_circle = false;   ///< the bar after the last is the first
    double step = 0;          ///< from bar to bar: 1/mm, or on card 3 periods
    double font = 0;          ///< the em of the numbers, mm
    std::vector<Vec2> labels; ///< middles of the numbers, mm from the left and the top: one or two
                              ///< for each bar
};

/// The blocks of a card. Throws std::invalid_argument, with the missing mm, if the panel is too
/// small for bars and numbers that can be read through its lenses.
std::vector<LensBlock> lens_blocks(const LensCard& card);

/// The card's picture, upright, 8 bits, sRGB. Throws as lens_blocks does.
Image lens_card_picture(const LensCard& card);

/// Instructions for the eye that reads a card.
std::string lens_card_advice(const LensCard& card);

} // namespace integral

#endif
