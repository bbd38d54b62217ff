// SPDX-License-Identifier: AGPL-3.0-or-later
// integral rectify: a scan of micro-images becomes a frame.
#include "integral/analysis/lattice_search.h"

#include "integral/analysis/rectify.h"
#include "integral/base/constants.h"
#include "integral/base/number_text.h"
#include "integral/cli/command.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace integral {
namespace {

constexpr double default_turn_range = 10; // degrees

options::options_description make_options()
{
    options::options_description all("Options");
    const auto value = [](const char* name) {
        return options::value<std::string>()->value_name(name);
    };
    all.add_options()("output,o", value("FRAME"),
                      "the frame: .png, .exr or .tiff; - writes a PNG to standard output and the "
                      "report to standard error")(
        "sheet", value("FILE.json"),
        "geometry that the print was made for: a JSON document, or the frame itself; options below "
        "change it")("scan-dpi", value("D[,D]"),
                     "the scan's resolution, to 4% (default: what its file says)")(
        "turn", value("DEGREES"),
        "about how far the print is turned in the scan, anticlockwise, to 10 degrees (default 0)")(
        "middle", value("X,Y"),
        "scan pixel, from the top left, of the sheet's middle, which viewer and capture aperture "
        "are in front of; to half a lens, it is then "
        "found exactly (default: the scan's middle). With it and the frame's own geometry in "
        "--sheet the frame's pixels help")("flat", value("FILE"),
                                           "divide by this scan of nothing but the light (of an "
                                           "empty sheet of paper), of the same size")(
        "even-light", options::bool_switch(),
        "divide by a smooth surface fitted to the scan's own light")(
        "balance", value("grey"), "colours by the grey world: their means become equal")(
        "white", value("X,Y,W,H"),
        "colours and exposure by a patch of the scan that becomes white: pixels from the top left")(
        "vignetting", options::bool_switch(),
        "divide by the average micro-image, which is darker towards the lenses' borders")(
        "json", "print the figures as JSON")(
        "threads", options::value<int>()->value_name("N")->default_value(0),
        "threads to work with (0: one per core)")("help", "print this");
    static SheetOptions unread_sheet;
    static FilmOptions unread_film;
    static ApertureOptions unread_aperture;
    declare(all, unread_sheet);
    declare(all, unread_film);
    declare(all, unread_aperture);
    return all;
}

/// The geometry that the print was made for. A film of 0 by 0: what the scan holds.
FrameMetadata read_geometry(const options::variables_map& arguments)
{
    const std::string start = text_of(arguments, "sheet");
    FrameMetadata geometry = start.empty() ? default_geometry() : read_metadata(start);
    change_sheet(read_group<SheetOptions>(arguments), geometry.sheet);
    change_film(read_group<FilmOptions>(arguments), geometry.film);
    check_geometry(geometry);
    change_aperture(read_group<ApertureOptions>(arguments), geometry,
                    !start.empty() && !changes_lenses(read_group<SheetOptions>(arguments),
                                                      read_group<ApertureOptions>(arguments)));
    return geometry;
}

/// Scan pixels a mm.
Vec2 scan_scale(const options::variables_map& arguments, const std::string& input, const Scan& scan)
{
    if (given(arguments, "scan-dpi")) {
        const Vec2 dpi = parse_one_or_two("scan-dpi", text_of(arguments, "scan-dpi"), "D or D,D");
        if (!(dpi.x > 0 && dpi.y > 0))
            throw UsageError("--scan-dpi " + text_of(arguments, "scan-dpi") +
                             ": it must be greater than 0");
        return (1 / mm_per_inch) * dpi;
    }
    if (!scan.pixel_pitch)
        throw InputError(input + ": it does not say its resolution; give --scan-dpi");
    return {1 / scan.pixel_pitch->x, 1 / scan.pixel_pitch->y};
}

LatticeSearch read_search(const options::variables_map& arguments, const FrameMetadata& geometry,
                          const std::string& input, const Scan& scan)
{
    LatticeSearch search;
    search.sheet = geometry.sheet;
    search.aperture = geometry.aperture;
    if (geometry.render)
        search.mapping = geometry.render->mapping;
    search.about.scale = scan_scale(arguments, input, scan);
    search.about.middle = {0.5 * scan.image.width, 0.5 * scan.image.height};
    if (given(arguments, "middle")) {
        const auto v = parse_numbers("middle", text_of(arguments, "middle"), "X,Y", 2, 2);
        search.about.middle = {v[0], v[1]};
        if (geometry.film.width > 0)
            search.frame = geometry.film;
    }
    double turn = 0;
    if (given(arguments, "turn"))
        turn = parse_number("turn", text_of(arguments, "turn"), "a number");
    if (!(std::fabs(turn) <= 360))
        throw UsageError("--turn " + text_of(arguments, "turn") +
                         ": degrees from -360 to 360 are expected");
    search.about.rotation = turn * radians_per_degree;
    search.turn_range = default_turn_range * radians_per_degree;
    return search;
}

/// What is done to the light, in words for the report.
struct Corrections {
    ScanLight light;
    nlohmann::ordered_json done = nlohmann::ordered_json::object();
    std::string text;
};

void note(Corrections& c, const std::string& what)
{
    c.text += (c.text.empty() ? "" : ", ") + what;
}

Corrections correct_light(const options::variables_map& arguments, const std::string& input,
                          const Image& scan, int threads)
{
    Corrections c;
    const bool even = arguments["even-light"].as<bool>();
    if (given(arguments, "flat")) {
        const std::string path = text_of(arguments, "flat");
        try {
            c.light.divide_by_flat(read_scan(path).image, scan.width, scan.height, threads);
        } catch (const std::invalid_argument& error) {
            throw InputError(path + ": " + error.what());
        }
    }
    const LightGrid grid = light_grid(scan, threads);
    if (even)
        c.light.divide_by_surface(grid);
    if (even || given(arguments, "flat")) {
        c.done["uneven_light"] = {
            {"by", even ? (given(arguments, "flat") ? "flat and surface" : "surface") : "flat"},
            {"ratio", c.light.unevenness()}};
        note(c, "light evened that differed " + with_digits(c.light.unevenness(), 3) + " times");
    }
    const std::string balance = text_of(arguments, "balance");
    if (!balance.empty())
        c.light.balance_grey(grid);
    if (given(arguments, "white")) {
        constexpr char form[] = "X,Y,W,H (pixels inside the scan)";
        const auto v = parse_numbers("white", text_of(arguments, "white"), form, 4, 4);
        if (!(v[0] >= 0 && v[1] >= 0 && v[2] >= 1 && v[3] >= 1 && v[0] + v[2] <= scan.width &&
              v[1] + v[3] <= scan.height))
            throw UsageError("--white " + text_of(arguments, "white") + ": " + form +
                             " is expected");
        try {
            c.light.balance_white(scan, int(v[0]), int(v[1]), int(v[2]), int(v[3]));
        } catch (const std::invalid_argument& error) {
            throw InputError(input + ": the patch of --white: " + error.what());
        }
    }
    if (!balance.empty() || given(arguments, "white")) {
        const Color g = c.light.channel_gains();
        c.done["colour"] = {{"by", balance.empty() ? "white patch" : "grey world"},
                            {"gains", {g.r, g.g, g.b}}};
        note(c, "red, green, blue times " + with_digits(g.r, 4) + ", " + with_digits(g.g, 4) +
                    ", " + with_digits(g.b, 4));
    }
    return c;
}

/// The film to make: as asked for, else the geometry's, cut to what the scan holds.
Film film_to_make(const options::variables_map& arguments, const Film& wanted, const ScanMap& map,
                  const Image& scan)
{
    const Film held = film_of_scan(map, scan.width, scan.height, wanted.pixel_pitch, wanted);
    Film film = wanted;
    if (!given(arguments, "size")) {
        film.width = wanted.width > 0 ? std::min(wanted.width, held.width) : held.width;
        film.height = wanted.height > 0 ? std::min(wanted.height, held.height) : held.height;
    }
    if (std::max(film.width, film.height) > 65500)
        throw UsageError("a frame of " + std::to_string(film.width) + "x" +
                         std::to_string(film.height) +
                         " pixels is too large; fewer --dpi, or --size, would help");
    return film;
}

nlohmann::ordered_json as_json(const FoundLattice& found, const LatticeSearch& search,
                               const Film& film, const Corrections& corrections)
{
    const ScanMap& m = found.map;
    const double pitch = search.sheet.pitch;
    return {
        {"rotation_degrees", m.rotation / radians_per_degree},
        {"pitch_mm", pitch},
        {"pitch_px", {pitch * m.scale.x, pitch * m.scale.y}},
        {"micro_image_pitch_mm",
         pitch * (1 + search.sheet.thickness / (search.sheet.ior * search.aperture.distance))},
        {"middle_px", {m.middle.x, m.middle.y}},
        {"sheet_offset_mm", {search.sheet.offset.x, search.sheet.offset.y}},
        {"scan_dpi", {mm_per_inch * m.scale.x, mm_per_inch * m.scale.y}},
        {"scale", {m.scale.x / search.about.scale.x, m.scale.y / search.about.scale.y}},
        {"standard_error",
         found.errors_known
             ? nlohmann::ordered_json{{"rotation_degrees",
                                       found.rotation_error / radians_per_degree},
                                      {"pitch_relative",
                                       {found.scale_error.x, found.scale_error.y}},
                                      {"middle_px", {found.offset_error.x, found.offset_error.y}}}
             : nlohmann::ordered_json(nullptr)},
        {"contrast", found.contrast},
        {"significance", found.significance},
        {"film",
         {{"width", film.width},
          {"height", film.height},
          {"pixel_pitch_mm", {film.pixel_pitch.x, film.pixel_pitch.y}}}},
        {"corrections", corrections.done}};
}

std::string as_text(const FoundLattice& found, const LatticeSearch& search, const Film& film,
                    const Corrections& corrections)
{
    const ScanMap& m = found.map;
    const double pitch = search.sheet.pitch;
    char text[1200];
    std::snprintf(
        text, sizeof text,
        "turned                   %.4f +- %.4f degrees, anticlockwise\n"
        "lens pitch               %.4f, %.4f pixels of the scan +- %.4f%%, %.4f%%\n"
        "the scan's resolution    %.3f, %.3f dpi (%+.3f%%, %+.3f%% against what it says)\n"
        "the sheet's middle       at %.3f, %.3f pixels of the scan +- %.3f, %.3f\n"
        "edge on the lens borders %+.0f%%, %.0f deviations above lattices at random\n"
        "frame                    %d x %d pixels of %.5g x %.5g mm\n"
        "light                    %s\n",
        m.rotation / radians_per_degree, found.rotation_error / radians_per_degree,
        pitch * m.scale.x, pitch * m.scale.y, 100 * found.scale_error.x, 100 * found.scale_error.y,
        mm_per_inch * m.scale.x, mm_per_inch * m.scale.y,
        100 * (m.scale.x / search.about.scale.x - 1), 100 * (m.scale.y / search.about.scale.y - 1),
        m.middle.x, m.middle.y, found.offset_error.x, found.offset_error.y, 100 * found.contrast,
        found.significance, film.width, film.height, film.pixel_pitch.x, film.pixel_pitch.y,
        corrections.text.empty() ? "left as it is" : corrections.text.c_str());
    return text +
           std::string(
               found.errors_known
                   ? ""
                   : "the errors behind +- are not known: the edges have no clear maximum here\n");
}

FoundLattice find(const std::string& input, const Image& scan, const LatticeSearch& search,
                  int threads)
{
    std::optional<FoundLattice> found;
    try {
        found = find_lattice(scan, search, threads, progress_bar("looking for the lenses"));
    } catch (const std::invalid_argument& error) {
        throw InputError(input + ": " + error.what());
    }
    if (!found)
        throw Interrupted();
    if (!(found->significance >= least_significance))
        throw InputError(input + ": no micro-images of lenses " +
                         with_digits(search.sheet.pitch, 6) +
                         " mm apart are found in it, within 4% of " +
                         with_digits(mm_per_inch * search.about.scale.x, 6) +
                         " dpi and 10 degrees of upright (the likeliest stand out by " +
                         with_decimals(found->significance, 1) + " deviations, " +
                         with_decimals(least_significance, 0) +
                         " are wanted); check --pitch, --scan-dpi and --turn");
    return *found;
}

int run(const options::variables_map& arguments)
{
    const std::string output = text_of(arguments, "output");
    if (output.empty())
        throw UsageError("-o FRAME is missing");
    format_for(output);
    check_writable(output);
    const std::string balance = text_of(arguments, "balance");
    if (!balance.empty() && balance != "grey")
        throw UsageError("--balance " + balance + ": grey is expected");
    if (!balance.empty() && given(arguments, "white"))
        throw UsageError("--balance grey and --white do not go together");
    const int threads = in_range(arguments, "threads", 0, 1024);
    FrameMetadata geometry = read_geometry(arguments);

    const std::string input = inputs_of(arguments)[0];
    const Scan scan = read_scan(input);
    stop_if_interrupted();
    const LatticeSearch search = read_search(arguments, geometry, input, scan);
    Corrections corrections = correct_light(arguments, input, scan.image, threads);
    const FoundLattice found = find(input, scan.image, search, threads);

    geometry.film = film_to_make(arguments, geometry.film, found.map, scan.image);
    geometry.placement.reset();
    if (geometry.render)
        geometry.render->error.reset(); // it was the rendered frame's
    auto image = rectified(scan.image, found.map, geometry.film, corrections.light, threads,
                           progress_bar("resampling"));
    if (!image)
        throw Interrupted();
    if (arguments["vignetting"].as<bool>()) {
        const double least = flatten_micro_images(*image, geometry.film,
                                                  SheetOptics(geometry.sheet, geometry.aperture),
                                                  search.mapping, threads);
        corrections.done["vignetting"] = {{"least", least}};
        note(corrections, "micro-images flattened that fell to " + with_digits(least, 3));
    }
    stop_if_interrupted();
    Frame frame{std::move(*image), std::nullopt};
    set_metadata(frame, geometry);
    const Film film = geometry.film;
    write_frame(output, std::move(frame));
    const std::string report = given(arguments, "json")
                                   ? as_json(found, search, film, corrections).dump(2) + "\n"
                                   : as_text(found, search, film, corrections);
    if (output == "-")
        std::fputs(report.c_str(), stderr);
    else
        write_file("-", report);
    return exit_done;
}

} // namespace

const Command rectify_command = {
    "rectify",
    "a scan of a print, or of an integral photograph, as a frame",
    "SCAN -o FRAME [--sheet FILE.json | --pitch MM ...] [--middle X,Y] [--white X,Y,W,H] ...",
    "Finds the lattice of the micro-images in a scan: how far it is turned, the lenses' pitch in\n"
    "the scan's pixels and where they are, to a few hundredths of a pixel, and says how sure that\n"
    "is. The scan's resolution and turn need only be known roughly, the sheet well: its lattice "
    "is\n"
    "the ruler. Then resamples the scan once, in linear light, to the film's own pixels. What the\n"
    "scan does not hold stays black. Scan without the lens sheet on the print, at twice the\n"
    "print's resolution or more; the light is changed only as asked for.\n",
    1,
    1,
    make_options,
    run_from_map<run>};

} // namespace integral
