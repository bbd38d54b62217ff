// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes pitch, slant and phase of a panel's lenses from the bars that the eye selects on the
// cards of lens_cards.h.
//
// Cards 1 and 2: the wave vector's component x is that of the lying bar that is even, and y that of
// the upright one. Card 3: a bar of phase f at the place P is the brightest if its light lines are
// on the lenses' axes: f = phase + (h - g).P modulo 1, where h is the wave vector of the lines, and
// g and `phase` belong to the axes. The four rows give four such equations for g and `phase`;
// a fit by least squares solves them.
#ifndef INTEGRAL_PANEL_LENS_READINGS_H
#define INTEGRAL_PANEL_LENS_READINGS_H

#include "integral/panel/lens_cards.h"

namespace integral {

/// The next card, whose panel has what the bars of this card give. `bars`: numbers of one bar from
/// each block, or of neighbours that look the same. After the last card, the sheet's offset is
/// right, too. Throws std::invalid_argument, with one line for the user, if a block has no bar, if
/// bars are no neighbours, and if the readings of card 3 contradict one another.
LensCard card_after(const LensCard& card, const std::vector<int>& bars);

/// The figures so far: pitch, slant and, when all cards are read, the place of an axis, with bounds
/// of their errors that hold if each reading is right to half a step.
std::string lens_report(const LensCard& card);

} // namespace integral

#endif
