// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/print_chart.h"

#include "integral/base/json.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/print/calibration_page.h"
#include "integral/print/pitch_report.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int most_bars = 1000;
constexpr double most_pixels = 5e8;
constexpr char default_page[] = "152.4x101.6";    // 4x6 inches
constexpr char default_calibration_page[] = "210x297";
constexpr char default_page_2d[] = "203.2x152.4"; // 6x8 inches: two blocks of bars

/// Sets the film's size in pixels from --page, or else `otherwise`, unless --size is given.
void set_page(const std::optional<std::string>& page, const char* otherwise, Film& film)
{
    if (page && film.width > 0)
        throw UsageError("--page and --size say the same; give one of them");
    if (film.width == 0)
        set_film_size("page", page.value_or(otherwise), film);
    if (double(film.width) * film.height > most_pixels)
        throw UsageError("the page has more than 500 million pixels; take a smaller one");
}

void set_page(const PrintOptions& o, const LensSheet& sheet, Film& film)
{
    set_page(o.page, sheet.arrangement == Arrangement::lenticular ? default_page : default_page_2d,
             film);
}

/// The nominal geometry of a chart.
FrameMetadata nominal_geometry_of(const PrintOptions& o)
{
    if (!o.inputs.empty())
        throw UsageError("a pitch chart has no FRAME; --sheet FILE.json gives the nominal sheet");
    return nominal_geometry(o.start, o.sheet, o.film);
}

/// Number of bars in each direction.
int bars_of(const PrintOptions& o, const LensSheet& sheet)
{
    return o.bars ? in_range("bars", *o.bars, 2, most_bars) : default_bars(sheet);
}

/// The scale of --pitch-range with --pitch-step or --bars.
PitchScale scale_of_range(const PrintOptions& o, const LensSheet& sheet)
{
    const std::string range = *o.pitch_range;
    const auto ends = parse_numbers("pitch-range", range, "A,B, in mm,", 2, 2);
    if (!(ends[0] > 0 && ends[1] > ends[0] && ends[1] <= 1e3))
        throw UsageError("--pitch-range " + range +
                         ": two pitches, the smaller first, up to 1000 mm are expected");
    if (o.pitch_step && o.bars)
        throw UsageError("--pitch-range goes with --pitch-step or with --bars, not with both");
    if (!o.pitch_step) {
        const int count = bars_of(o, sheet);
        return {ends[0], (ends[1] - ends[0]) / (count - 1), count};
    }
    const double step = parse_number("pitch-step", *o.pitch_step, "a number");
    const double count = (ends[1] - ends[0]) / step;
    if (!(step > 0 && count < most_bars && std::fabs(count - std::round(count)) < 1e-6))
        throw UsageError("--pitch-step " + *o.pitch_step + ": a part of --pitch-range " + range +
                         " is expected, at most " + std::to_string(most_bars - 1) + " steps");
    return {ends[0], step, int(std::lround(count)) + 1};
}

/// The scale of the chart that these options make, or with which the measured chart was made.
PitchScale scale_of(const PrintOptions& o, const FrameMetadata& nominal)
{
    const LensSheet& sheet = nominal.sheet;
    if (o.pitch_range)
        return scale_of_range(o, sheet);
    Film film = nominal.film;
    set_page(o, sheet, film);
    const int bars = bars_of(o, sheet);
    const double step = o.pitch_step ? parse_number("pitch-step", *o.pitch_step, "a number")
                                     : default_step(sheet, film, chart_distance(o.distance));
    const PitchScale scale = scale_about(sheet, chart_distance(o.distance), step, bars);
    if (!(scale.step > 0 && scale.first > 0))
        throw_usage("pitch-step", o.pitch_step.value_or(""), "a small part of the pitch");
    return scale;
}

/// One --even: BAR[,BAR...]@DISTANCE.
ChartReading parse_reading(const std::string& text)
{
    constexpr char form[] = "BAR,BAR@DISTANCE, as 12,13@400,";
    const auto at = text.find('@');
    if (at == std::string::npos)
        throw_usage("even", text, form);
    ChartReading reading;
    for (const double bar : parse_numbers("even", text.substr(0, at), form, 1, 2 * most_bars)) {
        if (!(bar == std::floor(bar) && bar >= 1 && bar <= 2 * most_bars))
            throw_usage("even", text, form);
        reading.bars.push_back(int(bar));
    }
    reading.distance = parse_number("even", text.substr(at + 1), form);
    if (!(reading.distance >= 1e-2 && reading.distance <= 1e9))
        throw_usage("even", text, "a distance of 0.01 to 1e9 mm");
    return reading;
}

/// The readings of --even. Throws UsageError for bars that are not on the chart.
std::vector<ChartReading> readings_of(const PrintOptions& o, const LensSheet& sheet,
                                      const PitchScale& scale)
{
    std::vector<ChartReading> readings;
    for (const std::string& text : *o.even)
        readings.push_back(parse_reading(text));
    if (sheet.arrangement != Arrangement::lenticular)
        return readings; // the bars of a second direction have higher numbers
    for (const ChartReading& reading : readings)
        for (const int bar : reading.bars)
            if (bar > scale.bars)
                throw UsageError("--even: bar " + std::to_string(bar) + " is not on a chart of " +
                                 std::to_string(scale.bars) + " bars");
    return readings;
}

int read_chart(const PrintOptions& o)
{
    const FrameMetadata geometry = nominal_geometry_of(o);
    const PitchScale scale = scale_of(o, geometry);
    const std::vector<ChartReading> readings = readings_of(o, geometry.sheet, scale);
    const MeasuredSheet found = usage_checked(
        "--even: ", [&] { return measured_sheet(geometry.sheet, scale, readings, o.keep_index); });
    const std::string report = o.json ? pitch_report_json(scale, readings, found).dump(2) + "\n"
                                      : pitch_report_text(geometry.sheet, scale, readings, found);
    const std::string output = o.output.value_or("");
    if (!output.empty())
        write_file(output, to_json(corrected_sheet(geometry, found)));
    if (output != "-")
        write_file("-", report);
    return exit_done;
}

} // namespace

FrameMetadata nominal_geometry(const std::optional<std::string>& start, const SheetOptions& sheet,
                               const FilmOptions& film)
{
    FrameMetadata geometry = start.value_or("").empty() ? default_geometry()
                                                        : read_metadata(*start);
    geometry.film.width = geometry.film.height = 0;
    geometry.film.bleed = 0; // charts and sheets have none
    change_sheet(sheet, geometry.sheet);
    change_film(film, geometry.film);
    check_geometry(geometry);
    return geometry;
}

void set_calibration_page(const std::optional<std::string>& page, Film& film)
{
    set_page(page, default_calibration_page, film);
}

double chart_distance(const std::optional<std::string>& distance)
{
    return distance ? parse_number_between("distance", *distance, "mm", 10, 1e6, "10 to 1000000 mm")
                    : default_chart_distance;
}

ChartPage chart_of(const PrintOptions& o)
{
    FrameMetadata geometry = nominal_geometry_of(o);
    if (o.calibration) {
        throw_if_given({{"pitch-range", o.pitch_range},
                        {"pitch-step", o.pitch_step},
                        {"bars", o.bars},
                        {"offset", o.sheet.offset}},
                       "is for --chart, not for --calibration");
        set_calibration_page(o.page, geometry.film);
        return calibration_page(geometry, chart_distance(o.distance));
    }
    geometry.sheet.offset = {};
    const PitchScale scale = scale_of(o, geometry);
    set_page(o, geometry.sheet, geometry.film);
    return chart_page(geometry, scale, chart_distance(o.distance));
}

int make_chart(const PrintOptions& o)
{
    if (o.chart + o.calibration + o.even.has_value() > 1)
        throw UsageError("--chart and --calibration make a page and --even reads a chart; give one "
                         "of them");
    if (o.even)
        return read_chart(o);
    const std::string output = needed_output(o.output, "FILE");
    if (extension_of(output) != "pdf")
        format_for(output);
    check_writable(output);
    const ChartPage chart = chart_of(o);
    write_chart(output, chart.frame, o.calibration ? "calibration page" : "pitch chart");
    if (output != "-")
        write_file("-", chart.reading + "\n");
    return exit_done;
}

} // namespace integral
