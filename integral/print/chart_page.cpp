// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/chart_page.h"

#include "integral/base/number_text.h"
#include "integral/frame/names.h"
#include "integral/io/image_file.h"
#include "integral/optics/visual_pitch.h"
#include "integral/print/colour_profile.h"
#include "integral/print/page_pdf.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral {
namespace {

constexpr int bars_lenticular = 25, bars_2d = 15;
constexpr double neighbours = 0.125; // bands along a bar by which neighbouring bars differ

/// A round number (1, 2 or 5 and zeros) near a value.
double rounded_step(double value)
{
    const double power = std::pow(10, std::floor(std::log10(value))), digits = value / power;
    return power * (digits < 1.5 ? 1 : digits < 3.5 ? 2 : digits < 7.5 ? 5 : 10);
}

std::string reading_command(const PitchChart& chart)
{
    return "Read it by: integral print --even BAR,BAR@MM --pitch-range " +
           with_digits(chart.scale.first, 9) + "," +
           with_digits(film_pitch(chart.scale, chart.scale.bars), 9) + " --bars " +
           std::to_string(chart.scale.bars) + " " + sheet_options(chart.sheet) + " " +
           film_option(chart.film);
}

/// The filling_aperture for a distance, or an unlimited aperture if there is none.
Aperture aperture_for(const LensSheet& sheet, double distance)
{
    const auto filling = filling_aperture(sheet, distance);
    if (filling)
        return *filling;
    Aperture open;
    open.distance = distance;
    open.width = open.height = std::numeric_limits<double>::infinity();
    return open;
}

} // namespace

std::string sheet_options(const LensSheet& sheet)
{
    return std::string("--arrangement ") + name_of(sheet.arrangement) + " --pitch " +
           with_digits(sheet.pitch, 9) + " --thickness " + with_digits(sheet.thickness, 9) +
           " --ior " + with_digits(sheet.ior, 9) +
           (sheet.slant != 0 ? " --slant " + with_digits(sheet.slant, 9) : "");
}

std::string film_option(const Film& film)
{
    const double dpi_x = mm_per_inch / film.pixel_pitch.x, dpi_y = mm_per_inch / film.pixel_pitch.y;
    const std::string across = with_digits(dpi_x, 9), down = with_digits(dpi_y, 9);
    return "--dpi " + across + (down == across ? "" : "," + down);
}

FrameMetadata chart_geometry(FrameMetadata geometry, double distance)
{
    geometry.sheet.offset = {};
    geometry.aperture = aperture_for(geometry.sheet, distance);
    geometry.placement.reset();
    geometry.render.reset();
    geometry.encoding = {};
    return geometry;
}

int default_bars(const LensSheet& sheet)
{
    return sheet.arrangement == Arrangement::lenticular ? bars_lenticular : bars_2d;
}

double default_step(const LensSheet& sheet, const Film& film, double distance)
{
    PitchChart one; // a chart of a single bar in each direction
    one.sheet = sheet;
    one.film = film;
    one.scale = {visual_pitch(sheet.pitch, sheet, distance), 1, 1};
    double length = std::numeric_limits<double>::infinity();
    for (const ChartBar& bar : chart_bars(one))
        length = std::min(length, bar.upright ? bar.height * film.pixel_pitch.y
                                              : bar.width * film.pixel_pitch.x);
    return rounded_step(neighbours * sheet.pitch * sheet.pitch / length);
}

PitchScale scale_about(const LensSheet& sheet, double distance, double step, int bars)
{
    const double middle = visual_pitch(sheet.pitch, sheet, distance);
    return {step * std::round(middle / step - (bars - 1) / 2), step, bars};
}

ChartPage chart_page(FrameMetadata geometry, const PitchScale& scale, double distance)
{
    geometry = chart_geometry(std::move(geometry), distance);
    PitchChart chart;
    chart.sheet = geometry.sheet;
    chart.film = geometry.film;
    chart.scale = scale;
    chart.note = reading_command(chart);
    ChartPage made{{pitch_chart(chart), std::nullopt}, chart.note};
    set_metadata(made.frame, geometry);
    return made;
}

void write_chart(const std::string& path, const Frame& chart, const std::string& title)
{
    if (extension_of(path) != "pdf") {
        write_frame(path, chart);
        return;
    }
    PageRequest whole;
    whole.centre_on_lens = false;
    const Vec2 pixel_pitch = chart.metadata->film.pixel_pitch;
    OutputFile file(path);
    write_pdf(file, lay_out(*chart.metadata, pixel_pitch, whole), form_of(chart.image),
              rows_in(chart.image), srgb_profile(), title);
    file.finish();
}

FrameMetadata corrected_sheet(FrameMetadata geometry, const MeasuredSheet& found)
{
    geometry.sheet.pitch = found.pitch.value;
    geometry.sheet.ior = found.index.value;
    geometry.aperture = aperture_for(geometry.sheet, geometry.aperture.distance);
    geometry.placement.reset();
    geometry.render.reset();
    geometry.film.width = geometry.film.height = 0;
    return geometry;
}

} // namespace integral
