// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/print_chart.h"

#include "integral/base/number_text.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/lightfield/names.h"
#include "integral/lightfield/sheet_figures.h"
#include "integral/output/pitch_chart.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral {
namespace {

constexpr double default_distance = 400; // mm, at which the middle bar is even under the nominal
                                         // sheet
constexpr int bars_lenticular = 25, bars_2d = 15, most_bars = 1000;
constexpr double neighbours = 0.125;   // bands along a bar by which neighbouring bars differ
constexpr double largest_page = 20000; // mm
constexpr double most_pixels = 5e8;
constexpr char default_page[] = "152.4x101.6";    // 4x6 inches
constexpr char default_page_2d[] = "203.2x152.4"; // 6x8 inches: two blocks of bars
constexpr double vague_index = 0.1; // an index that is no better known than this is said to be
                                    // vague

FrameMetadata geometry_of(const options::variables_map& arguments)
{
    if (!inputs_of(arguments).empty())
        throw UsageError("a pitch chart has no FRAME; --sheet FILE.json gives the nominal sheet");
    const std::string start = text_of(arguments, "sheet");
    FrameMetadata geometry = start.empty() ? default_geometry() : read_metadata(start);
    geometry.film.width = geometry.film.height = 0;
    change_sheet(arguments, geometry.sheet);
    change_film(arguments, geometry.film);
    check_geometry(geometry);
    return geometry;
}

int default_bars(const LensSheet& sheet)
{
    return sheet.arrangement == Arrangement::lenticular ? bars_lenticular : bars_2d;
}

void set_page(const options::variables_map& arguments, const LensSheet& sheet, Film& film)
{
    if (given(arguments, "page") && film.width > 0)
        throw UsageError("--page and --size say the same; give one of them");
    if (film.width == 0) {
        const std::string text = given(arguments, "page") ? text_of(arguments, "page")
                                 : sheet.arrangement == Arrangement::lenticular ? default_page
                                                                                : default_page_2d;
        const auto cross = text.find('x');
        double width = 0, height = 0;
        try {
            width = parse_number("page", text.substr(0, cross), "");
            height = parse_number("page", cross == std::string::npos ? "" : text.substr(cross + 1),
                                  "");
        } catch (const UsageError&) {
            throw UsageError("--page " + text + ": WxH, in mm, is expected");
        }
        if (!(width >= 1 && height >= 1 && width <= largest_page && height <= largest_page))
            throw UsageError("--page " + text + ": sides of 1 to 20000 mm are expected");
        if (std::max(width / film.pixel_pitch.x, height / film.pixel_pitch.y) > largest_film_side)
            throw UsageError("--page " + text +
                             ": it has more than 1000000 pixels across or down at this resolution");
        film.width = std::max(1, int(std::lround(width / film.pixel_pitch.x)));
        film.height = std::max(1, int(std::lround(height / film.pixel_pitch.y)));
    }
    if (double(film.width) * film.height > most_pixels)
        throw UsageError("the page has more than 500 million pixels; take a smaller one");
}

/// A round number (1, 2 or 5 and zeros) near a value.
double rounded_step(double value)
{
    const double power = std::pow(10, std::floor(std::log10(value))), digits = value / power;
    return power * (digits < 1.5 ? 1 : digits < 3.5 ? 2 : digits < 7.5 ? 5 : 10);
}

double default_step(const PitchChart& chart)
{
    PitchChart one = chart;
    one.scale = {visual_pitch(chart.sheet.pitch, chart.sheet, default_distance), 1, 1};
    double length = std::numeric_limits<double>::infinity();
    for (const ChartBar& bar : chart_bars(one))
        length = std::min(length, bar.upright ? bar.height * chart.film.pixel_pitch.y
                                              : bar.width * chart.film.pixel_pitch.x);
    return rounded_step(neighbours * chart.sheet.pitch * chart.sheet.pitch / length);
}

/// The scale that --pitch-range, --pitch-step and --bars give; nothing of it from the page.
PitchScale scale_of_range(const options::variables_map& arguments, const LensSheet& sheet)
{
    const std::string range = text_of(arguments, "pitch-range");
    const auto ends = parse_numbers("pitch-range", range, "A,B, in mm,", 2, 2);
    if (!(ends[0] > 0 && ends[1] > ends[0] && ends[1] <= 1e3))
        throw UsageError("--pitch-range " + range +
                         ": two pitches, the smaller first, up to 1000 mm are expected");
    const bool steps = given(arguments, "pitch-step"), bars = given(arguments, "bars");
    if (steps && bars)
        throw UsageError("--pitch-range goes with --pitch-step or with --bars, not with both");
    if (!steps) {
        const int count = bars ? in_range(arguments, "bars", 2, most_bars) : default_bars(sheet);
        return {ends[0], (ends[1] - ends[0]) / (count - 1), count};
    }
    const double step = parse_number("pitch-step", text_of(arguments, "pitch-step"), "a number");
    const double count = (ends[1] - ends[0]) / step;
    if (!(step > 0 && count < most_bars && std::fabs(count - std::round(count)) < 1e-6))
        throw UsageError("--pitch-step " + text_of(arguments, "pitch-step") +
                         ": a part of --pitch-range " + range + " is expected, at most " +
                         std::to_string(most_bars - 1) + " steps");
    return {ends[0], step, int(std::lround(count)) + 1};
}

PitchScale scale_for_page(const options::variables_map& arguments, const PitchChart& chart)
{
    if (given(arguments, "pitch-range"))
        return scale_of_range(arguments, chart.sheet);
    PitchScale scale;
    scale.bars = given(arguments, "bars") ? in_range(arguments, "bars", 2, most_bars)
                                          : default_bars(chart.sheet);
    scale.step = given(arguments, "pitch-step")
                     ? parse_number("pitch-step", text_of(arguments, "pitch-step"), "a number")
                     : default_step(chart);
    // Whole steps, so that the printed pitches are round numbers.
    const double middle = visual_pitch(chart.sheet.pitch, chart.sheet, default_distance);
    scale.first = scale.step * std::round(middle / scale.step - (scale.bars - 1) / 2);
    if (!(scale.step > 0 && scale.first > 0))
        throw UsageError("--pitch-step " + text_of(arguments, "pitch-step") +
                         ": a small part of the pitch is expected");
    return scale;
}

/// The option that gives a film's pixel pitch: --dpi, with both directions where they differ.
std::string film_words(const Film& film)
{
    const double dpi_x = mm_per_inch / film.pixel_pitch.x, dpi_y = mm_per_inch / film.pixel_pitch.y;
    const std::string across = with_digits(dpi_x, 9), down = with_digits(dpi_y, 9);
    return "--dpi " + across + (down == across ? "" : "," + down);
}

std::string reading_command(const PitchChart& chart)
{
    const LensSheet& sheet = chart.sheet;
    return "Read it by: integral print --even BAR,BAR@MM --pitch-range " +
           with_digits(chart.scale.first, 9) + "," +
           with_digits(film_pitch(chart.scale, chart.scale.bars), 9) + " --bars " +
           std::to_string(chart.scale.bars) + " --arrangement " + name_of(sheet.arrangement) +
           " --pitch " + with_digits(sheet.pitch, 9) + " --thickness " +
           with_digits(sheet.thickness, 9) + " --ior " + with_digits(sheet.ior, 9) +
           (sheet.slant != 0 ? " --slant " + with_digits(sheet.slant, 9) : "") + " " +
           film_words(chart.film);
}

/// The aperture that fills the lenses from a distance, or an open one.
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

/// One --even: BAR[,BAR...]@DISTANCE.
ChartReading parse_reading(const std::string& text)
{
    constexpr char form[] = "BAR,BAR@DISTANCE, as 12,13@400,";
    const auto at = text.find('@');
    const auto refuse = [&] { throw UsageError("--even " + text + ": " + form + " is expected"); };
    if (at == std::string::npos)
        refuse();
    ChartReading reading;
    for (const double bar : parse_numbers("even", text.substr(0, at), form, 1, 2 * most_bars)) {
        if (!(bar == std::floor(bar) && bar >= 1 && bar <= 2 * most_bars))
            refuse();
        reading.bars.push_back(int(bar));
    }
    reading.distance = parse_number("even", text.substr(at + 1), form);
    if (!(reading.distance >= 1e-2 && reading.distance <= 1e9))
        throw UsageError("--even " + text + ": a distance of 0.01 to 1e9 mm is expected");
    return reading;
}

std::string plus_minus(const Measured& figure, int count)
{
    return with_decimals(figure.value, count) + " +- " + with_decimals(figure.error, count);
}

std::string report_text(const LensSheet& nominal, const PitchScale& scale,
                        const std::vector<ChartReading>& readings, const MeasuredSheet& found)
{
    std::string text;
    for (const ChartReading& reading : readings) {
        text += "even at " + with_digits(reading.distance, 9) + " mm: film pitch " +
                plus_minus(film_pitch_of(scale, reading), 5) + " mm, bar";
        for (const int bar : reading.bars)
            text += " " + std::to_string(bar);
        text += "\n";
    }
    text += "mechanical pitch    " + plus_minus(found.pitch, 5) + " mm, " +
            with_decimals(mm_per_inch / found.pitch.value, 4) + " lenses per inch\n";
    if (!found.index_measured)
        return text + "index               " + with_digits(nominal.ior, 9) +
               ", as the sheet has it\n";
    text += "index               " + plus_minus(found.index, 3) + " for a thickness of " +
            with_digits(nominal.thickness, 9) + " mm: " + with_decimals(found.least_index, 3) +
            (found.greatest_index > 0 ? " to " + with_decimals(found.greatest_index, 3)
                                      : " or more") +
            "\n";
    if (found.greatest_index > 0 && found.greatest_index - found.least_index < 2 * vague_index)
        return text;
    text += "these readings hardly tell the index: read from nearer and from farther, or a chart "
            "of finer steps\n";
    try {
        text += "with --keep-index   " +
                plus_minus(measured_sheet(nominal, scale, readings, true).pitch, 5) +
                " mm, by an index of " + with_digits(nominal.ior, 9) + "\n";
    } catch (const std::invalid_argument&) {
        text += "with --keep-index the readings contradict the index of " +
                with_digits(nominal.ior, 9) + "\n";
    }
    return text;
}

nlohmann::ordered_json report_json(const PitchScale& scale,
                                   const std::vector<ChartReading>& readings,
                                   const MeasuredSheet& found)
{
    nlohmann::ordered_json json, list = nlohmann::ordered_json::array();
    for (const ChartReading& reading : readings) {
        const Measured film = film_pitch_of(scale, reading);
        list.push_back({{"bars", reading.bars},
                        {"distance_mm", reading.distance},
                        {"film_pitch_mm", film.value},
                        {"error_mm", film.error}});
    }
    json["readings"] = list;
    json["pitch_mm"] = found.pitch.value;
    json["pitch_error_mm"] = found.pitch.error;
    json["ior"] = found.index.value;
    json["ior_measured"] = found.index_measured;
    json["ior_least"] = found.least_index;
    json["ior_greatest"] = found.greatest_index > 0 ? nlohmann::ordered_json(found.greatest_index)
                                                    : nlohmann::ordered_json(nullptr);
    return json;
}

int read_chart(const options::variables_map& arguments)
{
    FrameMetadata geometry = geometry_of(arguments);
    if (!given(arguments, "pitch-range"))
        throw UsageError("--even needs the chart's --pitch-range A,B and --bars N, which stand in "
                         "its last line");
    const PitchScale scale = scale_of_range(arguments, geometry.sheet);
    std::vector<ChartReading> readings;
    for (const std::string& text : arguments["even"].as<std::vector<std::string>>())
        readings.push_back(parse_reading(text));
    if (geometry.sheet.arrangement == Arrangement::lenticular)
        for (const ChartReading& reading : readings)
            for (const int bar : reading.bars)
                if (bar > scale.bars)
                    throw UsageError("--even: bar " + std::to_string(bar) +
                                     " is not on a chart of " + std::to_string(scale.bars) +
                                     " bars");
    MeasuredSheet found;
    try {
        found = measured_sheet(geometry.sheet, scale, readings, given(arguments, "keep-index"));
    } catch (const std::invalid_argument& error) {
        throw UsageError(std::string("--even: ") + error.what());
    }
    const std::string report = given(arguments, "json")
                                   ? report_json(scale, readings, found).dump(2) + "\n"
                                   : report_text(geometry.sheet, scale, readings, found);
    const std::string output = text_of(arguments, "output");
    if (!output.empty()) {
        geometry.sheet.pitch = found.pitch.value;
        geometry.sheet.ior = found.index.value;
        geometry.aperture = aperture_for(geometry.sheet, geometry.aperture.distance);
        geometry.placement.reset();
        geometry.render.reset();
        geometry.film.width = geometry.film.height = 0; // a sheet's file goes with frames of any
                                                        // size
        write_file(output, to_json(geometry));
    }
    if (output != "-")
        write_file("-", report);
    return exit_done;
}

} // namespace

void add_chart_options(options::options_description& all)
{
    options::options_description chart;
    const auto value = [](const char* name) {
        return options::value<std::string>()->value_name(name);
    };
    chart.add_options()(
        "chart", "make a pitch chart instead: bars of lines, one of which is even under the sheet")(
        "pitch-range", value("A,B"),
        "pitches of its first and last bar, mm on the film (default: about the sheet's, as seen "
        "from 400 mm)")("pitch-step", value("MM"),
                        "from bar to bar (default: an eighth of a band along a bar)")(
        "bars", options::value<int>()->value_name("N"),
        "how many in each direction (default 25; 15 where lenses are not lenticular)")(
        "page", value("WxH"),
        "the chart's page, mm (default 152.4x101.6; 203.2x152.4 where lenses are not lenticular)")(
        "even", options::value<std::vector<std::string>>()->value_name("BARS@MM"),
        "read a chart instead: which bars are even, from which distance, as 12,13@400; again for "
        "each distance. Prints the sheet's "
        "mechanical pitch and index; -o FILE.json writes the sheet corrected")(
        "keep-index", "with --even: take the index as given and measure the pitch alone");
    add_sheet_options(chart);
    add_film_options(chart);
    for (const auto& option : chart.options())
        if (!all.find_nothrow(option->long_name(), false))
            all.add(option);
}

bool is_chart(const options::variables_map& arguments)
{
    return given(arguments, "chart") || given(arguments, "even");
}

ChartPage chart_page(const options::variables_map& arguments)
{
    FrameMetadata geometry = geometry_of(arguments);
    set_page(arguments, geometry.sheet, geometry.film);
    geometry.sheet.offset = {};
    geometry.aperture = aperture_for(geometry.sheet, default_distance);
    geometry.placement.reset();
    geometry.render.reset();
    geometry.encoding = {};
    try {
        PitchChart chart;
        chart.sheet = geometry.sheet;
        chart.film = geometry.film;
        chart.scale = scale_for_page(arguments, chart);
        chart.note = reading_command(chart);
        ChartPage made{{pitch_chart(chart), std::nullopt}, chart.note};
        set_metadata(made.frame, geometry);
        return made;
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

int make_chart(const options::variables_map& arguments)
{
    if (given(arguments, "chart") && given(arguments, "even"))
        throw UsageError("--chart makes a chart and --even reads one; give one of them");
    if (given(arguments, "even"))
        return read_chart(arguments);
    const std::string output = text_of(arguments, "output");
    if (output.empty())
        throw UsageError("-o FILE is missing");
    if (extension_of(output) == "pdf")
        throw OutputError(output + ": a chart is .png, .tiff or .exr; integral print CHART.png -o "
                                   "CHART.pdf makes a PDF of it");
    format_for(output);
    check_writable(output);
    ChartPage chart = chart_page(arguments);
    write_frame(output, std::move(chart.frame));
    if (output != "-")
        write_file("-", chart.reading + "\n");
    return exit_done;
}

} // namespace integral
