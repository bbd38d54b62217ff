// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/page_text.h"

#include "integral/base/number_text.h"
#include "integral/print/cairo_handles.h"

#include <stdexcept>

namespace integral {

void select_strip_font(cairo_t* c, const Page& page, Vec2 scale)
{
    cairo_select_font_face(c, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_matrix_t size;
    cairo_matrix_init_scale(&size, page.strip_size * scale.x, page.strip_size * scale.y);
    cairo_set_font_matrix(c, &size);
    cairo_text_extents_t extents;
    cairo_text_extents(c, page.strip.c_str(), &extents);
    const double room = (page.width * page.pixel_pitch.x - page.strip_place.x) * scale.x;
    if (extents.x_advance > 0.98 * room) {
        size.xx *= 0.98 * room / extents.x_advance;
        cairo_set_font_matrix(c, &size);
    }
}

std::string strip_outlines(const Page& page)
{
    if (page.strip.empty())
        return "";
    constexpr double points_per_mm = 72 / 25.4;
    constexpr double fine = 100; // cairo rounds a path to 1/256 of a unit
    const double scale = points_per_mm * fine;
    const double bottom = page.height * page.pixel_pitch.y * points_per_mm;
    // Unbounded: cairo leaves letters outside a surface out of a path.
    const SurfaceHandle surface(cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, nullptr));
    const CairoHandle cairo(cairo_create(surface.get()));
    cairo_t* c = cairo.get();
    select_strip_font(c, page, {scale, scale});
    cairo_move_to(c, page.strip_place.x * scale, page.strip_place.y * scale);
    cairo_text_path(c, page.strip.c_str());
    struct Release {
        void operator()(cairo_path_t* path) const { cairo_path_destroy(path); }
    };
    const std::unique_ptr<cairo_path_t, Release> path(cairo_copy_path(c));
    if (path->status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(std::string("its strip cannot be drawn: ") +
                                 cairo_status_to_string(path->status));
    std::string text;
    const auto add = [&](const cairo_path_data_t* data, int points, const char* operation) {
        for (int k = 1; k <= points; ++k)
            text += with_decimals(data[k].point.x / fine, 3) + " " +
                    with_decimals(bottom - data[k].point.y / fine, 3) + " ";
        text += operation;
    };
    for (int k = 0; k < path->num_data; k += path->data[k].header.length) {
        const cairo_path_data_t* data = path->data + k;
        switch (data->header.type) {
        case CAIRO_PATH_MOVE_TO: add(data, 1, "m\n"); break;
        case CAIRO_PATH_LINE_TO: add(data, 1, "l\n"); break;
        case CAIRO_PATH_CURVE_TO: add(data, 3, "c\n"); break;
        case CAIRO_PATH_CLOSE_PATH: add(data, 0, "h\n"); break;
        }
    }
    return text + "f\n";
}

} // namespace integral
