// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures the loss of interpolated views, block by block of the film, so that neither all views
// nor a second frame have to be in memory.
#include "integral/compare/compare.h"
#include "integral/views/view_lenses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace integral {
namespace {

/// A part of the film, in pixels.
struct Block {
    int x, y, width, height;
};

/// The rectangle of pixels that a block of the film needs of each view. It contains column `right`
/// and row `bottom`.
struct Needed {
    int left = std::numeric_limits<int>::max(), top = left, right = -1, bottom = -1;
    int columns() const { return right - left + 1; }
    int rows() const { return bottom - top + 1; }
};

Needed needed_by(const Lenses& lenses, const Block& block)
{
    Needed needed;
    const auto take = [&](int x, int y, int channel) {
        const ViewPlace place = view_place(lenses, x, y, channel);
        needed.left = std::min(needed.left, place.column);
        needed.right = std::max(needed.right, place.column);
        needed.top = std::min(needed.top, place.row);
        needed.bottom = std::max(needed.bottom, place.row);
    };
    for (int y = block.y; y < block.y + block.height; ++y)
        for (int x = block.x; x < block.x + block.width; ++x)
            each_channel(lenses.film.subpixels, [&](int channel) {
                take(x, y, channel);
                return Colour{};
            });
    return needed;
}

/// The pixels that a block needs of all views, in one picture: the views side by side.
Image views_of_block(const Lenses& lenses, const LinearReader& light, const Image& frame,
                     const Needed& needed)
{
    const int columns = needed.columns();
    Image views = blank_like(frame, columns * lenses.grid.count(), needed.rows());
    for (int view = 0; view < lenses.grid.count(); ++view)
        for (int y = 0; y < needed.rows(); ++y)
            for (int x = 0; x < columns; ++x)
                if (const auto color = view_pixel(lenses, light, view, needed.left + x,
                                                  needed.top + y))
                    store_linear(views, view * columns + x, y, *color);
    return views;
}

/// Sum of the block's squared differences over channels and pixels.
double squares_of(const Lenses& lenses, const LinearReader& light, const Image& frame,
                  const Block& block)
{
    const Needed needed = needed_by(lenses, block);
    const Image views = views_of_block(lenses, light, frame, needed);
    const LinearReader light_of_views(views);
    const auto at = [&](int view, int column, int row) {
        return light_of_views(view * needed.columns() + column - needed.left, row - needed.top);
    };
    Image back = blank_like(frame, block.width, block.height);
    for (int y = 0; y < block.height; ++y)
        for (int x = 0; x < block.width; ++x)
            store_linear(back, x, y, film_pixel(lenses, block.x + x, block.y + y, at));
    const Frame there{part_of(frame, block.x, block.y, block.width, block.height), std::nullopt};
    const Frame again{std::move(back), std::nullopt};
    ComparisonSettings settings;
    settings.similarity = false;
    Comparer comparer(there, again, settings);
    comparer.add(there.image, again.image);
    const double rmse = comparer.result().rmse;
    return rmse * rmse * block.width * block.height * frame.channels;
}

} // namespace

std::optional<double> psnr_there_and_back(const Frame& frame, ViewGrid grid, int threads,
                                          const Progress& progress)
{
    const Lenses lenses(*frame.metadata, grid);
    if (lenses.exact)
        return std::numeric_limits<double>::infinity();
    const LinearReader light(frame.image);
    // If a lens has more views than pixels, the views are larger than the film, and blocks smaller.
    const ViewGrid natural = natural_views(*frame.metadata);
    const double views_a_pixel = double(grid.count()) / natural.count();
    constexpr double side_of_one = 512;
    const int side = int(
        std::clamp(side_of_one / std::sqrt(std::max(1.0, views_a_pixel)), 16.0, side_of_one));
    const int across = (lenses.film.width + side - 1) / side,
              down = (lenses.film.height + side - 1) / side;
    std::mutex mutex;
    double squares = 0;
    const auto work = [&](int k) {
        Block block{k % across * side, k / across * side, side, side};
        block.width = std::min(side, lenses.film.width - block.x);
        block.height = std::min(side, lenses.film.height - block.y);
        const double of_block = squares_of(lenses, light, frame.image, block);
        const std::lock_guard<std::mutex> lock(mutex);
        squares += of_block;
    };
    if (!for_each_row(across * down, threads, work, progress))
        return std::nullopt;
    const double values = double(lenses.film.width) * lenses.film.height * frame.image.channels;
    return squares == 0 ? std::numeric_limits<double>::infinity()
                        : -10 * std::log10(squares / values);
}

} // namespace integral
