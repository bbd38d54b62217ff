// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/lens_sheet.h"

#include "integral/base/constants.h"

namespace integral {

namespace {

constexpr double hexagonal_row_spacing = 0.86602540378443864676; // sqrt(3)/2 pitches

std::int64_t round_to_index(double value)
{
    return static_cast<std::int64_t>(nearest_integer(value));
}

/// The unit vector along the lens rows. At 90 degrees it is exactly along y, as the cosine of the
/// double nearest to pi/2 is not 0.
Vec2 row_direction(double slant)
{
    if (std::fabs(slant) == 90)
        return {0, std::copysign(1.0, slant)};
    return {std::cos(slant * radians_per_degree), std::sin(slant * radians_per_degree)};
}

} // namespace

double surface_radius(const LensSheet& sheet)
{
    return sheet.thickness * (sheet.ior - 1) / sheet.ior;
}

Lattice::Lattice(const LensSheet& sheet)
    : arrangement_(sheet.arrangement),
      pitch_(sheet.pitch),
      row_spacing_(sheet.arrangement == Arrangement::hexagonal ? hexagonal_row_spacing * sheet.pitch
                                                               : sheet.pitch),
      across_(row_direction(sheet.slant)),
      along_{-across_.y, across_.x},
      offset_(sheet.offset)
{
}

double Lattice::distance(Vec2 point, LensIndex lens) const
{
    const Vec2 to_pole = pole(lens) - point;
    return arrangement_ == Arrangement::lenticular ? std::fabs(dot(across_, to_pole))
                                                   : length(to_pole);
}

bool Lattice::preferred(LensIndex a, LensIndex b) const
{
    const double nearer = distance({0, 0}, a) - distance({0, 0}, b);
    if (std::fabs(nearer) > tie_tolerance())
        return nearer < 0;
    const Vec2 difference = pole(a) - pole(b);
    if (std::fabs(difference.x) > tie_tolerance())
        return difference.x < 0;
    return difference.y < 0;
}

LensIndex Lattice::settle_tie(Vec2 point, LensIndex guess) const
{
    double least = distance(point, guess);
    const double reach = least + tie_tolerance();
    for_each_within(point, reach,
                    [&](LensIndex lens) { least = std::fmin(least, distance(point, lens)); });
    LensIndex best = guess;
    bool found = distance(point, guess) <= least + tie_tolerance();
    for_each_within(point, reach, [&](LensIndex lens) {
        if (distance(point, lens) <= least + tie_tolerance() && (!found || preferred(lens, best))) {
            best = lens;
            found = true;
        }
    });
    return best;
}

LensIndex Lattice::nearest_of_shifted_rows(Vec2 point) const
{
    const Vec2 p = lattice_from_sheet(point);
    // The nearest pole is in one of the two rows that enclose the point.
    const double row = p.y / row_spacing_;
    const std::int64_t near = round_to_index(row), lower = near - (static_cast<double>(near) > row);
    LensIndex guess[2];
    double distance_squared[2];
    bool tie = false;
    for (int k = 0; k < 2; ++k) {
        const std::int64_t j = lower + k;
        const double shift = j & 1 ? 0.5 : 0.0, u = p.x / pitch_ - shift;
        guess[k] = {round_to_index(u), j};
        const Vec2 away{p.x - (static_cast<double>(guess[k].i) + shift) * pitch_,
                        p.y - static_cast<double>(j) * row_spacing_};
        distance_squared[k] = dot(away, away);
        tie = tie || std::fabs(u - nearest_integer(u)) > 0.5 - border_margin;
    }
    const double difference = distance_squared[0] - distance_squared[1];
    const LensIndex nearer = guess[difference <= 0 ? 0 : 1];
    return tie || std::fabs(difference) < border_margin * pitch_ * pitch_
               ? settle_tie(point, nearer)
               : nearer;
}

} // namespace integral
