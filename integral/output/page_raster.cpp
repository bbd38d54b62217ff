// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/page_raster.h"

#include "integral/io/memory.h"

#include <cairo.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace integral {
namespace {

/// Marks and strip: of each pixel, row by row, whether it is black. Not mirrored.
std::vector<bool> ink_of(const Page& page)
{
    const auto release = [](auto* object) {
        if constexpr (std::is_same_v<decltype(object), cairo_t*>)
            cairo_destroy(object);
        else
            cairo_surface_destroy(object);
    };
    const std::unique_ptr<cairo_surface_t, decltype(release)> surface(
        cairo_image_surface_create(CAIRO_FORMAT_A8, page.width, page.height), release);
    const std::unique_ptr<cairo_t, decltype(release)> cairo(cairo_create(surface.get()), release);
    cairo_t* c = cairo.get();
    cairo_set_antialias(c, CAIRO_ANTIALIAS_NONE);
    cairo_set_line_width(c, 1);
    cairo_set_line_cap(c, CAIRO_LINE_CAP_SQUARE);
    constexpr double rounding = 1e-6; // of places that are whole pixels, in mm and back
    for (const PageLine& line : page.lines) {
        // Through the middles of pixels, which lines along rows and columns then fill.
        const auto x = [&](Vec2 p) { return std::floor(p.x / page.pixel_pitch.x + rounding) + 0.5; };
        const auto y = [&](Vec2 p) { return std::floor(p.y / page.pixel_pitch.y + rounding) + 0.5; };
        cairo_move_to(c, x(line.from), y(line.from));
        cairo_line_to(c, x(line.to), y(line.to));
        cairo_stroke(c);
    }
    if (!page.strip.empty()) {
        cairo_font_options_t* plain = cairo_font_options_create();
        cairo_font_options_set_antialias(plain, CAIRO_ANTIALIAS_NONE);
        cairo_set_font_options(c, plain);
        cairo_font_options_destroy(plain);
        cairo_select_font_face(c, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        cairo_matrix_t size;
        cairo_matrix_init_scale(&size, page.strip_size / page.pixel_pitch.x, page.strip_size / page.pixel_pitch.y);
        cairo_set_font_matrix(c, &size);
        // A font of broad letters, or capitals, would run over the paper's edge.
        cairo_text_extents_t extents;
        cairo_text_extents(c, page.strip.c_str(), &extents);
        const double room = page.width - page.strip_place.x / page.pixel_pitch.x;
        if (extents.x_advance > 0.98 * room) {
            size.xx *= 0.98 * room / extents.x_advance;
            cairo_set_font_matrix(c, &size);
        }
        cairo_move_to(c, page.strip_place.x / page.pixel_pitch.x, page.strip_place.y / page.pixel_pitch.y);
        cairo_show_text(c, page.strip.c_str());
    }
    cairo_surface_flush(surface.get());
    const cairo_status_t status = cairo_status(c);
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(std::string("its marks cannot be drawn: ") + cairo_status_to_string(status));
    const unsigned char* data = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    std::vector<bool> ink(std::size_t(page.width) * page.height);
    for (int y = 0; y < page.height; ++y)
        for (int x = 0; x < page.width; ++x)
            ink[std::size_t(y) * page.width + x] = data[std::size_t(y) * stride + x] > 127;
    return ink;
}

} // namespace

Image picture_on(const Page& page, const Image& picture)
{
    const Image part = part_of(picture, page.part.x, page.part.y, page.part.width, page.part.height);
    if (!page.mirrored)
        return part;
    Image turned = blank_like(part, part.width, part.height);
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x)
            store_pixel(turned, x, y, stored_pixel(part, part.width - 1 - x, y));
    return turned;
}

Image rasterized(const Page& page, const Image& picture)
{
    check_memory(double(page.width) * page.height * picture.channels * (sample_bits(picture) / 8));
    Image sheet = blank_like(picture, page.width, page.height);
    const std::vector<bool> ink = page.lines.empty() && page.strip.empty() ? std::vector<bool>(std::size_t(page.width) * page.height) : ink_of(page);
    const Image part = picture_on(page, picture);
    const int left = page.mirrored ? page.width - page.x - part.width : page.x;
    for (int y = 0; y < page.height; ++y)
        for (int x = 0; x < page.width; ++x) {
            const bool black = ink[std::size_t(y) * page.width + (page.mirrored ? page.width - 1 - x : x)];
            const bool inside = x >= left && x < left + part.width && y >= page.y && y < page.y + part.height;
            const float paper = black ? 0.0f : 1.0f;
            store_pixel(sheet, x, y, inside ? stored_pixel(part, x - left, y - page.y) : Color{paper, paper, paper, 1});
        }
    return sheet;
}

} // namespace integral
