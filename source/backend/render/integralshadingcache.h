// SPDX-License-Identifier: AGPL-3.0-or-later
// Stores the shaded patches that rays of different lenses share (integralshading.h defines a
// patch), or their ambient light (integralsharedambient.h).
#ifndef POVRAY_BACKEND_INTEGRALSHADINGCACHE_H
#define POVRAY_BACKEND_INTEGRALSHADINGCACHE_H

#include <atomic>
#include <cstdint>
#include <vector>

#include "backend/frame.h"
#include "integral/optics/camera.h"

namespace pov
{

/// The patches of a view, shared by its threads: a table of fixed size, chosen by the frame's size,
/// in which new patches overwrite old ones.
class IntegralShadingCache
{
public:
    /// `cells`: the approximate number of patches that a pixel's beam covers, which determines
    /// their size. `slots_a_pixel`: the approximate number of patches in the table for each of the
    /// frame's pixels.
    IntegralShadingCache(const integral::IntegralCamera& camera, double cells,
                         double slots_a_pixel = 8);

    /// Squares of 4 x 4 neighbouring patches are stored together, in a row of slots.
    static constexpr int square_bits = 2, square = 1 << square_bits;
    static constexpr std::size_t row_length = square * square;

    struct Patch
    {
        std::uint64_t key = 0;  ///< 0: empty
        float red, green, blue; ///< the patch's colour; for a light, the fractions that reach it
        float note;             ///< the height of its point, or the quality of ambient light
    };

    /// Looks up the patch with a key at its slot; false if it is not there.
    bool Find(std::size_t slot, std::uint64_t key, Patch& patch) const;
    void Store(std::size_t slot, const Patch& patch);

    /// The slot for a row (any number) and a column.
    std::size_t Slot(std::uint64_t row, std::size_t column) const;

    /// The level of the patches' size at a point of the scene. Sizes grow by 2^(1/2) per level.
    int Level(const VECTOR point) const;
    static double Size(int level); ///< scene units

    /// The number of levels by which patches for lights may be larger than patches for colours: light without
    /// pigment and highlights varies less. Patches for lights are not larger than a beam.
    int Coarser_For_Lights() const;

    /// Whether patches at the sheet are large compared with POV-Ray's tolerances.
    bool Of_Use() const;

private:
    integral::IntegralCamera camera;
    double spread, cells, scale;
    std::vector<Patch> patches;
    mutable std::vector<std::atomic_flag> locks; ///< one for each row of slots
};

}

#endif
