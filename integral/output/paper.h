// SPDX-License-Identifier: AGPL-3.0-or-later
// Sheets of paper by name.
#ifndef INTEGRAL_OUTPUT_PAPER_H
#define INTEGRAL_OUTPUT_PAPER_H

#include <optional>
#include <string>

namespace integral {

/// Upright: width <= height; mm.
struct Paper {
    double width = 0, height = 0;
};

/// The sizes of dye-sublimation and photo papers (inches, as 4x6), A0 to A6, letter, legal, tabloid
/// and postcard (100 x 148 mm), in any case.
std::optional<Paper> paper_named(const std::string& name);

/// Their names, as in "3.5x5, 4x6 and A4".
std::string paper_names();

} // namespace integral

#endif
