// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/device_text.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace integral {
namespace {

constexpr double quarter_turn = 1.57079632679489661923;

void demand_success(cairo_status_t status)
{
    if (status == CAIRO_STATUS_INVALID_STRING)
        throw std::invalid_argument("a text of the page is not UTF-8");
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(std::string("the page's text cannot be drawn: ") +
                                 cairo_status_to_string(status));
}

/// A cairo drawing of one channel: the covered fraction of each pixel.
struct InkMask {
    cairo_surface_t* surface;
    cairo_t* context;

    InkMask(int width, int height)
        : surface(cairo_image_surface_create(CAIRO_FORMAT_A8, width, height)),
          context(cairo_create(surface))
    {
    }
    InkMask(const InkMask&) = delete;
    ~InkMask()
    {
        cairo_destroy(context);
        cairo_surface_destroy(surface);
    }
    void set_font(DeviceFont font)
    {
        // No hinting: letters are not fitted to pixels, so that their size is exact.
        cairo_font_options_t* options = cairo_font_options_create();
        cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
        cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
        cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
        cairo_set_font_options(context, options);
        cairo_font_options_destroy(options);
        cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                               font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(context, font.size);
    }
};

} // namespace

double text_width(const std::string& text, DeviceFont font)
{
    InkMask ruler(1, 1);
    // Measures at a large size, because cairo's widths are more exact there.
    constexpr double scale = 100;
    ruler.set_font({scale * font.size, font.bold});
    cairo_text_extents_t extents;
    cairo_text_extents(ruler.context, text.c_str(), &extents);
    demand_success(cairo_status(ruler.context));
    return extents.x_advance / scale;
}

/// Covers the image with black ink; the mask's left upper pixel lies on the image's pixel (x0, y0).
static void cover_with(const InkMask& ink, int x0, int y0, Image& image)
{
    const unsigned char* rows = cairo_image_surface_get_data(ink.surface);
    const int stride = cairo_image_surface_get_stride(ink.surface);
    const LinearReader light(image);
    for (int y = 0; y < cairo_image_surface_get_height(ink.surface); ++y)
        for (int x = 0; x < cairo_image_surface_get_width(ink.surface); ++x) {
            const float covered = rows[std::ptrdiff_t(y) * stride + x] / 255.0f;
            if (covered == 0)
                continue;
            const Colour under = light(x0 + x, y0 + y);
            const float rest = 1 - covered;
            store_linear(
                image, x0 + x, y0 + y,
                {rest * under.r, rest * under.g, rest * under.b, covered + rest * under.a});
        }
}

void write_text(Image& image, Vec2 pixel_pitch, const std::string& text, Vec2 at, DeviceFont font,
                bool upwards)
{
    // The box around the line; ascent and descent are at most 1.2 and 0.5 em.
    const double length = text_width(text, font) + font.size, ascent = 1.2 * font.size,
                 descent = 0.5 * font.size;
    const double left = at.x - (upwards ? ascent : 0), right = at.x + (upwards ? descent : length);
    const double top = at.y - (upwards ? length : ascent), bottom = at.y + (upwards ? 0 : descent);
    const int x0 = std::max(0, int(std::floor(left / pixel_pitch.x))),
              x1 = std::min(image.width, int(std::ceil(right / pixel_pitch.x)));
    const int y0 = std::max(0, int(std::floor(top / pixel_pitch.y))),
              y1 = std::min(image.height, int(std::ceil(bottom / pixel_pitch.y)));
    if (x0 >= x1 || y0 >= y1)
        return;

    InkMask ink(x1 - x0, y1 - y0);
    cairo_t* c = ink.context;
    cairo_translate(c, -x0, -y0);
    cairo_scale(c, 1 / pixel_pitch.x, 1 / pixel_pitch.y);
    cairo_translate(c, at.x, at.y);
    if (upwards)
        cairo_rotate(c, -quarter_turn);
    ink.set_font(font);
    cairo_move_to(c, 0, 0);
    cairo_text_path(c, text.c_str());
    cairo_fill(c);
    demand_success(cairo_status(c));
    cairo_surface_flush(ink.surface);

    cover_with(ink, x0, y0, image);
}

std::vector<std::string> wrapped(const std::string& text, double width, DeviceFont font)
{
    std::vector<std::string> lines;
    std::istringstream words(text);
    for (std::string word; words >> word;)
        if (!lines.empty() && text_width(lines.back() + " " + word, font) <= width)
            lines.back() += " " + word;
        else
            lines.push_back(word);
    return lines;
}

} // namespace integral
