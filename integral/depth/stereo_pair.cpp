// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/stereo_pair.h"

#include "integral/base/interrupt.h"
#include "integral/depth/averaged.h"
#include "integral/depth/depth_quality.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int coarse_width = 200; // pixels
constexpr double widest_part = 0.2;

/// The pair as a set whose middle view is the right picture, or the left one.
ViewSet pair_set(const Image& left, const Image& right, bool right_is_middle, int threads)
{
    ViewSet set = view_set({left, right}, {2, 1}, std::nullopt);
    if (!right_is_middle) {
        std::swap(set.middle, set.others[0]);
        set.middle.shift = {};
        set.others[0].shift = {-1, 0};
    }
    soften(set, threads);
    return set;
}

/// Two maps, and whether each pixel's match in the other map has the same disparity.
struct BothMaps {
    int width = 0, height = 0;
    std::vector<float> left, right;
    std::vector<char> left_known, right_known;
};

/// Whether each pixel's match has the same disparity. `way`: -1 from the left picture to the right
/// one, 1 back.
std::vector<char> known_pixels(const BothMaps& maps, const std::vector<float>& map,
                               const std::vector<float>& other, int way)
{
    constexpr float tolerance = 1; // pixels
    std::vector<char> known(map.size(), 0);
    for (int y = 0; y < maps.height; ++y)
        for (int x = 0; x < maps.width; ++x) {
            const std::size_t row = std::size_t(y) * std::size_t(maps.width);
            const float d = map[row + std::size_t(x)];
            const long match = std::lround(x + way * d);
            if (match >= 0 && match < maps.width)
                known[row + std::size_t(x)] = std::fabs(other[row + std::size_t(match)] - d) <=
                                              tolerance;
        }
    return known;
}

/// Clears pixels around which few pixels are known: matches by chance where the other picture hides
/// the surface.
void clear_chance(std::vector<char>& known, int width)
{
    constexpr int radius = 4; // pixels
    constexpr double least_part = 0.6;
    const int height = int(known.size()) / width;
    const std::vector<char> all = known;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            int count = 0, sum = 0;
            for (int j = std::max(0, y - radius); j <= std::min(height - 1, y + radius); ++j)
                for (int i = std::max(0, x - radius); i <= std::min(width - 1, x + radius); ++i) {
                    ++count;
                    sum += all[std::size_t(j) * std::size_t(width) + std::size_t(i)];
                }
            if (sum < least_part * count)
                known[std::size_t(y) * std::size_t(width) + std::size_t(x)] = 0;
        }
}

BothMaps measured(const Image& left, const Image& right, const MultibaselineSettings& settings,
                  int threads, const Progress& progress)
{
    BothMaps maps;
    for (const bool of_right : {false, true}) {
        const ViewSet set = pair_set(left, right, of_right, threads);
        const auto map = multibaseline(set, settings, threads, piece_of(progress, of_right, 2));
        if (!map)
            throw Interrupted();
        maps.width = map->width;
        maps.height = map->height;
        (of_right ? maps.right : maps.left) = map->disparity;
    }
    maps.left_known = known_pixels(maps, maps.left, maps.right, -1);
    maps.right_known = known_pixels(maps, maps.right, maps.left, 1);
    clear_chance(maps.left_known, maps.width);
    clear_chance(maps.right_known, maps.width);
    return maps;
}

/// The sorted disparities of the pixels that both pictures show.
std::vector<float> known_disparities(const BothMaps& maps)
{
    std::vector<float> known;
    for (std::size_t i = 0; i < maps.left.size(); ++i) {
        if (maps.left_known[i])
            known.push_back(maps.left[i]);
        if (maps.right_known[i])
            known.push_back(maps.right[i]);
    }
    std::sort(known.begin(), known.end());
    return known;
}

/// The range of sorted values without a part of them at each end.
DisparityRange range_without(const std::vector<float>& sorted, double part)
{
    const auto at = [&](double fraction) {
        return double(sorted[std::size_t(fraction * double(sorted.size() - 1))]);
    };
    return {at(part), at(1 - part)};
}

/// The range to search, from a coarse search of smaller pictures.
DisparityRange search_range(const Image& left, const Image& right, int threads,
                            const Progress& progress)
{
    constexpr double outliers = 0.005, margin = 1.5; // pixels
    const int factor = reduction(left, coarse_width);
    const Image small_left = averaged(left, factor, threads),
                small_right = averaged(right, factor, threads);
    const double widest = std::max(4.0, widest_part * small_left.width);
    MultibaselineSettings settings = settings_for(DepthQuality::draft);
    settings.range = DisparityRange{-widest, widest};
    const auto known = known_disparities(
        measured(small_left, small_right, settings, threads, progress));
    if (known.size() < std::size_t(small_left.width))
        return {-widest * factor, widest * factor};
    const DisparityRange range = range_without(known, outliers);
    return {factor * (range.least - margin), factor * (range.greatest + margin)};
}

/// Gives each unknown pixel the lesser disparity of the known ones next to it in its row.
void fill_from_farther(std::vector<float>& map, const std::vector<char>& known, int width)
{
    std::vector<float> after(static_cast<std::size_t>(width));
    for (std::size_t row = 0; row < map.size(); row += std::size_t(width)) {
        float next = HUGE_VALF;
        for (std::size_t x = std::size_t(width); x-- > 0;) {
            if (known[row + x])
                next = map[row + x];
            after[x] = next;
        }
        float before = HUGE_VALF;
        for (std::size_t x = 0; x < std::size_t(width); ++x) {
            if (known[row + x])
                before = map[row + x];
            else if (std::min(before, after[x]) < HUGE_VALF)
                map[row + x] = std::min(before, after[x]);
        }
    }
}

/// Replaces each unknown pixel by the median of the pixels above and below it, against streaks.
void smooth_filled(std::vector<float>& map, const std::vector<char>& known, int width)
{
    constexpr int radius = 8; // pixels
    const int height = int(map.size()) / width;
    const std::vector<float> filled = map;
    std::vector<float> column;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t at = std::size_t(y) * std::size_t(width) + std::size_t(x);
            if (known[at])
                continue;
            column.clear();
            for (int j = std::max(0, y - radius); j <= std::min(height - 1, y + radius); ++j)
                column.push_back(filled[std::size_t(j) * std::size_t(width) + std::size_t(x)]);
            const auto middle = column.begin() + std::ptrdiff_t(column.size() / 2);
            std::nth_element(column.begin(), middle, column.end());
            map[at] = *middle;
        }
}

/// Gives unknown pixels a depth behind their neighbours.
void complete(std::vector<float>& map, const std::vector<char>& known, int width)
{
    fill_from_farther(map, known, width);
    smooth_filled(map, known, width);
}

} // namespace

PairDisparity pair_disparity(const Image& left, const Image& right, int threads,
                             const Progress& progress)
{
    MultibaselineSettings settings = settings_for(DepthQuality::good);
    settings.range = search_range(left, right, threads, piece_of(progress, 0, 2));
    BothMaps maps = measured(left, right, settings, threads, piece_of(progress, 1, 2));
    const auto known = known_disparities(maps);
    PairDisparity pair;
    pair.range = known.empty() ? *settings.range : range_without(known, 0.05);
    pair.matched = double(known.size()) / double(2 * maps.left.size());
    complete(maps.left, maps.left_known, maps.width);
    complete(maps.right, maps.right_known, maps.width);
    pair.width = maps.width;
    pair.height = maps.height;
    pair.left = std::move(maps.left);
    pair.right = std::move(maps.right);
    return pair;
}

} // namespace integral
