// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the lenses that can image a point, line or face, so that no other lens is visited.
#ifndef INTEGRAL_WIREFRAME_LENS_BINS_H
#define INTEGRAL_WIREFRAME_LENS_BINS_H

#include "integral/optics/lens_mapping.h"

#include <cstdint>
#include <vector>

namespace integral {

/// Lenses i to last_i of rows j to last_j.
struct LensRange {
    std::int32_t i = 0, j = 0, last_i = -1, last_j = -1;
    bool contains(LensIndex lens) const
    {
        return lens.i >= i && lens.i <= last_i && lens.j >= j && lens.j <= last_j;
    }
};

/// z of the aperture, mm. Pixels of a pseudoscopic frame are mirrored in their lenses: they see
/// along lines through their lens and an aperture at the same distance behind the sheet.
inline double eye_depth(const SheetOptics& optics, bool pseudoscopic)
{
    return pseudoscopic ? optics.aperture().distance : -optics.aperture().distance;
}

/// Finds the lenses through which the aperture may see any point of the convex hull of some scene
/// points. `window`: the range of all lenses.
class LensReach {
public:
    /// `pictures_reach`: greatest distance (mm) from a lens's pole to the lens points used. `eye`:
    /// z of the aperture, mm: eye_depth().
    LensReach(const SheetOptics& optics, const LensRange& window, double pictures_reach,
              double eye);
    LensRange of(const Vec3* points, std::size_t count) const;

private:
    const SheetOptics& optics_;
    LensRange window_;
    double reach_;
    double eye_;
    Vec2 half_aperture_; ///< mm, along the lens rows and across them
};

/// Index of things (points, lines, triangles) by the lenses that may image them. Lenses form square
/// blocks, so that a thing that spans hundreds of lenses is stored some ten times.
class LensBins {
public:
    /// `ranges`: one for each thing. `block`: lenses along a block's side.
    LensBins(const std::vector<LensRange>& ranges, const LensRange& window, int block);

    int blocks() const { return columns_ * rows_; }
    int columns() const { return columns_; } ///< blocks in a row
    int block_of(LensIndex lens) const
    {
        return int(lens.j - window_.j) / block_ * columns_ + int(lens.i - window_.i) / block_;
    }
    /// The things that any lens of a block may image: [begin, end), in their order.
    const std::uint32_t* begin(int block) const
    {
        return entries_.data() + start_[std::size_t(block)];
    }
    const std::uint32_t* end(int block) const
    {
        return entries_.data() + start_[std::size_t(block) + 1];
    }

private:
    template <class Visit> void for_each_block(const LensRange& range, Visit visit) const;

    LensRange window_;
    int block_, columns_, rows_;
    std::vector<std::size_t> start_;
    std::vector<std::uint32_t> entries_;
};

} // namespace integral

#endif
