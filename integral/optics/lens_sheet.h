// SPDX-License-Identifier: AGPL-3.0-or-later
// The lens sheet: its parameters, and the lattice of its lenses.
//
// Sheet frame, everywhere in integral/: millimetres; origin at the sheet's centre on the plane
// of the lens poles; +x to the viewer's right, +y up, +z away from the viewer into the scene.
// The viewer is at z < 0, the film at z = +thickness inside the medium.
#ifndef INTEGRAL_OPTICS_LENS_SHEET_H
#define INTEGRAL_OPTICS_LENS_SHEET_H

#include "integral/optics/vec.h"

#include <cstdint>

namespace integral {

enum class Arrangement { lenticular, square, hexagonal };

/// A sheet of equal lenses over a film at their paraxial focus. Lengths in mm.
struct LensSheet {
    Arrangement arrangement = Arrangement::lenticular;
    double pitch = 1.27;     ///< p, between the axes of neighbouring lenses; > 0
    double thickness = 3.08; ///< t, from the pole to the film; > 0
    double ior = 1.6;        ///< n of the medium; >= 1
    double slant = 0;        ///< degrees, anticlockwise as the viewer sees it; -90 to 90
    Vec2 offset;             ///< of the lens at index (0, 0), along the sheet frame's x and y
};

/// Radius of the spherical (cylindrical) surface whose paraxial focus is the film: t (n - 1)/n.
double surface_radius(const LensSheet& sheet);

/// Index of a lens: column i of row j. A lenticular sheet has i alone (j = 0).
struct LensIndex {
    std::int64_t i = 0, j = 0;
    friend bool operator==(LensIndex a, LensIndex b) { return a.i == b.i && a.j == b.j; }
    friend bool operator!=(LensIndex a, LensIndex b) { return !(a == b); }
};

/// The unbounded lattice of a sheet's poles (axis lines, for a lenticular sheet). Distances that
/// differ by less than 1e-9 pitch count as equal. Among equally distant lenses, the one nearest to
/// the sheet's centre is preferred; then the one of least x, then of least y.
class Lattice {
public:
    explicit Lattice(const LensSheet& sheet);

    /// Pole of a lens in the sheet frame. Lenticular: the axis's point nearest to `offset`.
    Vec2 pole(LensIndex lens) const;

    /// Direction along the lens rows (for a lenticular sheet: across the axes), a unit vector.
    Vec2 across() const { return across_; }
    /// Anticlockwise perpendicular of across(): a lenticular sheet's axis direction.
    Vec2 along() const { return along_; }

    /// The lens whose pole (axis) is nearest to a point of the sheet plane: the closest-wins
    /// rule, thesis (3-11).
    LensIndex nearest(Vec2 point) const
    {
        return arrangement_ == Arrangement::hexagonal ? nearest_of_shifted_rows(point)
                                                      : nearest_of_even_rows(point);
    }

    /// Distance from a point to a lens's pole (axis).
    double distance(Vec2 point, LensIndex lens) const;

    /// Calls visit(LensIndex) for every lens whose pole (axis) is within `radius` of `centre`,
    /// and perhaps for a few just beyond it.
    template <class Visit> void for_each_within(Vec2 centre, double radius, Visit visit) const;

    /// Whether lens `a` is preferred to `b` at equal distance.
    bool preferred(LensIndex a, LensIndex b) const;

    double pitch() const { return pitch_; }
    /// mm between rows of lenses; hexagonal: p sqrt(3)/2
    double row_spacing() const { return row_spacing_; }
    /// mm: distances that differ by less count as equal.
    double tie_tolerance() const { return 1e-9 * pitch_; }
    Arrangement arrangement() const { return arrangement_; }

private:
    Vec2 lattice_from_sheet(Vec2 point) const
    {
        const Vec2 from_offset = point - offset_;
        return {dot(across_, from_offset), dot(along_, from_offset)};
    }
    LensIndex nearest_of_even_rows(Vec2 point) const;
    LensIndex nearest_of_shifted_rows(Vec2 point) const;
    LensIndex settle_tie(Vec2 point, LensIndex guess) const;

    /// Pitches: a point this near to the border of two cells is tested for a tie.
    static constexpr double border_margin = 1e-8;

    Arrangement arrangement_;
    double pitch_, row_spacing_;
    Vec2 across_, along_, offset_;
};

/// The nearest integer, halves to even, for |value| < 2^51: adding 1.5 * 2^52 leaves no bits for a
/// fraction. (std::nearbyint is a call into the mathematics library, and this is the hot path.)
inline double nearest_integer(double value)
{
    constexpr double no_fraction = 6755399441055744.0;
    return (value + no_fraction) - no_fraction;
}

inline Vec2 Lattice::pole(LensIndex lens) const
{
    double columns = static_cast<double>(lens.i);
    if (arrangement_ == Arrangement::lenticular)
        return offset_ + (columns * pitch_) * across_;
    if (arrangement_ == Arrangement::hexagonal && (lens.j & 1))
        columns += 0.5;
    return offset_ + (columns * pitch_) * across_ +
           (static_cast<double>(lens.j) * row_spacing_) * along_;
}

inline LensIndex Lattice::nearest_of_even_rows(Vec2 point) const
{
    const Vec2 p = lattice_from_sheet(point);
    const bool rows = arrangement_ == Arrangement::square;
    const double u = p.x / pitch_, v = rows ? p.y / pitch_ : 0;
    const double column = nearest_integer(u), row = nearest_integer(v);
    const LensIndex guess{static_cast<std::int64_t>(column), static_cast<std::int64_t>(row)};
    const bool near_border = std::fabs(u - column) > 0.5 - border_margin ||
                             std::fabs(v - row) > 0.5 - border_margin;
    return near_border ? settle_tie(point, guess) : guess;
}

template <class Visit> void Lattice::for_each_within(Vec2 centre, double radius, Visit visit) const
{
    const Vec2 c = lattice_from_sheet(centre);
    const auto span_i = [&](double shift, std::int64_t j) {
        const auto first = static_cast<std::int64_t>(
            std::ceil((c.x - radius) / pitch_ - shift - 1e-6));
        const auto last = static_cast<std::int64_t>(
            std::floor((c.x + radius) / pitch_ - shift + 1e-6));
        for (std::int64_t i = first; i <= last; ++i)
            visit(LensIndex{i, j});
    };
    if (arrangement_ == Arrangement::lenticular) {
        span_i(0, 0);
        return;
    }
    const auto first = static_cast<std::int64_t>(std::ceil((c.y - radius) / row_spacing_ - 1e-6));
    const auto last = static_cast<std::int64_t>(std::floor((c.y + radius) / row_spacing_ + 1e-6));
    for (std::int64_t j = first; j <= last; ++j)
        span_i(arrangement_ == Arrangement::hexagonal && (j & 1) ? 0.5 : 0.0, j);
}

} // namespace integral

#endif
