// SPDX-License-Identifier: AGPL-3.0-or-later
// The capture aperture: the possible places of the viewer's eyes, which select the recorded rays.
#ifndef INTEGRAL_OPTICS_APERTURE_H
#define INTEGRAL_OPTICS_APERTURE_H

#include "integral/optics/lens_sheet.h"

#include <optional>

namespace integral {

enum class ApertureShape { rectangle, ellipse };

/// Centred on the sheet's axis at z = -distance, in mm; does not turn with the lens slant. A
/// lenticular sheet's aperture is a slit. Only the extent along the slit decides which film points
/// are imaged; the extent across it is the slit's height, over which samples are spread.
struct Aperture {
    double distance = 0;          ///< d, in front of the sheet; > 0
    double width = 0, height = 0; ///< full extents along x and y; >= 0, infinity = no limit
    ApertureShape shape = ApertureShape::rectangle;
};

bool within_ellipse(const Aperture& aperture, Vec2 point);
constexpr double inclusive_edge = 1 + 1e-9; // factor on the extents: points on the edge are inside

/// Whether a point of the aperture plane is inside, on the edge or up to 1e-9 of the extent beyond.
inline bool contains(const Aperture& aperture, Vec2 point)
{
    return std::fabs(point.x) <= 0.5 * aperture.width * inclusive_edge &&
           std::fabs(point.y) <= 0.5 * aperture.height * inclusive_edge &&
           (aperture.shape == ApertureShape::rectangle || within_ellipse(aperture, point));
}

/// Whether a lenticular sheet's slit lies along x (|slant| <= 45 degrees) or along y.
bool slit_is_horizontal(const LensSheet& sheet);

/// Whether the lenses are cylinders that lie across, so that views differ vertically: a lenticular
/// sheet whose slit lies along y. Upright cylinders give views that differ horizontally, other
/// lenses in both directions.
bool lenses_lie_across(const LensSheet& sheet);

/// The component of an extent (or a point) along a lenticular sheet's slit; and that across it.
double extent_along_slit(const LensSheet& sheet, Vec2 extent);
double extent_across_slit(const LensSheet& sheet, Vec2 extent);

/// Width (mm), on the film, of the axial lens's image of an aperture `width` wide at `distance`:
/// thesis (3-9), 2t / sqrt(4 n^2 (d/w)^2 + n^2 - 1). May be infinite where n = 1.
double micro_image_width(const LensSheet& sheet, double distance, double width);

/// Inverse: the aperture width whose micro-image is `cell` mm wide, 2 d s / sqrt(1 - s^2) with
/// s = n (cell/2) / sqrt((cell/2)^2 + t^2). Empty if s >= 1: no finite aperture is so wide.
std::optional<double> filling_width(const LensSheet& sheet, double distance, double cell);

/// Width and height (mm) of the smallest upright rectangle that contains a lens's cell, turned by
/// the slant. For a lenticular sheet: the cell's extent along the slit, and 0 across it.
Vec2 cell_extent(const LensSheet& sheet);

/// The aperture whose micro-image behind the lens on the axis is as wide and as high as the lens's
/// cell_extent (optics.md section 5). Empty if there is no such finite aperture.
std::optional<Aperture> filling_aperture(const LensSheet& sheet, double distance);

/// Width and height (mm) of the viewing zone at the aperture's distance: the aperture's, but each
/// at most filling_width of the cell_extent or, if that is empty, twice the distance.
Vec2 viewing_zone(const LensSheet& sheet, const Aperture& aperture);

/// A part of the viewing zone: places from `first` to `last`, 0 at its left edge (or, with
/// `upwards`, its lower one) and 1 at the other; places beyond repeat, as the zone does in side
/// lobes.
struct ZonePhase {
    double first = 0, last = 1;
    bool upwards = false;

    /// Whether a point of the aperture plane is in the part, or up to `margin` beyond. `zone`: its
    /// width and height, mm, > 0 in the part's direction.
    bool contains(Vec2 aperture_point, Vec2 zone, double margin) const
    {
        const double place = (upwards ? aperture_point.y / zone.y : aperture_point.x / zone.x) +
                             0.5 - first + margin;
        return place - std::floor(place) <= last - first + 2 * margin;
    }
};

} // namespace integral

#endif
