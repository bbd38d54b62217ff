// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/relief_views.h"

#include "integral/base/interrupt.h"
#include "integral/frame/view_eyes.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// Lines of sight a pixel needs one way, for pixels `pixel` mm wide.
int lines_one_way(double pixel, const Relief& relief)
{
    return std::clamp(int(std::ceil(pixel / relief.pixel() - 0.5)), 1, 3);
}

} // namespace

Vec2 spacing_of_lines(const Relief& relief, Vec2 shown, PixelSize size)
{
    const Vec2 pixel{shown.x / size.width, shown.y / size.height};
    return {pixel.x / lines_one_way(pixel.x, relief), pixel.y / lines_one_way(pixel.y, relief)};
}

ReliefEyeView::ReliefEyeView(const Relief& relief, Vec2 eye, double part, Vec2 shown,
                             PixelSize size)
    : relief_(relief),
      eye_(eye),
      part_(part),
      raster_{size.width, size.height, {shown.x / size.width, shown.y / size.height}},
      across_(lines_one_way(raster_.pixel_pitch.x, relief)),
      down_(lines_one_way(raster_.pixel_pitch.y, relief))
{
}

Colour ReliefEyeView::pixel(int x, int y, ReliefFigures& figures, bool with_bars) const
{
    MeanSeen mean(across_ * down_, figures);
    for (int k = 0; k < across_ * down_; ++k) {
        const ReliefLine line = line_at(
            {x + (k % across_ + 0.5) / across_, y + (k / across_ + 0.5) / down_});
        if (!with_bars || !is_in_bar(line.place))
            mean.add(relief_.along(line));
    }
    return mean.light();
}

double ReliefEyeView::parallax(int x, int y) const
{
    return relief_.along(line_at({x + 0.5, y + 0.5})).parallax;
}

ReliefLine ReliefEyeView::line_at(Vec2 pixel) const
{
    const Vec2 place = film_from_pixel(raster_, pixel);
    return {place, place + part_ * (eye_ - place)};
}

bool ReliefEyeView::is_in_bar(Vec2 place) const
{
    return std::fabs(place.x) > 0.5 * relief_.size().x ||
           std::fabs(place.y) > 0.5 * relief_.size().y;
}

ReliefViews views_of_relief(Relief relief, const EyeGrid& eyes, ViewGrid directions, Vec2 shown,
                            PixelSize size, const Image& form, int threads,
                            const Progress& progress)
{
    ReliefViews made;
    ReliefTally tally;
    relief.thin(spacing_of_lines(relief, shown, size));
    for (int k = 0; k < directions.count(); ++k) {
        Image& view = made.views.emplace_back(blank_like(form, size.width, size.height));
        const ReliefEyeView eye_view(relief, eye_of_view(eyes, directions, k),
                                     relief.distance() / eyes.distance, shown, size);
        const auto row = [&](int y) {
            ReliefFigures figures;
            for (int x = 0; x < size.width; ++x)
                store_linear(view, x, y, eye_view.pixel(x, y, figures));
            tally.add(figures);
        };
        if (!for_each_row(size.height, threads, row, piece_of(progress, k, directions.count())))
            throw Interrupted();
    }
    made.figures = tally.all();
    return made;
}

} // namespace integral
