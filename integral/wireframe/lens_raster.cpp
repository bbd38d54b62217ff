// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/lens_raster.h"

#include <algorithm>

namespace integral {
namespace {

Colour between(Colour a, Colour b, double t)
{
    const float u = float(t), v = 1 - u;
    return {v * a.r + u * b.r, v * a.g + u * b.g, v * a.b + u * b.b, 1};
}

/// The greatest whole number that is not above a small one.
int whole_below(double value)
{
    const int towards_zero = int(value);
    return towards_zero - (value < towards_zero);
}

/// Narrows [first, last] to where least <= from + t * step <= most.
void clip(double from, double step, double least, double most, double& first, double& last)
{
    if (step == 0) {
        if (from < least || from > most)
            last = -1;
        return;
    }
    const double a = (least - from) / step, b = (most - from) / step;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
}

} // namespace

LensRaster::LensRaster(const LensRun* begin, const LensRun* end) : begin_(begin), end_(end)
{
    box_ = {begin->first, begin->row, begin->end, (end - 1)->row + 1};
    row_start_.assign(std::size_t(box_.bottom - box_.top) + 1, end - begin);
    std::size_t pixels = 0;
    for (const LensRun* run = begin; run != end; ++run) {
        box_.left = std::min(box_.left, run->first);
        box_.right = std::max(box_.right, run->end);
        offset_.push_back(pixels);
        pixels += std::size_t(run->end - run->first);
    }
    for (const LensRun* run = begin; run != end; ++run) {
        std::ptrdiff_t& start = row_start_[std::size_t(run->row - box_.top)];
        start = std::min(start, run - begin);
    }
    // A row without runs begins with the next row's.
    for (std::size_t k = row_start_.size() - 1; k-- > 0;)
        row_start_[k] = std::min(row_start_[k], row_start_[k + 1]);
    depth_.resize(pixels);
    colour_.resize(pixels);
    clear();
}

void LensRaster::clear() { std::fill(depth_.begin(), depth_.end(), nothing); }

void LensRaster::draw_point(const FilmCorner& at)
{
    if (!is_in_box(at.pixel))
        return;
    const std::size_t index = index_at(int(at.pixel.x), int(at.pixel.y));
    if (index != outside)
        draw_at(index, at.depth, at.colour);
}

void LensRaster::draw_line(const FilmCorner& from, const FilmCorner& to)
{
    const Vec2 way = to.pixel - from.pixel;
    double first = 0, last = 1;
    if (!is_in_box(from.pixel) || !is_in_box(to.pixel)) {
        clip(from.pixel.x, way.x, box_.left, box_.right, first, last);
        clip(from.pixel.y, way.y, box_.top, box_.bottom, first, last);
        if (!(first <= last))
            return;
    }
    const bool flat = std::fabs(way.x) >= std::fabs(way.y);
    const double start = flat ? from.pixel.x : from.pixel.y, step = flat ? way.x : way.y;
    const double a = start + first * step, b = start + last * step;
    const int least = whole_below(std::min(a, b)), most = whole_below(std::max(a, b));
    for (int k = least; k <= most; ++k) {
        const double t = step == 0 ? 0 : std::clamp((k + 0.5 - start) / step, first, last);
        const Vec2 at = from.pixel + t * way;
        const std::size_t index = index_at(flat ? k : whole_below(at.x),
                                           flat ? whole_below(at.y) : k);
        const double depth = from.depth + t * (to.depth - from.depth);
        if (index != outside && is_seen_at(index, depth))
            draw_at(index, depth, between(from.colour, to.colour, t));
    }
}

void LensRaster::fill_row(int y, double depth, Colour colour)
{
    if (y < box_.top || y >= box_.bottom)
        return;
    for (const LensRun* run = first_of_row(y); run != end_ && run->row == y; ++run)
        for (int x = run->first; x < run->end; ++x)
            draw_at(index_of(*run, x), depth, colour);
}

void LensRaster::fill(double depth, Colour colour)
{
    for (std::size_t k = 0; k < depth_.size(); ++k)
        draw_at(k, depth, colour);
}

} // namespace integral
