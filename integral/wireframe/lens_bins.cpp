// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/lens_bins.h"

#include <algorithm>

namespace integral {

LensReach::LensReach(const SheetOptics& optics, const LensRange& window, double pictures_reach,
                     double eye)
    : optics_(optics), window_(window), eye_(eye)
{
    const Aperture& aperture = optics.aperture();
    const Lattice& lattice = optics.lattice();
    constexpr double unlimited = 1e12;
    const Vec2 half{std::min(0.5 * aperture.width, unlimited),
                    std::min(0.5 * aperture.height, unlimited)};
    const auto extent = [&](Vec2 v) { return std::fabs(v.x) * half.x + std::fabs(v.y) * half.y; };
    half_aperture_ = {extent(lattice.across()), extent(lattice.along())};
    // The first two terms: points next to a lens are seen through it, wherever the aperture is. The
    // tenth of a pitch: a pixel is drawn whole, and its edges may see past the aperture's edge.
    reach_ = cell_circumradius(optics.sheet()) + pictures_reach + 0.1 * lattice.pitch();
}

/// A line from a scene point S to a point A of the aperture crosses the sheet at S + (A - S) z/(z -
/// eye). If the points S fill a convex set on one side of the eye, lines from the set's corners
/// have the extreme crossing points.
LensRange LensReach::of(const Vec3* points, std::size_t count) const
{
    const Lattice& lattice = optics_.lattice();
    const double side = points[0].z > eye_ ? 1 : -1;
    const Vec2 zero = lattice.pole({0, 0});
    double left = 1e300, right = -1e300, bottom = 1e300, top = -1e300;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 s = points[k];
        if (!(side * (s.z - eye_) > 1e-6 * std::fabs(eye_)))
            return window_;
        const double part = s.z / (s.z - eye_);
        const Vec2 crossing = (1 - part) * Vec2{s.x, s.y} - zero;
        const double u = dot(lattice.across(), crossing), v = dot(lattice.along(), crossing);
        const double wide = std::fabs(part) * half_aperture_.x + reach_,
                     high = std::fabs(part) * half_aperture_.y + reach_;
        left = std::min(left, u - wide);
        right = std::max(right, u + wide);
        bottom = std::min(bottom, v - high);
        top = std::max(top, v + high);
    }
    const auto below = [](double value, int least, int most) {
        return std::int32_t(std::clamp(std::floor(value), double(least), double(most)));
    };
    const double p = lattice.pitch(), row = lattice.row_spacing();
    LensRange range = window_;
    if (right / p < window_.i - 1 || left / p > window_.last_i + 1)
        return {};
    range.i = below(left / p, window_.i, window_.last_i);
    range.last_i = below(right / p + 1, window_.i, window_.last_i);
    if (lattice.arrangement() == Arrangement::lenticular)
        return range;
    if (top / row < window_.j - 1 || bottom / row > window_.last_j + 1)
        return {};
    range.j = below(bottom / row, window_.j, window_.last_j);
    range.last_j = below(top / row + 1, window_.j, window_.last_j);
    return range;
}

template <class Visit> void LensBins::for_each_block(const LensRange& range, Visit visit) const
{
    for (int row = (range.j - window_.j) / block_; row <= (range.last_j - window_.j) / block_;
         ++row)
        for (int column = (range.i - window_.i) / block_;
             column <= (range.last_i - window_.i) / block_; ++column)
            visit(std::size_t(row * columns_ + column));
}

LensBins::LensBins(const std::vector<LensRange>& ranges, const LensRange& window, int block)
    : window_(window),
      block_(block),
      columns_((window.last_i - window.i) / block + 1),
      rows_((window.last_j - window.j) / block + 1),
      start_(std::size_t(columns_) * rows_ + 1)
{
    const auto is_empty = [](const LensRange& r) { return r.last_i < r.i || r.last_j < r.j; };
    for (const LensRange& range : ranges)
        if (!is_empty(range))
            for_each_block(range, [&](std::size_t k) { ++start_[k + 1]; });
    for (std::size_t k = 1; k < start_.size(); ++k)
        start_[k] += start_[k - 1];
    entries_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t thing = 0; thing < ranges.size(); ++thing)
        if (!is_empty(ranges[thing]))
            for_each_block(ranges[thing],
                           [&](std::size_t k) { entries_[next[k]++] = std::uint32_t(thing); });
}

} // namespace integral
