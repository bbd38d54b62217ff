// SPDX-License-Identifier: AGPL-3.0-or-later
// Maps a photograph to the film that it shows through a lenticular sheet on a calibration page.
//
// Lengths are measured in the print: a page that the printer stretches by 0.1% makes all of them
// smaller by 0.1%.
#ifndef INTEGRAL_ANALYSIS_SHEET_VIEW_H
#define INTEGRAL_ANALYSIS_SHEET_VIEW_H

#include "integral/analysis/photo_camera.h"
#include "integral/print/calibration_layout.h"

#include <array>

namespace integral {

/// An even function of a ray's slopes across and along the lenses (tangents u and v): coefficients
/// of 1, u^2, v^2, u^4, u^2 v^2 and v^4.
using SlopePolynomial = std::array<double, 6>;

/// Effect of a lens's whole surface on the film that it shows, relative to its pole alone.
struct SurfaceEffect {
    /// Film displacement of the beat bands' phase across the lenses, divided by the pole's, less 1:
    /// mainly the coma of spherical surfaces, < 0.
    SlopePolynomial beat{};
    /// Mean film displacement across the lenses from where the ray passes the plane of the poles,
    /// minus that of the beat bands' phase, divided by u, mm: about the depth at which lenses meet.
    SlopePolynomial coarse{};
    /// Mean film displacement along the lenses, divided by the pole's, less 1.
    SlopePolynomial along{};
};

/// The effect of the spherical surface whose focus is the film; none if the sheet cannot have one.
SurfaceEffect surface_effect(const LensSheet& sheet);

struct SheetView {
    PhotoCamera camera;
    double stretch = 0; ///< by which the print is longer along y than along x, relative
    double pitch = 1;   ///< mm
    double angle = 0;   ///< direction across the lenses, radians from x, anticlockwise
    double phase = 0;   ///< mm along that direction from the page's middle to a lens's axis
    double thickness = 1, ior = 1.5;
    SurfaceEffect surface;      ///< of a sheet of the nominal thickness
    double surface_share = 0;   ///< of that effect
    double thickness_share = 1; ///< thickness divided by the nominal one
};

/// Effective t/n, mm: film displacement of the beat bands' phase divided by the tangent of small
/// angles.
inline double effective_reach(const SheetView& view)
{
    return view.thickness / view.ior * (1 + view.surface_share * view.surface.beat[0]);
}

/// A photo point's ray: where it passes the plane of the poles, and the film points that the lenses
/// there show.
struct Sight {
    Vec2 lens, film, coarse_film; ///< mm, page frame
};

Sight sight_of(const SheetView& view, Vec2 photo);

/// The photo point that shows a film point.
Vec2 photo_of_film(const SheetView& view, Vec2 film);

/// The phase (in periods) of a band's light at a photo point: whole numbers where it is lightest.
double band_phase(const SheetView& view, const CalibrationBand& band, const Sight& sight);

} // namespace integral

#endif
