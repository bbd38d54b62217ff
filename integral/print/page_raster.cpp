// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/page_raster.h"

#include "integral/base/memory.h"
#include "integral/print/cairo_handles.h"
#include "integral/print/page_text.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace integral {
namespace {

/// Whether a shape from `top` to `bottom`, in pixels of the page, may have ink in the `rows` rows
/// from `first` on.
bool touches(double top, double bottom, int first, int rows)
{
    constexpr double margin = 2; // pixels that a line's width and ends add
    return bottom >= first - margin && top <= first + rows + margin;
}

void draw_lines(cairo_t* c, const Page& page, int first, int rows)
{
    constexpr double rounding = 1e-6; // error, in pixels, of converting to mm and back
    // Lines run through the middles of pixels; lines along rows and columns fill whole pixels.
    const auto x = [&](Vec2 p) { return std::floor(p.x / page.pixel_pitch.x + rounding) + 0.5; };
    const auto y = [&](Vec2 p) { return std::floor(p.y / page.pixel_pitch.y + rounding) + 0.5; };
    for (const PageLine& line : page.lines) {
        if (!touches(std::min(y(line.from), y(line.to)), std::max(y(line.from), y(line.to)), first,
                     rows))
            continue;
        cairo_move_to(c, x(line.from), y(line.from));
        cairo_line_to(c, x(line.to), y(line.to));
        cairo_stroke(c);
    }
}

void draw_strip(cairo_t* c, const Page& page, int first, int rows)
{
    constexpr double most_ems = 3; // em, bound on a letter's distance from the baseline
    const double base = page.strip_place.y / page.pixel_pitch.y;
    const double room_for_letters = most_ems * page.strip_size / page.pixel_pitch.y;
    if (page.strip.empty() ||
        !touches(base - room_for_letters, base + room_for_letters, first, rows))
        return;
    cairo_font_options_t* plain = cairo_font_options_create();
    cairo_font_options_set_antialias(plain, CAIRO_ANTIALIAS_NONE);
    cairo_set_font_options(c, plain);
    cairo_font_options_destroy(plain);
    select_strip_font(c, page, {1 / page.pixel_pitch.x, 1 / page.pixel_pitch.y});
    cairo_move_to(c, page.strip_place.x / page.pixel_pitch.x,
                  page.strip_place.y / page.pixel_pitch.y);
    cairo_show_text(c, page.strip.c_str());
}

using Draw = void (*)(cairo_t* c, const Page& page, int first, int rows);

/// For each pixel of some rows of a page, whether `draw` puts ink on it: row by row, not mirrored.
/// The page is drawn in pieces, because cairo allows at most 32767 pixels a side.
std::vector<bool> ink_of(const Page& page, int first, int rows, Draw draw)
{
    constexpr int most_columns = 8192;
    std::vector<bool> ink(std::size_t(page.width) * rows);
    for (int left = 0; left < page.width; left += most_columns) {
        const int columns = std::min(most_columns, page.width - left);
        const SurfaceHandle surface(cairo_image_surface_create(CAIRO_FORMAT_A8, columns, rows));
        const CairoHandle cairo(cairo_create(surface.get()));
        cairo_t* c = cairo.get();
        cairo_translate(c, -left, -first);
        cairo_set_antialias(c, CAIRO_ANTIALIAS_NONE);
        cairo_set_line_width(c, 1);
        cairo_set_line_cap(c, CAIRO_LINE_CAP_SQUARE);
        draw(c, page, first, rows);
        cairo_surface_flush(surface.get());
        const cairo_status_t status = cairo_status(c);
        if (status != CAIRO_STATUS_SUCCESS)
            throw std::runtime_error(std::string("its marks cannot be drawn: ") +
                                     cairo_status_to_string(status));
        const unsigned char* data = cairo_image_surface_get_data(surface.get());
        const int stride = cairo_image_surface_get_stride(surface.get());
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x)
                if (data[std::size_t(y) * stride + x] > 127)
                    ink[std::size_t(y) * page.width + left + x] = true;
    }
    return ink;
}

/// Paints pixels of `band`, the page's rows from row `first` on, that `draw` puts ink on, with the
/// bytes of `colour`.
void paint(const Page& page, int first, Draw draw, const std::vector<unsigned char>& colour,
           Image& band)
{
    const std::vector<bool> ink = ink_of(page, first, band.height, draw);
    for (int y = 0; y < band.height; ++y) {
        unsigned char* row = row_bytes(band, y);
        for (int x = 0; x < page.width; ++x)
            if (ink[std::size_t(y) * page.width + (page.mirrored ? page.width - 1 - x : x)])
                std::copy(colour.begin(), colour.end(), row + colour.size() * x);
    }
}

std::size_t pixel_bytes(const Image& form)
{
    return std::size_t(form.channels) * (sample_bits(form) / 8);
}

/// Copies pixels [first, first + width) of a row, in reverse order if `mirrored`.
void copy_pixels(const unsigned char* row, std::size_t pixel, int first, int width, bool mirrored,
                 unsigned char* to)
{
    row += pixel * first;
    if (!mirrored) {
        std::memcpy(to, row, pixel * width);
        return;
    }
    for (int x = 0; x < width; ++x)
        std::memcpy(to + pixel * x, row + pixel * (width - 1 - x), pixel);
}

/// Copies a frame's pixels to `band`, the page's rows from row `first` on. `part` holds the
/// picture's rows from the page's row `part_first` on.
void copy_frame(const Page& page, const PixelRectangle& frame, int first, const Image& part,
                int part_first, Image& band)
{
    const std::size_t pixel = pixel_bytes(band);
    const int begin = std::max(frame.y, part_first),
              end = std::min(frame.y + frame.height, part_first + part.height),
              left = page.mirrored ? page.width - frame.x - frame.width : frame.x;
    for (int y = begin; y < end; ++y)
        copy_pixels(row_bytes(part, y - part_first), pixel, page.part.x + frame.x - page.x,
                    frame.width, page.mirrored, row_bytes(band, y - first) + pixel * left);
}

/// Draws `band`, the page's rows from row `first` on. `part` holds the picture's rows that lie in
/// the band; its first row is the page's row `part_first`.
void draw_rows(const Page& page, int first, const Image& part, int part_first, Image& band)
{
    const std::size_t pixel = pixel_bytes(band);
    const bool inks = band.channels > 3;
    fill_with_paper(band, page.white);
    // Marks are of all inks, which shows whether the inks lie upon each other; text is of black.
    const std::size_t sample = pixel / std::size_t(band.channels);
    std::vector<unsigned char> mark(pixel, inks ? 0xff : 0), text(pixel, 0);
    if (inks)
        std::fill(text.begin() + std::ptrdiff_t(3 * sample),
                  page.white == WhiteInk::full ? text.end()
                                               : text.begin() + std::ptrdiff_t(4 * sample),
                  0xff);
    if (!page.lines.empty())
        paint(page, first, draw_lines, mark, band);
    if (!page.strip.empty())
        paint(page, first, draw_strip, text, band);
    for (const FrameOnPage& frame : page.frames) // paper between frames may have marks
        copy_frame(page, frame.picture, first, part, part_first, band);
}

} // namespace

void fill_with_paper(Image& image, WhiteInk white)
{
    const std::size_t pixel = pixel_bytes(image), sample = pixel / std::size_t(image.channels);
    for (int y = 0; y < image.height; ++y) {
        unsigned char* row = row_bytes(image, y);
        std::memset(row, image.channels > 3 ? 0 : 0xff, pixel * image.width);
        for (int x = 0; white == WhiteInk::full && x < image.width; ++x)
            std::memset(row + pixel * x + 4 * sample, 0xff, sample);
    }
}

PictureRows rows_in(const Image& picture)
{
    return [&picture](int first, int count) { return rows_of(picture, first, count); };
}

void draw_pages(const std::vector<Page>& pages, const Image& form, const PictureRows& picture,
                const TakeRows& take)
{
    const Page& like = pages.at(0); // the other pages differ only in their place across
    const int most = rows_of_a_band(
        form_of(sample_bits(form), like.width, like.height, form.channels, form.encoding));
    Image band;
    for (int first = 0; first < like.height; first += most) {
        const int end = std::min(first + most, like.height);
        const int part_first = std::clamp(like.y, first, end);
        const int part_end = std::clamp(like.y + like.part.height, part_first, end);
        Image part;
        if (part_end > part_first)
            part = picture(like.part.y + part_first - like.y, part_end - part_first);
        if (band.height != end - first)
            band = blank_like(form, like.width, end - first);
        for (std::size_t k = 0; k < pages.size(); ++k) {
            draw_rows(pages[k], first, part, part_first, band);
            take(k, band);
        }
    }
}

Image rasterized(const Page& page, const Image& form, const PictureRows& picture)
{
    check_memory(double(page.width) * page.height * double(pixel_bytes(form)));
    Image sheet = blank_like(form, page.width, page.height);
    int next = 0;
    draw_pages({page}, form, picture, [&](std::size_t, const Image& rows) {
        for (int y = 0; y < rows.height; ++y)
            std::memcpy(row_bytes(sheet, next++), row_bytes(rows, y),
                        pixel_bytes(form) * page.width);
    });
    return sheet;
}

void draw_part(const Page& page, const Image& form, const PictureRows& picture,
               const std::function<void(const Image& rows)>& take)
{
    const int most = rows_of_a_band(form);
    for (int first = 0; first < page.part.height; first += most) {
        const int count = std::min(most, page.part.height - first);
        const Image rows = picture(page.part.y + first, count);
        Image part = blank_like(form, page.part.width, count);
        for (int y = 0; y < count; ++y)
            copy_pixels(row_bytes(rows, y), pixel_bytes(form), page.part.x, page.part.width,
                        page.mirrored, row_bytes(part, y));
        take(part);
    }
}

} // namespace integral
