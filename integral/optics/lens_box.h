// SPDX-License-Identifier: AGPL-3.0-or-later
// Limits the lenses that a search tries if the aperture is low or narrow.
#ifndef INTEGRAL_OPTICS_LENS_BOX_H
#define INTEGRAL_OPTICS_LENS_BOX_H

#include "integral/optics/aperture.h"
#include "integral/optics/refraction.h"

#include <algorithm>
#include <cmath>

namespace integral {

/// An upright rectangle of the sheet plane, mm; infinite on an unlimited side.
struct LensBox {
    Vec2 low, high;
};

/// A box around all poles that lie in a square about `centre`, of half-width `radius` (mm) and
/// turned by any angle, and through which a film point's light passes the aperture.
LensBox box_of_passing_poles(const Aperture& aperture, const Medium& medium, Vec2 film_point,
                             Vec2 centre, double radius);

/// Calls visit(LensIndex) as Lattice::for_each_within does, but only for lenses whose poles are in
/// the box, and perhaps for a few just beyond it. Not for lenticular sheets.
template <class Visit>
void for_each_within(const Lattice& lattice, Vec2 centre, double radius, const LensBox& box,
                     Visit visit)
{
    constexpr double margin = 1e-6; // pitches
    const Vec2 step = lattice.pitch() * lattice.across(), offset = lattice.pole({0, 0});
    const double column = dot(lattice.across(), centre - offset) / lattice.pitch(),
                 row = dot(lattice.along(), centre - offset) / lattice.row_spacing(),
                 columns = radius / lattice.pitch() + margin,
                 rows = radius / lattice.row_spacing() + margin;
    for (auto j = std::int64_t(std::ceil(row - rows)); double(j) <= row + rows; ++j) {
        const Vec2 start = lattice.pole({0, j});
        const double shift = lattice.arrangement() == Arrangement::hexagonal && (j & 1) ? 0.5 : 0;
        double first = column - columns - shift, last = column + columns - shift;
        const auto clip = [&](double at, double each, double low, double high) {
            if (each == 0) {
                if (at < low || at > high)
                    last = first - 1;
                return;
            }
            const double one = (low - at) / each, other = (high - at) / each;
            first = std::max(first, std::min(one, other) - margin);
            last = std::min(last, std::max(one, other) + margin);
        };
        clip(start.x, step.x, box.low.x, box.high.x);
        clip(start.y, step.y, box.low.y, box.high.y);
        for (auto i = std::int64_t(std::ceil(first)); double(i) <= last; ++i)
            visit(LensIndex{i, j});
    }
}

} // namespace integral

#endif
