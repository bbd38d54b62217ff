// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/view_set.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace integral {

double DepthScale::mm(double disparity) const
{
    const double part = -disparity / ratio; // z / (distance + z)
    return part < 1 ? distance * part / (1 - part) : HUGE_VAL;
}

namespace {

DepthView view_of(const ViewSet& set, const Image& picture, Vec2 shift)
{
    DepthView view;
    view.shift = shift;
    for (auto& channel : view.channels)
        channel.reserve(set.pixels());
    for (int y = 0; y < set.height; ++y)
        for (int x = 0; x < set.width; ++x) {
            const std::size_t at = set.upright_pixel(x, y);
            const Colour c = stored_pixel(picture, int(at % std::size_t(picture.width)),
                                          int(at / std::size_t(picture.width)));
            view.channels[0].push_back(c.r);
            view.channels[1].push_back(c.g);
            view.channels[2].push_back(c.b);
        }
    return view;
}

void check(const std::vector<Image>& views)
{
    if (views.size() < 2)
        throw std::invalid_argument("depth needs 2 views at least, and there are " +
                                    std::to_string(views.size()));
    for (const Image& view : views)
        if (view.width != views[0].width || view.height != views[0].height)
            throw std::invalid_argument("its views differ in size");
}

/// Mixes each lit pixel with its lit neighbours `step` values away on both sides. `before(i)` and
/// `after(i)`: whether pixel i has a neighbour there.
template <class Before, class After>
void mix_neighbours(DepthView& view, std::size_t step, Before before, After after)
{
    constexpr float part = 0.15f;
    const auto lit = [&](std::size_t i) { return view.lit.empty() || view.lit[i] > 0; };
    for (auto& channel : view.channels) {
        const std::vector<float> old = channel;
        for (std::size_t i = 0; i < old.size(); ++i) {
            if (!lit(i))
                continue;
            if (before(i) && lit(i - step))
                channel[i] += part * (old[i - step] - old[i]);
            if (after(i) && lit(i + step))
                channel[i] += part * (old[i + step] - old[i]);
        }
    }
}

void soften(DepthView& view, std::size_t width)
{
    mix_neighbours(
        view, 1, [&](std::size_t i) { return i % width > 0; },
        [&](std::size_t i) { return i % width < width - 1; });
    const std::size_t count = view.channels[0].size();
    mix_neighbours(
        view, width, [&](std::size_t i) { return i >= width; },
        [&](std::size_t i) { return i + width < count; });
}

} // namespace

void soften(ViewSet& views, int threads)
{
    views.colours = views.middle.channels;
    for_each_row(int(views.others.size()) + 1, threads, [&](int k) {
        soften(k == 0 ? views.middle : views.others[std::size_t(k - 1)], std::size_t(views.width));
    });
}

Vec2 middle_eye(ViewGrid grid, Vec2 spacing)
{
    return {(grid.columns / 2 - 0.5 * (grid.columns - 1)) * spacing.x,
            (grid.rows / 2 - 0.5 * (grid.rows - 1)) * spacing.y};
}

ViewSet view_set(const std::vector<Image>& views, ViewGrid grid,
                 const std::optional<ViewEyes>& eyes, std::optional<double> shape)
{
    check(views);
    ViewSet set;
    set.turned = grid.columns == 1;
    set.width = set.turned ? views[0].height : views[0].width;
    set.height = set.turned ? views[0].width : views[0].height;
    // Height / width of a pixel, as the views are displayed.
    const double of_pixels = double(set.upright_width()) / set.upright_height(),
                 tall = of_pixels / shape.value_or(of_pixels);
    double pixel = 1, up = 1; // a pixel's width, mm; a step up / a step across
    if (eyes) {
        pixel = eyes->width / set.upright_width();
        if (grid.columns > 1 && grid.rows > 1)
            up = eyes->spacing.y / eyes->spacing.x;
        const double spacing = grid.columns > 1 ? eyes->spacing.x : eyes->spacing.y;
        set.scale = DepthScale{eyes->distance, spacing / (set.turned ? pixel * tall : pixel)};
        set.eye = middle_eye(grid, eyes->spacing);
    }
    up /= tall; // in pixel heights / pixel widths
    const Vec2 right = set.turned ? Vec2{0, pixel * tall} : Vec2{pixel, 0},
               down = set.turned ? Vec2{pixel, 0} : Vec2{0, -pixel * tall};
    set.places = {-0.5 * (set.width - 1) * right - 0.5 * (set.height - 1) * down, right, down};
    const int middle_column = grid.columns / 2, middle_row = grid.rows / 2;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const Vec2 shift = set.turned
                                   ? Vec2{double(middle_row - row), 0}
                                   : Vec2{double(middle_column - column), up * (row - middle_row)};
            DepthView view = view_of(set, views[std::size_t(row * grid.columns + column)], shift);
            if (column == middle_column && row == middle_row)
                set.middle = std::move(view);
            else
                set.others.push_back(std::move(view));
        }
    set.colours = set.middle.channels;
    return set;
}

} // namespace integral
