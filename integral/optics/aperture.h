// SPDX-License-Identifier: AGPL-3.0-or-later
// The capture aperture: where the viewer's eyes may be, and which rays are recorded.
#ifndef INTEGRAL_OPTICS_APERTURE_H
#define INTEGRAL_OPTICS_APERTURE_H

#include "integral/optics/lens_sheet.h"

#include <optional>

namespace integral {

enum class ApertureShape { rectangle, ellipse };

/// Centred on the axis at z = -distance. Millimetres. It does not turn with the lens slant.
/// A lenticular sheet's aperture is a slit without height: only its extent along the slit counts.
struct Aperture {
    double distance = 0;          ///< d, in front of the sheet; > 0
    double width = 0, height = 0; ///< full extents along x and y; >= 0, infinity = no limit
    ApertureShape shape = ApertureShape::rectangle;
};

bool within_ellipse(const Aperture& aperture, Vec2 point);
constexpr double inclusive_edge = 1 + 1e-9; // of the extents: points on the edge are inside

/// Whether a point of the aperture plane is inside. The edge is, and 1e-9 of the extent beyond.
inline bool contains(const Aperture& aperture, Vec2 point)
{
    return std::fabs(point.x) <= 0.5 * aperture.width * inclusive_edge &&
           std::fabs(point.y) <= 0.5 * aperture.height * inclusive_edge &&
           (aperture.shape == ApertureShape::rectangle || within_ellipse(aperture, point));
}

/// Whether a lenticular sheet's slit lies along x (|slant| <= 45 degrees) or along y.
bool slit_is_horizontal(const LensSheet& sheet);

/// Whether the lenses are cylinders that lie across, so that views differ up and down: a lenticular
/// sheet whose slit lies along y. Views of upright cylinders differ sideways, those of other lenses
/// in both directions.
bool lenses_lie_across(const LensSheet& sheet);

/// Of an extent (or a point) in x and y, the component along a lenticular sheet's slit, and the
/// component across it.
double extent_along_slit(const LensSheet& sheet, Vec2 extent);
double extent_across_slit(const LensSheet& sheet, Vec2 extent);

/// Width (mm) of the image that the lens on the axis casts on the film of an aperture `width` wide
/// at `distance`: thesis (3-9), 2t / sqrt(4 n^2 (d/w)^2 + n^2 - 1). May be infinite where n = 1.
double micro_image_width(const LensSheet& sheet, double distance, double width);

/// Inverse: the aperture width whose micro-image is `cell` mm wide, 2 d s / sqrt(1 - s^2) with
/// s = n (cell/2) / sqrt((cell/2)^2 + t^2). Nothing if s >= 1: no finite aperture fills it.
std::optional<double> filling_width(const LensSheet& sheet, double distance, double cell);

/// Width and height (mm) of the smallest upright rectangle that contains a lens's cell, which the
/// slant turns. For a lenticular sheet: the cell's extent along the slit, and 0 across it.
Vec2 cell_extent(const LensSheet& sheet);

/// The aperture whose micro-image behind the lens on the axis is as wide and as high as the lens's
/// cell_extent (optics.md section 5). Nothing if no finite aperture is.
std::optional<Aperture> filling_aperture(const LensSheet& sheet, double distance);

/// Width and height, mm, of the viewing zone at the aperture's distance: the aperture, but no
/// larger than what fills the lens on the axis (or, if no aperture does, than twice the distance).
Vec2 viewing_zone(const LensSheet& sheet, const Aperture& aperture);

} // namespace integral

#endif
