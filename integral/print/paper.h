// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds sheets of paper by name.
#ifndef INTEGRAL_PRINT_PAPER_H
#define INTEGRAL_PRINT_PAPER_H

#include "integral/optics/film.h"

#include <optional>
#include <string>

namespace integral {

/// A sheet, mm. Named sheets are upright: width <= height. A height of 0 means a roll; a page
/// takes as much of its length as it needs.
struct Paper {
    double width = 0, height = 0;
};

inline bool is_roll(const Paper& paper) { return paper.height == 0; }

/// The paper of a name, in small or capital letters: sizes of dye-sublimation and photo papers in
/// inches (4x6), A0 to A6, letter, legal, tabloid, postcard (100 x 148 mm), and press sheets (B1 to
/// B3, SRA3, SRA4). Empty for other names.
std::optional<Paper> paper_named(const std::string& name);

/// A named sheet as it is fed for a film: upright, or turned if the film is wide.
Paper paper_for(Paper named, const Film& film);

/// All names, for messages and completion: "3.5x5, 4x6 and SRA4".
std::string paper_names();

} // namespace integral

#endif
