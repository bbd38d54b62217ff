// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/known_sheets.h"

#include "integral/optics/film.h"

#include <cmath>

namespace integral {
namespace {

constexpr Arrangement lenticular = Arrangement::lenticular, square = Arrangement::square;

/// Lengths in mm.
LensSheet sheet(Arrangement arrangement, double pitch, double thickness, double ior)
{
    LensSheet made;
    made.arrangement = arrangement;
    made.pitch = pitch;
    made.thickness = thickness;
    made.ior = ior;
    return made;
}

} // namespace

const std::vector<KnownSheet>& known_sheets()
{
    static const std::vector<KnownSheet> sheets = {
        {"1270", sheet(lenticular, 1.27, 3.08, 1.6), true},
        {"600", sheet(square, 0.6, 2.65, 1.52), true},
        {"1124", sheet(square, 1.124, 3.23, 1.675), true},
        {"845", sheet(square, 0.845, 2.37, 1.6), true},
        {"625", sheet(square, 0.625, 1.24, 1.6), true},
        {"20_LPI", sheet(lenticular, mm_per_inch / 20, 3.20, 1.59), false},
        {"40_LPI", sheet(lenticular, mm_per_inch / 40, 2.10, 1.49), false},
        {"60_LPI", sheet(lenticular, mm_per_inch / 60, 1.28, 1.56), false},
        {"75_LPI", sheet(lenticular, mm_per_inch / 75, 0.47, 1.57), false},
        {"100_LPI", sheet(lenticular, mm_per_inch / 100, 0.36, 1.57), false},
    };
    return sheets;
}

std::vector<LensSheet> thesis_sheets()
{
    std::vector<LensSheet> sheets;
    for (const KnownSheet& known : known_sheets())
        if (known.of_thesis)
            sheets.push_back(known.sheet);
    return sheets;
}

std::optional<LensSheet> sheet_of_lpi(double lenses_per_inch)
{
    for (const KnownSheet& known : known_sheets())
        if (!known.of_thesis &&
            std::fabs(known.sheet.pitch * lenses_per_inch / mm_per_inch - 1) <= 0.005)
            return known.sheet;
    return std::nullopt;
}

} // namespace integral
