// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/laboratory/view_figures.h"

#include "integral/optics/visual_pitch.h"
#include "integral/sheet/sheet_figures.h"
#include "integral/sheet/sheet_report.h"

#include <cmath>

namespace integral {

Vec2 converging_place(Vec2 place, double aside, double distance)
{
    const double away = std::hypot(aside, distance);
    const double depth = away - aside * place.x / away; // along the camera's axis
    return {distance * (distance * place.x / away) / depth, distance * place.y / depth};
}

LensApart lens_apart(double pitch, double step, double distance)
{
    LensApart range{pitch * distance / (step + pitch), std::nullopt};
    if (step > pitch)
        range.back = pitch * distance / (step - pitch);
    return range;
}

double mean_crosstalk(double pixel) { return pixel / 4; }

double one_view_distance(const LensSheet& sheet, double width, int views)
{
    return discrete_view_distance(sheet, sheet.pitch / views, width);
}

ViewFigures view_figures(const FrameMetadata& geometry, int views)
{
    const LensRowGeometry c = counted(geometry);
    const double d = geometry.aperture.distance;
    ViewFigures f;
    f.distance = d;
    f.zone = viewing_zone(geometry.sheet, geometry.aperture).x;
    f.step = f.zone / views;
    f.pixels_per_lens = c.period / c.pixel;
    const double micro_image = visual_pitch(c.period, geometry.sheet, d);
    f.pixel_step = f.zone * c.pixel / micro_image;
    f.depth = lens_apart(geometry.sheet.pitch, f.step, d);
    const double pixel = views * c.pixel / micro_image;
    if (pixel <= 1 + 1e-9)
        f.crosstalk = mean_crosstalk(pixel);
    const Vec2 corner = 0.5 * size_of(geometry.film);
    const double outermost = 0.5 * (f.zone - f.step);
    f.keystone = converging_place(corner, outermost, d) - converging_place(corner, -outermost, d);
    f.moire = moire_pitch(c.period, geometry.sheet, c.pixel, d);
    f.one_view_from = one_view_distance(geometry.sheet, size_of(geometry.film).x, views);
    return f;
}

} // namespace integral
