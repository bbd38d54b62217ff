// SPDX-License-Identifier: AGPL-3.0-or-later
// A comparison's figures for people.
#ifndef INTEGRAL_COMPARE_FIGURES_TEXT_H
#define INTEGRAL_COMPARE_FIGURES_TEXT_H

#include "integral/compare/compare.h"

#include <string>

namespace integral {

/// Unequal NaN and infinite values, as a fault: "2 pixels differ by NaN or infinite values, the
/// first at 3,4".
std::string unequal_text(const NotFinitePixels& pixels);

/// The lines of FLIP in the table of figures_text.
std::string flip_text(const FlipFigures& flip);

/// A table, a figure in each line.
std::string figures_text(const Comparison& comparison);

} // namespace integral

#endif
