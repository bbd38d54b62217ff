// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/page.h"

#include "integral/base/number_text.h"
#include "integral/output/page_marks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

/// How a length of `pixels` is divided into tiles of at most `room`, of which neighbours share
/// `overlap`: the first pixels.
struct Tiling {
    int size = 0; ///< of a tile
    std::vector<int> first;
};

Tiling tiled(int pixels, int room, int overlap)
{
    if (room >= pixels)
        return {pixels, {0}};
    const int step = room - overlap;
    const int count = (pixels - overlap + step - 1) / step;
    Tiling tiling{room, {}};
    for (int k = 0; k < count; ++k)
        tiling.first.push_back(std::min(k * step, pixels - room));
    return tiling;
}

constexpr double most_pixels = 1e6; // of a page's side, and of any length on it

/// Throws for lengths that no page has: of a film whose pixels are much smaller than a printer's.
void check_pixels(double mm, double pixel)
{
    if (mm / pixel > most_pixels)
        throw std::invalid_argument(
            with_digits(mm, 4) + " mm of a page are more than 1000000 pixels of " +
            with_digits(pixel, 4) + " mm: no printer has the frame's resolution");
}

int in_pixels(double mm, double pixel)
{
    check_pixels(mm, pixel);
    return int(std::ceil(mm / pixel - 1e-6));
}

constexpr double strip_height = 2.5, strip_margin = 3; // mm
constexpr double letter_width = 0.6;                   // of the em; letters are narrower on average

/// The strip below the picture, smaller where the paper is too narrow for it.
void place_strip(Page& page, double below_picture, const std::string& text)
{
    const double width = page.width * page.pixel_pitch.x, left = page.x * page.pixel_pitch.x;
    const double em = std::min(strip_height, std::max(width - 2 * strip_margin, 0.5 * width) /
                                                 (letter_width * double(text.size())));
    const double length = em * letter_width * double(text.size());
    page.strip = text;
    page.strip_size = em;
    page.strip_place = {
        std::max(std::min(left, width - strip_margin - length), std::min(strip_margin, left)),
        (page.y + page.part.height) * page.pixel_pitch.y + below_picture + 1.5 * strip_height};
}

/// One direction of the page: its pixels, and what has to stay free beside the picture before and
/// after it.
struct Extent {
    int page = 0, before = 0, after = 0;
    int room() const { return page - before - after; }
};

} // namespace

std::vector<Page> lay_out(const FrameMetadata& m, Vec2 pitch, const PageRequest& request)
{
    const Film& film = m.film;
    const double margin = marks_margin(request),
                 below = margin + (request.strip.empty() ? 0 : 2 * strip_height);
    Extent across{0, in_pixels(margin, pitch.x), in_pixels(margin, pitch.x)},
        down{0, in_pixels(margin, pitch.y), in_pixels(below, pitch.y)};
    if (request.paper) {
        check_pixels(request.paper->width, pitch.x);
        check_pixels(request.paper->height, pitch.y);
        across.page = int(std::lround(request.paper->width / pitch.x));
        down.page = int(std::lround(request.paper->height / pitch.y));
    } else {
        // Room for the lens at the middle: half a lens's cell on either side.
        const Vec2 cell = request.centre_on_lens ? cell_extent(m.sheet) : Vec2{0, 0};
        across.page = across.before + film.width + across.after +
                      (margin > 0 ? in_pixels(cell.x, pitch.x) : 0);
        down.page = down.before + film.height + down.after +
                    (margin > 0 ? in_pixels(cell.y, pitch.y) : 0);
    }
    const double overlap = request.tiles ? request.overlap : 0;
    const int overlap_x = in_pixels(overlap, pitch.x), overlap_y = in_pixels(overlap, pitch.y);
    const bool fits = across.room() >= film.width && down.room() >= film.height;
    const std::string paper = request.paper ? with_digits(request.paper->width, 4) + " x " +
                                                  with_digits(request.paper->height, 4) + " mm"
                                            : "its own size";
    if (!fits && !request.tiles)
        throw std::invalid_argument("a picture of " + with_digits(film.width * pitch.x, 4) + " x " +
                                    with_digits(film.height * pitch.y, 4) + " mm " +
                                    (margin > 0 || below > 0 ? "with its marks " : "") +
                                    "does not fit on paper of " + paper + ", which leaves " +
                                    with_digits(std::max(0, across.room()) * pitch.x, 4) + " x " +
                                    with_digits(std::max(0, down.room()) * pitch.y, 4) +
                                    " mm; larger or turned paper would do, or --tile");
    const auto tileable = [](const Extent& extent, int pixels, int overlap) {
        return extent.room() >= pixels || extent.room() > 2 * overlap;
    };
    if (!tileable(across, film.width, overlap_x) || !tileable(down, film.height, overlap_y))
        throw std::invalid_argument("tiles that overlap by " + with_digits(request.overlap, 4) +
                                    " mm do not fit on paper of " + paper);
    const Tiling columns = tiled(film.width, across.room(), overlap_x),
                 rows = tiled(film.height, down.room(), overlap_y);

    // The lens nearest to the middle of the film, pixels from the film's middle.
    Vec2 lens{0, 0};
    if (request.centre_on_lens && fits) {
        const Lattice lattice(m.sheet);
        Vec2 pole = lattice.pole(lattice.nearest({0, 0}));
        if (m.sheet.arrangement == Arrangement::lenticular) // the nearest point of its axis
            pole = dot(pole, lattice.across()) * lattice.across();
        lens = {pole.x / film.pixel_pitch.x, -pole.y / film.pixel_pitch.y};
    }
    std::vector<Page> pages;
    for (std::size_t j = 0; j < rows.first.size(); ++j)
        for (std::size_t i = 0; i < columns.first.size(); ++i) {
            Page page;
            page.width = across.page;
            page.height = down.page;
            page.pixel_pitch = pitch;
            page.part = {columns.first[i], rows.first[j], columns.size, rows.size};
            const auto place = [](const Extent& extent, int size, double off) {
                const int middle = int(std::lround(0.5 * (extent.page - size) - off));
                return std::clamp(middle, extent.before, extent.page - extent.after - size);
            };
            page.x = place(across, columns.size, lens.x);
            page.y = place(down, rows.size, lens.y);
            page.mirrored = request.mirrored;
            page.column = int(i);
            page.row = int(j);
            page.columns = int(columns.first.size());
            page.rows = int(rows.first.size());
            // Only the picture's own edges are trimmed.
            const int cut_x = in_pixels(request.trim, pitch.x),
                      cut_y = in_pixels(request.trim, pitch.y);
            const int left = page.part.x == 0 ? cut_x : 0,
                      right = page.part.x + page.part.width == film.width ? cut_x : 0;
            const int top = page.part.y == 0 ? cut_y : 0,
                      bottom = page.part.y + page.part.height == film.height ? cut_y : 0;
            page.trimmed = {page.x + left, page.y + top, page.part.width - left - right,
                            page.part.height - top - bottom};
            if (page.trimmed.width < 1 || page.trimmed.height < 1)
                throw std::invalid_argument("nothing is left of the picture when " +
                                            with_digits(request.trim, 4) +
                                            " mm are cut off all around");
            if (!request.strip.empty())
                place_strip(page, margin,
                            request.strip +
                                (page.columns * page.rows == 1
                                     ? ""
                                     : ", page " + std::to_string(pages.size() + 1) + " of " +
                                           std::to_string(page.columns * page.rows)));
            page.lines = page_marks(page, m, request);
            pages.push_back(page);
        }
    return pages;
}

std::optional<PageGeometry> geometry_of(const Page& page, const FrameMetadata& frame)
{
    if (page.mirrored)
        return std::nullopt;
    PageGeometry g{frame, {}};
    const Film& film = frame.film;
    // From the page's middle to that of the frame, in pixels (y downwards), then in mm of the film.
    const double x = page.x - page.part.x + 0.5 * film.width - 0.5 * page.width,
                 y = page.y - page.part.y + 0.5 * film.height - 0.5 * page.height;
    g.shift = {x * film.pixel_pitch.x, -y * film.pixel_pitch.y};
    g.metadata.film.width = page.width;
    g.metadata.film.height = page.height;
    g.metadata.sheet.offset = g.metadata.sheet.offset + g.shift;
    g.metadata.placement.reset();
    return g;
}

} // namespace integral
