// SPDX-License-Identifier: AGPL-3.0-or-later
// From a film point to its lens and the ray that leaves it (optics.md sections 3 and 4), and back.
#ifndef INTEGRAL_OPTICS_LENS_MAPPING_H
#define INTEGRAL_OPTICS_LENS_MAPPING_H

#include "integral/optics/aperture.h"
#include "integral/optics/film.h"
#include "integral/optics/lens_model.h"
#include "integral/optics/lens_sheet.h"
#include "integral/optics/refraction.h"
#include "integral/optics/slit.h"

#include <optional>

namespace integral {

/// How a film point finds its lens (optics.md section 4).
///
/// Every search has an end: accurate's 100 pitches from the lens that sees the aperture's centre,
/// exhaustive's 1000 pitches from the film point. No aperture that a lens could fill reaches so
/// far; one that does is hundreds of lenses wide, or without limit one way and narrow the other.
enum class LensMapping {
    automatic, ///< closest, and accurate only where closest's check fails
    closest,   ///< the lens of the nearest pole, if its ray passes the aperture (3-11)
    accurate,  ///< of the lenses whose rays pass the aperture, the one that passes nearest to its
               ///< centre
    exhaustive ///< accurate by trying every lens: the oracle
};

/// The pole ray of a film point: its light beyond the lens's pole. Sheet frame, mm.
struct LensRay {
    LensIndex lens;
    Vec2 pole; ///< where it leaves, on z = 0; on a lenticular lens, the point of its axis that it
               ///< leaves from
    Vec3 direction;      ///< unit, towards the viewer (z < 0)
    Vec2 aperture_point; ///< where it meets the aperture plane z = -distance
};

/// Why a film point images nothing.
enum class Empty { none, outside_aperture, total_reflection };

/// What becomes of one film point.
struct MappedPoint {
    std::optional<LensRay> ray; ///< nothing: no ray is to be traced
    Empty empty = Empty::none;  ///< the reason, if so
    bool searched = false; ///< the lens was searched for, by accurate and exhaustive or as closest
                           ///< failed
};

/// The optics of a sheet, a film behind it and an aperture before it: immutable, and shared by
/// every thread of a render.
class SheetOptics {
public:
    /// `sheet` and `aperture` must be within the ranges of their comments; find_errors in camera.h
    /// checks them.
    SheetOptics(const LensSheet& sheet, const Aperture& aperture,
                LensModel model = LensModel::extended_pinhole);

    /// Lens and ray of a film point. One farther than 10^9 pitches from the sheet's centre images
    /// nothing.
    MappedPoint map(Vec2 film_point, LensMapping mapping) const;

    /// The ray from a film point through one given lens, whether or not it passes the aperture.
    /// Nothing: totally reflected, or the slit is out of reach.
    std::optional<LensRay> ray_through(Vec2 film_point, LensIndex lens) const;

    /// Inverse for an eye: the film point whose light leaves the sheet at `point` (z = 0) in
    /// `direction` (of any length, towards the viewer, z < 0), through the lens that `point`
    /// belongs to. The beam of a film point fills its lens's cell, so any point of the cell will
    /// do.
    Vec2 film_point_seen(Vec2 point, Vec3 direction, LensIndex* lens = nullptr) const
    {
        const LensIndex index = lattice_.nearest(point);
        if (lens)
            *lens = index;
        Vec2 base = lattice_.pole(index);
        if (lenticular_)
            base = point + dot(slit_.across, base - point) * slit_.across;
        return base - offset_from_direction(medium_, direction);
    }

    const LensSheet& sheet() const { return sheet_; }
    LensModel model() const { return model_; }
    const Aperture& aperture() const { return aperture_; }
    const Lattice& lattice() const { return lattice_; }
    const Medium& medium() const
    {
        return medium_;
    }                                          ///< between film and poles, as the model has it
    const Slit& slit() const { return slit_; } ///< meaningful for a lenticular sheet

private:
    struct Candidate; // a lens's pole ray, before its direction is worked out
    bool find_candidate(Vec2 film_point, LensIndex lens, Candidate& c) const;
    std::optional<Candidate> candidate(Vec2 film_point, LensIndex lens) const;
    LensRay complete(const Candidate&) const;
    std::optional<Candidate> best_within(Vec2 film_point, Vec2 centre, double radius) const;
    Empty why_empty(Vec2 film_point) const;
    MappedPoint map_accurate(Vec2 film_point) const;
    MappedPoint map_exhaustive(Vec2 film_point) const;
    Vec2 pole_seeing_centre(Vec2 film_point, double& error) const;
    bool passes(Vec2 aperture_point) const;
    double distance_to_centre(Vec2 aperture_point) const;
    double aperture_circumradius() const;

    LensSheet sheet_;
    LensModel model_;
    Aperture aperture_;
    Lattice lattice_;
    Medium medium_;
    Slit slit_;
    bool lenticular_, slit_horizontal_;
    Aperture edges_; ///< the aperture, without limit across a slit
};

/// The film point mirrored at a lens's pole (lenticular: at its axis). Its own inverse. A
/// single-stage capture puts on a film point what belongs at the mirrored one, so that the sheet
/// shows its scene inverted in depth.
Vec2 mirrored_in_lens(const SheetOptics& optics, Vec2 film_point, LensIndex lens);

} // namespace integral

#endif
