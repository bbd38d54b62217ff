// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/plot_canvas.h"

#include "integral/base/constants.h"
#include "integral/io/markup.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <stdexcept>

#ifdef __SANITIZE_ADDRESS__
// fontconfig, which cairo uses, holds its fonts until the program ends, which LeakSanitizer reports
// as a leak.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

namespace integral {
namespace {

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length)
{
    try {
        static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
        return CAIRO_STATUS_SUCCESS;
    } catch (const std::exception&) { // no exception may pass through C code
        return CAIRO_STATUS_NO_MEMORY;
    }
}

void demand_success(cairo_status_t status)
{
    if (status == CAIRO_STATUS_INVALID_STRING)
        throw std::invalid_argument("a text of the plot is not UTF-8");
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(std::string("the plot cannot be drawn: ") +
                                 cairo_status_to_string(status));
}

/// Adds the accessible name to an SVG, and removes cairo's surface counter so that the same plot
/// always gives the same bytes.
std::string named(std::string svg, const std::string& title)
{
    if (const auto begin = svg.find(" id=\"surface"); begin != std::string::npos)
        svg.erase(begin, svg.find('"', begin + 5) + 1 - begin);
    if (const auto root = svg.find("<svg "); root != std::string::npos && !title.empty())
        if (const auto end = svg.find('>', root); end != std::string::npos)
            svg.insert(end + 1, "\n<title>" + markup_text(title) + "</title>");
    return svg;
}

} // namespace

struct PlotCanvas::Cairo {
    std::string bytes;
    PlotFormat format = PlotFormat::svg;
    cairo_surface_t* surface = nullptr;
    cairo_t* context = nullptr;
    ~Cairo()
    {
        cairo_destroy(context);
        cairo_surface_destroy(surface);
    }
    void set_ink(PlotInk ink, double opacity = 1)
    {
        cairo_set_source_rgba(context, ink.red, ink.green, ink.blue, opacity);
    }
    void trace(const std::vector<PlotPosition>& line)
    {
        cairo_new_path(context);
        for (const PlotPosition& p : line)
            cairo_line_to(context, p.x, p.y);
    }
};

PlotCanvas::PlotCanvas(int width, int height, PlotFormat format) : cairo_(std::make_unique<Cairo>())
{
    cairo_->format = format;
    if (format == PlotFormat::svg) {
        cairo_->surface = cairo_svg_surface_create_for_stream(append, &cairo_->bytes, width,
                                                              height);
        cairo_svg_surface_set_document_unit(cairo_->surface, CAIRO_SVG_UNIT_PX);
    } else
        cairo_->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    demand_success(cairo_surface_status(cairo_->surface));
    cairo_->context = cairo_create(cairo_->surface);
    cairo_t* c = cairo_->context;
    // No hinting, so that text has the same outlines and positions in both formats.
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(c, options);
    cairo_font_options_destroy(options);
    cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
    cairo_set_source_rgb(c, 1, 1, 1);
    cairo_paint(c);
}

PlotCanvas::~PlotCanvas() = default;

void PlotCanvas::stroke(const std::vector<PlotPosition>& line, PlotInk ink, double width,
                        bool dashed)
{
    if (line.size() < 2)
        return;
    cairo_->trace(line);
    cairo_->set_ink(ink);
    cairo_set_line_width(cairo_->context, width);
    const double dashes[] = {6, 4};
    cairo_set_dash(cairo_->context, dashes, dashed ? 2 : 0, 0);
    cairo_stroke(cairo_->context);
}

void PlotCanvas::fill_polygon(const std::vector<PlotPosition>& corners, PlotInk ink, double opacity)
{
    if (corners.size() < 3)
        return;
    cairo_->trace(corners);
    cairo_->set_ink(ink, opacity);
    cairo_fill(cairo_->context);
}

void PlotCanvas::mark(double x, double y, double radius, int kind, PlotInk ink)
{
    cairo_t* c = cairo_->context;
    struct Shape {
        int corners;
        double size, turn;
    }; // turn: fraction of a full circle, clockwise from the right
    static const Shape shapes[] = {{0, 1, 0},   {4, 1.25, 0.125}, {3, 1.4, 0.75},
                                   {4, 1.3, 0}, {3, 1.4, 0.25},   {5, 1.2, 0.75}};
    const Shape& shape = shapes[kind % int(std::size(shapes))];
    cairo_new_path(c);
    if (shape.corners == 0)
        cairo_arc(c, x, y, radius, 0, 2 * pi);
    for (int i = 0; i < shape.corners; ++i) {
        const double angle = 2 * pi * (shape.turn + double(i) / shape.corners);
        cairo_line_to(c, x + shape.size * radius * std::cos(angle),
                      y + shape.size * radius * std::sin(angle));
    }
    cairo_close_path(c);
    cairo_set_dash(c, nullptr, 0, 0);
    cairo_set_line_width(c, 2);
    cairo_set_source_rgb(c, 1, 1, 1);
    cairo_stroke_preserve(c);
    cairo_->set_ink(ink);
    cairo_fill(c);
}

void PlotCanvas::set_font(double size, bool bold)
{
    cairo_select_font_face(cairo_->context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_->context, size);
}

double PlotCanvas::text_width(const std::string& text)
{
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_->context, text.c_str(), &extents);
    demand_success(cairo_status(cairo_->context));
    return extents.x_advance;
}

void PlotCanvas::write(const std::string& text, double left, double baseline, PlotInk ink)
{
    // Draw text as plain paths: some SVG viewers do not support the symbols that cairo otherwise
    // writes.
    cairo_new_path(cairo_->context);
    cairo_move_to(cairo_->context, left, baseline);
    cairo_text_path(cairo_->context, text.c_str());
    demand_success(cairo_status(cairo_->context));
    cairo_->set_ink(ink);
    cairo_fill(cairo_->context);
}

void PlotCanvas::write_with_halo(const std::string& text, double left, double baseline, PlotInk ink)
{
    cairo_t* c = cairo_->context;
    cairo_new_path(c);
    cairo_move_to(c, left, baseline);
    cairo_text_path(c, text.c_str());
    cairo_set_dash(c, nullptr, 0, 0);
    cairo_set_line_width(c, 3);
    cairo_set_source_rgba(c, 1, 1, 1, 0.85);
    cairo_stroke(c);
    write(text, left, baseline, ink);
}

void PlotCanvas::write_upwards(const std::string& text, double baseline, double bottom, PlotInk ink)
{
    cairo_save(cairo_->context);
    cairo_translate(cairo_->context, baseline, bottom);
    cairo_rotate(cairo_->context, -0.5 * pi);
    write(text, 0, 0, ink);
    cairo_restore(cairo_->context);
}

void PlotCanvas::clip(const PlotBox& box)
{
    cairo_save(cairo_->context);
    cairo_rectangle(cairo_->context, box.left, box.top - 1, box.right - box.left + 1,
                    box.bottom - box.top + 2);
    cairo_clip(cairo_->context);
}

void PlotCanvas::unclip() { cairo_restore(cairo_->context); }

std::string PlotCanvas::finish(const std::string& title)
{
    demand_success(cairo_status(cairo_->context));
    if (cairo_->format == PlotFormat::png)
        demand_success(cairo_surface_write_to_png_stream(cairo_->surface, append, &cairo_->bytes));
    cairo_surface_finish(cairo_->surface);
    demand_success(cairo_surface_status(cairo_->surface));
    return cairo_->format == PlotFormat::svg ? named(cairo_->bytes, title) : cairo_->bytes;
}

} // namespace integral
