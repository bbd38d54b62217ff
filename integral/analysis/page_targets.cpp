// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/page_targets.h"

#include "integral/analysis/photo_plane.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace integral {
namespace {

/// A connected part of the photo's black pixels, or of its other pixels.
struct Region {
    int pixels = 0, left = 1 << 30, right = -1, top = 1 << 30, bottom = -1;
    double sum_x = 0, sum_y = 0, light = 0; // sums
    int left_row = 0;                       ///< the row of its leftmost pixel
    bool black = false;

    Vec2 middle() const { return {sum_x / pixels + 0.5, sum_y / pixels + 0.5}; }
    bool holds(const Region& other) const
    {
        return left < other.left && right > other.right && top < other.top && bottom > other.bottom;
    }
};

struct Regions {
    int width;
    std::vector<int> label; ///< of each pixel
    std::vector<Region> all;

    /// The region to the left of a region's leftmost pixel; nullptr at the photo's side.
    const Region* left_of(const Region& region) const
    {
        return region.left == 0
                   ? nullptr
                   : &all[label[std::size_t(region.left_row) * width + region.left - 1]];
    }
};

/// The set's representative in a forest of sets.
int root_of(std::vector<int>& parents, int k)
{
    while (parents[k] != k)
        k = parents[k] = parents[parents[k]];
    return k;
}

/// Regions of pixels whose sides touch.
Regions regions_of(const std::vector<char>& black, const Plane& photo)
{
    const int width = photo.width, height = photo.height;
    Regions regions{width, std::vector<int>(black.size()), {}};
    std::vector<int> parents;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t at = std::size_t(y) * width + x;
            const int left = x > 0 && black[at - 1] == black[at]
                                 ? root_of(parents, regions.label[at - 1])
                                 : -1,
                      above = y > 0 && black[at - width] == black[at]
                                  ? root_of(parents, regions.label[at - width])
                                  : -1;
            if (left < 0 && above < 0) {
                regions.label[at] = int(parents.size());
                parents.push_back(int(parents.size()));
                continue;
            }
            regions.label[at] = std::max(left, above);
            if (left >= 0 && above >= 0)
                parents[std::min(left, above)] = std::max(left, above);
        }
    std::vector<int> number(parents.size(), -1);
    for (std::size_t at = 0; at < black.size(); ++at) {
        const int root = root_of(parents, regions.label[at]);
        if (number[root] < 0) {
            number[root] = int(regions.all.size());
            regions.all.emplace_back();
            regions.all.back().black = black[at];
        }
        regions.label[at] = number[root];
        Region& region = regions.all[number[root]];
        const int x = int(at % width), y = int(at / width);
        ++region.pixels;
        region.sum_x += x;
        region.sum_y += y;
        region.light += photo.values[at];
        if (x < region.left) {
            region.left = x;
            region.left_row = y;
        }
        region.right = std::max(region.right, x);
        region.top = std::min(region.top, y);
        region.bottom = std::max(region.bottom, y);
    }
    return regions;
}

struct Target {
    Vec2 middle;
    double dot_share; ///< the dot's area divided by the area inside the disc
    int pixels;       ///< of disc, ring and dot
};

/// The target whose dot a region is, if it is one.
std::optional<Target> target_of(const Regions& regions, const Region& dot)
{
    constexpr int least_pixels = 12;
    constexpr double least_contrast = 2;
    constexpr double disc_ratio = 0.85; // the disc's area divided by the area inside it
    if (!dot.black || dot.pixels < least_pixels)
        return std::nullopt;
    const Region* ring = regions.left_of(dot);
    const Region* disc = ring && ring->holds(dot) ? regions.left_of(*ring) : nullptr;
    if (!disc || !disc->holds(*ring))
        return std::nullopt;
    const double ring_light = ring->light / ring->pixels;
    if (!(ring_light * dot.pixels > least_contrast * dot.light &&
          ring_light * disc->pixels > least_contrast * disc->light))
        return std::nullopt;
    const double inside = dot.pixels + ring->pixels, ratio = disc->pixels / inside / disc_ratio,
                 size = std::sqrt(inside), share = dot.pixels / inside;
    if (!(ratio > 0.55 && ratio < 1.8 && share > 0.05 && share < 0.65) ||
        length(dot.middle() - ring->middle()) > 0.15 * size ||
        length(dot.middle() - disc->middle()) > 0.15 * size)
        return std::nullopt;
    // An ellipse fills pi/4 of its bounding box if it is upright, and at least a third if not.
    const double box = double(disc->right - disc->left + 1) * (disc->bottom - disc->top + 1),
                 filled = (inside + disc->pixels) / box;
    if (!(filled > 0.3 && filled < 0.9))
        return std::nullopt;
    const double all = inside + disc->pixels;
    const Vec2 middle{(dot.sum_x + ring->sum_x + disc->sum_x) / all + 0.5,
                      (dot.sum_y + ring->sum_y + disc->sum_y) / all + 0.5};
    return Target{middle, share, int(all)};
}

/// Keeps the targets of at least an eighth of the largest one's size.
void drop_small(std::vector<Target>& targets)
{
    int most = 0;
    for (const Target& target : targets)
        most = std::max(most, target.pixels);
    targets.erase(std::remove_if(targets.begin(), targets.end(),
                                 [&](const Target& target) { return target.pixels < most / 8; }),
                  targets.end());
}

} // namespace

std::array<Vec2, 4> find_page_targets(const Plane& photo)
{
    constexpr int about_side = 2000;           // pixels that are searched
    constexpr double large_dot = 0.27;         // between both kinds' shares
    constexpr double largest_share = 1.0 / 80; // of a target in the photo; smaller on any page
    const int side = std::max(photo.width, photo.height),
              factor = std::max(1, int(std::lround(double(side) / about_side)));
    const Plane small = reduced(photo, factor), mean = local_mean(small, side / factor / 20);
    std::vector<char> black(small.values.size());
    for (std::size_t k = 0; k < black.size(); ++k)
        black[k] = small.values[k] < 0.75 * mean.values[k];
    const Regions regions = regions_of(black, small);
    std::vector<Target> targets;
    for (const Region& region : regions.all)
        if (const auto target = target_of(regions, region))
            if (target->pixels < largest_share * double(black.size()))
                targets.push_back(*target);
    drop_small(targets);
    const auto first = std::max_element(
        targets.begin(), targets.end(),
        [](const Target& a, const Target& b) { return a.dot_share < b.dot_share; });
    const auto large = std::count_if(targets.begin(), targets.end(),
                                     [&](const Target& t) { return t.dot_share > large_dot; });
    if (targets.size() != 4 || large != 1)
        throw std::invalid_argument(
            std::to_string(targets.size()) +
            " rings of a calibration page are visible instead of 4; photograph the whole page, "
            "sharp and without reflections on the rings");
    Vec2 middle;
    for (const Target& target : targets)
        middle = middle + 0.25 * target.middle;
    const auto angle = [&](const Target& target) {
        const Vec2 from = target.middle - middle, zero = first->middle - middle;
        const double turn = std::atan2(zero.x * from.y - zero.y * from.x, dot(zero, from));
        return turn < -1e-9 ? turn + 8 : turn; // the first one's angle is 0
    };
    std::vector<Target> sorted = targets;
    std::sort(sorted.begin(), sorted.end(),
              [&](const Target& a, const Target& b) { return angle(a) < angle(b); });
    std::array<Vec2, 4> found;
    for (int k = 0; k < 4; ++k)
        found[k] = double(factor) * sorted[k].middle;
    return found;
}

} // namespace integral
