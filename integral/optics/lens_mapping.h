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

/// closest: the nearest pole, then the aperture check (3-11). accurate: the lens that images the
/// aperture, of several the one nearest its centre. automatic: closest, and accurate only where
/// the check fails. exhaustive: accurate by trying every lens; the oracle.
/// accurate looks no farther than 100 pitches from the lens that sees the aperture's centre, exhaustive no farther than 1000
/// from the film point: only apertures without limit one way and narrow the other, or far wider than fills a lens, reach beyond.
enum class LensMapping { automatic, closest, accurate, exhaustive };

/// A film point's light beyond its lens. Sheet frame, mm.
struct LensRay {
    LensIndex lens;
    Vec2 pole;           ///< where it leaves the sheet plane z = 0 (on a lenticular lens's axis)
    Vec3 direction;      ///< unit, towards the viewer (z < 0)
    Vec2 aperture_point; ///< where it meets the aperture plane z = -distance
};

/// Why a film point images nothing.
enum class Empty { none, outside_aperture, total_reflection };

/// What becomes of one film point.
struct MappedPoint {
    std::optional<LensRay> ray; ///< nothing: no ray is to be traced
    Empty empty = Empty::none;  ///< the reason, if so
    bool searched = false;      ///< the rule failed its check, and the accurate search was run
};

/// The optics of a sheet, a film behind it and an aperture before it: immutable, and shared by
/// every thread of a render.
class SheetOptics {
public:
    /// Both must hold what their comments demand; see find_errors in camera.h for the checks.
    SheetOptics(const LensSheet& sheet, const Aperture& aperture, LensModel model = LensModel::extended_pinhole);

    /// Lens and ray of a film point.
    MappedPoint map(Vec2 film_point, LensMapping mapping) const;

    /// The ray from a film point through one given lens, whether or not it passes the aperture.
    /// Nothing: totally reflected, or the slit is out of reach.
    std::optional<LensRay> ray_through(Vec2 film_point, LensIndex lens) const;

    /// Inverse for an eye: the film point whose light leaves the sheet at `point` (z = 0) in
    /// `direction` (unit, towards the viewer, z < 0), through the lens that `point` belongs to.
    /// The beam of a film point fills its lens's cell, so any point of the cell will do.
    Vec2 film_point_seen(Vec2 point, Vec3 direction, LensIndex* lens = nullptr) const;

    const LensSheet& sheet() const { return sheet_; }
    LensModel model() const { return model_; }
    const Aperture& aperture() const { return aperture_; }
    const Lattice& lattice() const { return lattice_; }
    const Medium& medium() const { return medium_; } ///< as the model has it
    const Slit& slit() const { return slit_; }       ///< meaningful for a lenticular sheet

private:
    struct Candidate; // a ray before its direction is worked out
    std::optional<Candidate> candidate(Vec2 film_point, LensIndex lens) const;
    LensRay complete(const Candidate&) const;
    std::optional<Candidate> best_within(Vec2 film_point, Vec2 centre, double radius) const;
    Empty why_empty(Vec2 film_point) const;
    MappedPoint map_closest(Vec2 film_point) const;
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
};

} // namespace integral

#endif
