// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/page.h"

#include "integral/base/number_text.h"
#include "integral/print/page_marks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

/// A length of the picture, in pixels, divided into tiles of one size; the last tile overlaps its
/// neighbour more if the length requires it.
struct Tiling {
    int size = 0;           ///< of a tile
    std::vector<int> first; ///< each tile's first pixel
};

/// Tiles of at most `room` pixels; neighbours share at least `overlap`.
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

constexpr double most_pixels = 1e6; // in any length of a page

/// Throws std::invalid_argument for a length of more than most_pixels pixels, which means that the
/// film's pixels are much smaller than any printer's.
void check_pixels(double mm, double pixel)
{
    if (mm / pixel > most_pixels)
        throw std::invalid_argument(
            with_digits(mm, 4) + " mm of a page are more than 1000000 pixels of " +
            with_digits(pixel, 4) + " mm: no printer has the frame's resolution");
}

/// A length in whole pixels, rounded up. Throws as check_pixels does.
int in_pixels(double mm, double pixel)
{
    check_pixels(mm, pixel);
    return int(std::ceil(mm / pixel - 1e-6));
}

constexpr double strip_height = 2.5, strip_margin = 3; // mm
constexpr double letter_width = 0.6;                   // em; more than a letter's average width

/// Places the strip's text below the picture, in smaller letters if the paper is too narrow.
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

/// One direction of the page, in pixels: its length, and the lengths to leave free before and after
/// the picture.
struct Extent {
    int page = 0, before = 0, after = 0;
    int room() const { return page - before - after; }
};

/// Both directions of the page, which has the paper's size, or room for picture and marks.
struct Space {
    Extent across, down;
};

Space space_of(const FrameMetadata& m, Vec2 pitch, const PageRequest& request)
{
    const double margin = marks_margin(request),
                 below = margin + (request.strip.empty() ? 0 : 2 * strip_height);
    Extent across{0, in_pixels(margin, pitch.x), in_pixels(margin, pitch.x)},
        down{0, in_pixels(margin, pitch.y), in_pixels(below, pitch.y)};
    const auto pixels_of_paper = [](double mm, double pixel) {
        check_pixels(mm, pixel);
        return int(std::lround(mm / pixel));
    };
    // To bring a lens to the page's middle, the picture moves by up to half a lens's cell.
    const Vec2 cell = request.centre_on_lens && margin > 0 ? cell_extent(m.sheet) : Vec2{0, 0};
    across.page = request.paper
                      ? pixels_of_paper(request.paper->width, pitch.x)
                      : across.before + m.film.width + across.after + in_pixels(cell.x, pitch.x);
    down.page = request.paper && !is_roll(*request.paper)
                    ? pixels_of_paper(request.paper->height, pitch.y)
                    : down.before + m.film.height + down.after + in_pixels(cell.y, pitch.y);
    return {across, down};
}

bool fits(const Space& space, const Film& film)
{
    return space.across.room() >= film.width && space.down.room() >= film.height;
}

/// Pixels of a page that has room for `pixels` pixels of the picture.
int page_needed(const Extent& extent, int pixels) { return extent.before + pixels + extent.after; }

/// A length in mm, rounded up to a tenth.
std::string rounded_up(double mm) { return with_decimals(std::ceil(10 * mm - 1e-6) / 10, 1); }

std::string paper_text(const std::optional<Paper>& paper)
{
    if (!paper)
        return "paper of its own size";
    const std::string width = with_digits(paper->width, 4);
    return is_roll(*paper) ? "a roll of " + width + " mm"
                           : "paper of " + width + " x " + with_digits(paper->height, 4) + " mm";
}

/// Throws std::invalid_argument if the picture, or its tiles, do not fit on the paper.
void check_room(const Space& space, const Film& film, Vec2 pitch, const PageRequest& request,
                int overlap_x, int overlap_y)
{
    const std::string paper = paper_text(request.paper);
    if (!fits(space, film) && !request.tiles) {
        const bool has_marks = marks_margin(request) > 0 || !request.strip.empty();
        const Vec2 needed{page_needed(space.across, film.width) * pitch.x,
                          page_needed(space.down, film.height) * pitch.y};
        throw std::invalid_argument(
            "a picture of " + with_digits(film.width * pitch.x, 4) + " x " +
            with_digits(film.height * pitch.y, 4) + " mm " + (has_marks ? "with its marks " : "") +
            "does not fit on " + paper + ": the page needs " + rounded_up(needed.x) + " x " +
            rounded_up(needed.y) + " mm; take larger or turned paper, or --tile");
    }
    const auto tileable = [](const Extent& extent, int pixels, int overlap) {
        return extent.room() >= pixels || extent.room() > 2 * overlap;
    };
    if (!tileable(space.across, film.width, overlap_x) ||
        !tileable(space.down, film.height, overlap_y))
        throw std::invalid_argument("tiles that overlap by " + with_digits(request.overlap, 4) +
                                    " mm do not fit on " + paper);
}

/// Place of the lens nearest to the film's middle, relative to that middle, in pixels of the film
/// (y downwards).
Vec2 middle_lens(const FrameMetadata& m)
{
    const Lattice lattice(m.sheet);
    Vec2 pole = lattice.pole(lattice.nearest({0, 0}));
    if (m.sheet.arrangement == Arrangement::lenticular) // the nearest point of its axis
        pole = dot(pole, lattice.across()) * lattice.across();
    return {pole.x / m.film.pixel_pitch.x, -pole.y / m.film.pixel_pitch.y};
}

/// Place on the page of the first pixel of a part of the picture (`size` pixels long). The point
/// `lens`, in pixels from the part's middle, comes as near to the page's middle as the marks allow.
int place_of(const Extent& extent, int size, double lens)
{
    const int begin = int(std::lround(0.5 * (extent.page - size) - lens));
    return std::clamp(begin, extent.before, extent.page - extent.after - size);
}

/// The rectangle without `trim` mm at each edge.
PixelRectangle without_edges(const PixelRectangle& r, double trim, Vec2 pitch)
{
    const int x = in_pixels(trim, pitch.x), y = in_pixels(trim, pitch.y);
    return {r.x + x, r.y + y, r.width - 2 * x, r.height - 2 * y};
}

PixelRectangle box_around(const PixelRectangle& a, const PixelRectangle& b)
{
    const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x,
            std::max(a.y + a.height, b.y + b.height) - y};
}

/// The page's part that remains after `trim` mm are cut off the edges of the whole picture.
PixelRectangle trimmed_part(const Page& page, const Film& film, double trim)
{
    const int cut_x = in_pixels(trim, page.pixel_pitch.x),
              cut_y = in_pixels(trim, page.pixel_pitch.y);
    const int left = page.part.x == 0 ? cut_x : 0,
              right = page.part.x + page.part.width == film.width ? cut_x : 0;
    const int top = page.part.y == 0 ? cut_y : 0,
              bottom = page.part.y + page.part.height == film.height ? cut_y : 0;
    return {page.x + left, page.y + top, page.part.width - left - right,
            page.part.height - top - bottom};
}

/// Sets what is cut out of a page: the whole picture, or each of its frames.
void set_frames(Page& page, const Film& film, const PageRequest& request)
{
    if (request.frames.empty())
        page.frames = {{{page.x, page.y, page.part.width, page.part.height},
                        trimmed_part(page, film, request.trim)}};
    for (const PlacedFrame& frame : request.frames) {
        PixelRectangle picture = frame.place;
        picture.x += page.x;
        picture.y += page.y;
        page.frames.push_back({picture, without_edges(picture, frame.trim, page.pixel_pitch)});
    }
    page.trimmed = page.frames[0].trimmed;
    for (std::size_t k = 0; k < page.frames.size(); ++k) {
        const PixelRectangle& left = page.frames[k].trimmed;
        if (left.width < 1 || left.height < 1)
            throw std::invalid_argument(
                "nothing is left of the picture when " +
                with_digits(request.frames.empty() ? request.trim : request.frames[k].trim, 4) +
                " mm are cut off all around");
        page.trimmed = box_around(page.trimmed, left);
    }
}

/// The strip's text on a page, with the page's number if there are several.
std::string strip_of(const Page& page, const std::string& text)
{
    const int pages = page.columns * page.rows, number = page.row * page.columns + page.column + 1;
    return pages == 1 ? text
                      : text + ", page " + std::to_string(number) + " of " + std::to_string(pages);
}

} // namespace

PixelSize room_on_paper(Vec2 pitch, const PageRequest& request)
{
    const Space space = space_of(FrameMetadata(), pitch, request);
    return {space.across.room(), is_roll(*request.paper) ? int(most_pixels) : space.down.room()};
}

std::vector<Page> lay_out(const FrameMetadata& m, Vec2 pitch, const PageRequest& request)
{
    const Film& film = m.film;
    const Space space = space_of(m, pitch, request);
    const double overlap = request.tiles ? request.overlap : 0;
    const int overlap_x = in_pixels(overlap, pitch.x), overlap_y = in_pixels(overlap, pitch.y);
    check_room(space, film, pitch, request, overlap_x, overlap_y);
    const Tiling columns = tiled(film.width, space.across.room(), overlap_x),
                 rows = tiled(film.height, space.down.room(), overlap_y);
    const Vec2 lens = request.centre_on_lens && fits(space, film) ? middle_lens(m) : Vec2{0, 0};
    std::vector<Page> pages;
    for (std::size_t j = 0; j < rows.first.size(); ++j)
        for (std::size_t i = 0; i < columns.first.size(); ++i) {
            Page page;
            page.width = space.across.page;
            page.height = space.down.page;
            page.pixel_pitch = pitch;
            page.part = {columns.first[i], rows.first[j], columns.size, rows.size};
            page.x = place_of(space.across, columns.size, lens.x);
            page.y = place_of(space.down, rows.size, lens.y);
            page.mirrored = request.mirrored;
            page.white = request.white;
            page.column = int(i);
            page.row = int(j);
            page.columns = int(columns.first.size());
            page.rows = int(rows.first.size());
            set_frames(page, film, request);
            if (!request.strip.empty())
                place_strip(page, marks_margin(request), strip_of(page, request.strip));
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
    // From the page's middle to the frame's: in pixels (y downwards), then in mm of the film.
    const double x = page.x - page.part.x + 0.5 * film.width - 0.5 * page.width,
                 y = page.y - page.part.y + 0.5 * film.height - 0.5 * page.height;
    g.shift = {x * film.pixel_pitch.x, -y * film.pixel_pitch.y};
    g.metadata.film.width = page.width;
    g.metadata.film.height = page.height;
    g.metadata.film.bleed = 0;
    g.metadata.sheet.offset = g.metadata.sheet.offset + g.shift;
    g.metadata.placement.reset();
    return g;
}

} // namespace integral
