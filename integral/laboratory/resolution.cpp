// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/laboratory/resolution.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"
#include "integral/batch/renderer.h"
#include "integral/io/image_file.h"
#include "integral/replay/replay.h"
#include "integral/sheet/camera_words.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

// A chart: bars over half_width to either side of the middle, one row of bars below another.
constexpr double half_width = 15, measured_half = 12, row_height = 1.5; // mm
constexpr int screen_directions = 300, places_a_third = 9;

/// The y of a row's middle, mm.
double row_middle(const ResolutionRequest& request, std::size_t row)
{
    return (0.5 * double(request.frequencies.size()) - 0.5 - double(row)) * row_height;
}

/// Half the film width, mm, that shows the chart to the whole aperture.
double film_half_width(const ResolutionRequest& request, double depth)
{
    const double d = request.observer, aperture = filling_aperture(request.sheet, d)->width / 2;
    return measured_half + (aperture + measured_half) * depth / (d - depth) + request.sheet.pitch;
}

/// The middle thirds of all measured bars.
struct Bars {
    double period; ///< mm
    /// Calls visit(x, bright) at places_a_third places of the middle third of each bar.
    template <class Visit> void for_each_place(Visit visit) const
    {
        const double bar = period / 2;
        const int last = int(std::floor(measured_half / bar));
        for (int k = -last; k < last; ++k)
            for (int place = 0; place < places_a_third; ++place) {
                const double part = (1 + (place + 0.5) / places_a_third) / 3;
                visit((k + part) * bar, k % 2 == 0);
            }
    }
};

/// (B - D)/(B + D), see ResolutionCell; light(x) is the light at place x of the chart.
template <class Light> double modulation(double frequency, Light light)
{
    double bright = 0, dark = 0;
    int bright_places = 0, dark_places = 0;
    Bars{1 / frequency}.for_each_place([&](double x, bool is_bright) {
        (is_bright ? bright : dark) += light(x);
        ++(is_bright ? bright_places : dark_places);
    });
    bright /= std::max(bright_places, 1);
    dark /= std::max(dark_places, 1);
    return bright + dark > 0 ? (bright - dark) / (bright + dark) : 0;
}

/// The light that the sheet sends to a place of a diffusing screen: the mean over directions to the
/// whole aperture's width.
double screen_light(const Frame& frame, const LinearReader& light, const SheetOptics& optics,
                    Vec3 place)
{
    const Film& film = frame.metadata->film;
    const Aperture& aperture = frame.metadata->aperture;
    const double d = aperture.distance;
    double sum = 0;
    for (int k = 0; k < screen_directions; ++k) {
        const Vec3 eye{((k + 0.5) / screen_directions - 0.5) * aperture.width, 0, -d};
        const Vec3 way = place - eye;
        const Vec3 on_sheet = eye + (d / way.z) * way;
        const Vec2 pixel = pixel_from_film(
            film, optics.film_point_seen({on_sheet.x, on_sheet.y}, -1 * way));
        const int x = int(std::floor(pixel.x)), y = int(std::floor(pixel.y));
        if (x >= 0 && y >= 0 && x < film.width && y < film.height)
            sum += light(x, y).g;
    }
    return sum / screen_directions;
}

double screen_modulation(const Frame& frame, double frequency, double y, double depth)
{
    const SheetOptics optics(frame.metadata->sheet, frame.metadata->aperture);
    const LinearReader light(frame.image);
    return modulation(frequency, [&](double x) {
        return screen_light(frame, light, optics, {x, y, -depth});
    });
}

/// Modulation for the eye, in a picture that is measured on the sheet behind the chart.
double observed_modulation(const ResolutionRequest& request, const Frame& frame, double frequency,
                           double y, double depth, int threads)
{
    const double to_sheet = request.observer / (request.observer - depth);
    View view;
    view.eye = {0, 0, request.observer};
    view.pupil = request.pupil;
    view.focus = -depth;
    view.samples = 6;
    view.part = {{0, y * to_sheet}, 2 * measured_half * to_sheet, 0.02};
    const double third = 1 / (6 * frequency); // mm of the chart
    view.width = int(std::clamp(std::ceil(2 * measured_half / third * 4), 600.0, 8000.0));
    view.height = 1;
    const auto seen = replay(frame, view, threads);
    if (!seen)
        return 0;
    const LinearReader light(*seen);
    return modulation(frequency, [&](double x) {
        const double at = (x / (2 * measured_half) + 0.5) * view.width;
        return double(light(std::clamp(int(at), 0, view.width - 1), 0).g);
    });
}

double sinc(double x) { return x == 0 ? 1 : std::sin(pi * x) / (pi * x); }

void check(const ResolutionRequest& request)
{
    if (request.sheet.arrangement != Arrangement::lenticular || request.sheet.slant != 0)
        throw std::invalid_argument("the experiment is for upright lenticular sheets");
    for (const double depth : request.depths)
        if (!(depth >= 0 && depth < 0.9 * request.observer))
            throw std::invalid_argument("depth " + with_digits(depth, 6) +
                                        ": 0 to nine tenths of the observer's distance is "
                                        "expected");
    for (const double f : request.frequencies)
        if (!(f >= 0.1 && f <= 50))
            throw std::invalid_argument("frequency " + with_digits(f, 6) +
                                        ": 0.1 to 50 cycles per mm is expected");
    if (!filling_aperture(request.sheet, request.observer))
        throw std::invalid_argument("no aperture fills these lenses");
}

} // namespace

double expected_modulation(const ResolutionRequest& request, double frequency, double depth)
{
    const LensSheet& sheet = request.sheet;
    const double spread = depth * sheet.ior * request.pixel_pitch.x / sheet.thickness;
    double sum = 0;
    for (int harmonic = 1; harmonic < 40; harmonic += 2) {
        const double f = harmonic * frequency, sign = harmonic % 4 == 1 ? 1 : -1;
        const double through = sinc(f * sheet.pitch) * sinc(f * spread);
        // mean over a bar's middle third
        sum += sign * 4 / (pi * harmonic) * sinc(harmonic / 6.0) * through * through;
    }
    return sum;
}

std::string chart_scene(const ResolutionRequest& request, double depth)
{
    const auto text = [](double v) { return with_digits(v, 12); };
    std::string scene = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
                        "camera { integral " +
                        sheet_words(request.sheet) + " film { pixel_pitch <" +
                        text(request.pixel_pitch.x) + ", " + text(request.pixel_pitch.y) +
                        "> units_per_mm 1 } " + request.camera_words + "\n  location <0, 0, " +
                        text(-request.observer) +
                        "> look_at 0 up y right x*image_width/image_height }\n";
    for (std::size_t row = 0; row < request.frequencies.size(); ++row) {
        const double y = row_middle(request, row);
        const std::string z = text(-depth);
        scene += "polygon { 5, <" + text(-half_width) + ", " + text(y - row_height / 2) + ", " + z +
                 ">, <" + text(half_width) + ", " + text(y - row_height / 2) + ", " + z + ">, <" +
                 text(half_width) + ", " + text(y + row_height / 2) + ", " + z + ">, <" +
                 text(-half_width) + ", " + text(y + row_height / 2) + ", " + z + ">, <" +
                 text(-half_width) + ", " + text(y - row_height / 2) + ", " + z +
                 ">\n  pigment { gradient x color_map { [.5 rgb 1] [.5 rgb 0] } scale " +
                 text(1 / request.frequencies[row]) + " } finish { ambient 1 diffuse 0 } }\n";
    }
    return scene;
}

std::vector<ResolutionCell> measured_charts(const ResolutionRequest& request, double depth,
                                            const Frame& frame, int threads)
{
    std::vector<ResolutionCell> cells(request.frequencies.size());
    for_each_row(int(cells.size()), threads, [&](int row) {
        const double f = request.frequencies[std::size_t(row)];
        const double y = row_middle(request, std::size_t(row));
        ResolutionCell& cell = cells[std::size_t(row)];
        cell.screen = screen_modulation(frame, f, y, depth);
        cell.observer = observed_modulation(request, frame, f, y, depth, 1);
        cell.expected = expected_modulation(request, f, depth);
    });
    return cells;
}

ResolutionTable measured_resolution(const ResolutionRequest& request, int threads,
                                    const Progress& progress)
{
    check(request);
    const ScratchFolder scratch;
    const std::string scene = scratch.path("chart.pov"), picture = scratch.path("chart.exr");
    const double height = double(request.frequencies.size()) * row_height;
    const auto pixels = [](double mm, double pitch) { return int(std::ceil(mm / pitch)); };
    ResolutionTable table;
    for (std::size_t k = 0; k < request.depths.size(); ++k) {
        const double depth = request.depths[k];
        const double to_sheet = request.observer / (request.observer - depth);
        write_file(scene, chart_scene(request, depth));
        std::vector<std::string> words = scene_words(scene);
        // An even number of pixels: the middle of the film is between two.
        const int columns = 2 * pixels(film_half_width(request, depth), request.pixel_pitch.x),
                  rows = pixels(height * to_sheet, request.pixel_pitch.y);
        for (const std::string& word :
             {"+W" + std::to_string(columns), "+H" + std::to_string(rows), std::string("-A"),
              std::string("+FE"), "+O\"" + picture + "\"", std::string("-P"),
              std::string("Integral_Audit=off")})
            words.push_back(word);
        if (threads > 0)
            words.push_back("+WT" + std::to_string(threads));
        render("the chart at " + with_digits(depth, 6) + " mm", words, scratch,
               piece_of(progress, int(k), int(request.depths.size())));
        table.push_back(
            measured_charts(request, depth, read_frame_with_metadata(picture), threads));
    }
    return table;
}

} // namespace integral
