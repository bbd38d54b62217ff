// SPDX-License-Identifier: AGPL-3.0-or-later
// integral rectify: turns a scan of micro-images into a frame.
#include "integral/analysis/lattice_search.h"
#include "integral/analysis/rectify.h"
#include "integral/analysis/rectify_report.h"
#include "integral/base/constants.h"
#include "integral/base/number_text.h"
#include "integral/cli/command.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/rectify_calibration.h"
#include "integral/cli/thread_options.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace integral {
namespace {

constexpr double default_turn_range = 10; // degrees

struct RectifyOptions : CommonOptions {
    std::optional<std::string> output;
    std::optional<std::string> start; ///< --sheet: file with the geometry
    std::optional<std::string> scan_dpi, turn, middle, flat, balance, white;
    std::optional<std::string> page;
    bool even_light = false, vignetting = false, json = false, calibration = false;
    ThreadOptions threads;
    SheetOptions sheet;
    FilmOptions film;
    ApertureOptions aperture;
};

void declare(options::options_description& all, RectifyOptions& o)
{
    add(all, "output,o", o.output, "FRAME",
        "the frame: .png, .exr or .tiff; - writes a PNG to standard output and the report to "
        "standard error");
    add(all, "sheet", o.start, "FILE.json",
        "geometry that the print was made for: a JSON document, or the frame itself; options below "
        "change it");
    add(all, "scan-dpi", o.scan_dpi, "D[,D]",
        "the scan's resolution, to 4% (default: what its file says)");
    add(all, "turn", o.turn, "DEGREES",
        "about how far the print is turned in the scan, anticlockwise, to 10 degrees (default 0)");
    add(all, "middle", o.middle, "X,Y",
        "scan pixel, from the top left, of the sheet's middle, which viewer and capture aperture "
        "are in front of; to half a lens, it is then found exactly (default: the scan's middle). "
        "With it and the frame's own geometry in --sheet the frame's pixels help");
    add(all, "flat", o.flat, "FILE",
        "divide by this scan of nothing but the light (of an empty sheet of paper), of the same "
        "size");
    add(all, "even-light", o.even_light,
        "divide by a smooth surface fitted to the scan's own light");
    add(all, "balance", o.balance, "grey", "colours by the grey world: their means become equal");
    add(all, "white", o.white, "X,Y,W,H",
        "colours and exposure by a patch of the scan that becomes white: pixels from the top left");
    add(all, "vignetting", o.vignetting,
        "divide by the average micro-image, which is darker towards the lenses' borders");
    add(all, "calibration", o.calibration,
        "measure a lens sheet instead: SCAN is a photograph of the page of integral print "
        "--calibration under the sheet. -o FILE.json becomes the sheet as measured. Give the "
        "options that the page was made with");
    add(all, "page", o.page, "WxH", "with --calibration: the page, mm (default 210x297)");
    add(all, "json", o.json, "print the figures as JSON");
    declare(all, o.threads);
    declare(all, o.sheet);
    declare(all, o.film);
    declare(all, o.aperture);
}

/// The geometry of the print. A film of 0 by 0 takes its size from the scan.
FrameMetadata read_geometry(const RectifyOptions& o)
{
    const bool given = !o.start.value_or("").empty();
    FrameMetadata geometry = given_geometry(given ? o.start : std::nullopt, o.sheet, o.film);
    change_aperture(o.aperture, geometry, given && !changes_lenses(o.sheet, o.aperture));
    return geometry;
}

/// Scan pixels per mm.
Vec2 scan_scale(const RectifyOptions& o, const Scan& scan)
{
    if (o.scan_dpi)
        return (1 / mm_per_inch) * parse_dpi("scan-dpi", *o.scan_dpi);
    if (!scan.pixel_pitch)
        throw InputError(o.inputs[0] + ": it does not say its resolution; give --scan-dpi");
    return {1 / scan.pixel_pitch->x, 1 / scan.pixel_pitch->y};
}

LatticeSearch search_of(const RectifyOptions& o, const FrameMetadata& geometry, const Scan& scan)
{
    LatticeSearch search;
    search.sheet = geometry.sheet;
    search.aperture = geometry.aperture;
    if (geometry.render)
        search.mapping = geometry.render->mapping;
    search.about.scale = scan_scale(o, scan);
    search.about.middle = {0.5 * scan.image.width, 0.5 * scan.image.height};
    read_vector("middle", o.middle, search.about.middle);
    if (o.middle && geometry.film.width > 0)
        search.frame = geometry.film;
    double turn = 0;
    read_number("turn", o.turn, turn);
    if (!(std::fabs(turn) <= 360))
        throw UsageError("--turn " + o.turn.value_or("") +
                         ": degrees from -360 to 360 are expected");
    search.about.rotation = turn * radians_per_degree;
    search.turn_range = default_turn_range * radians_per_degree;
    return search;
}

/// --white: balances the scan so that the patch becomes white.
void balance_white(const RectifyOptions& o, const Image& scan, ScanLight& light)
{
    constexpr char form[] = "X,Y,W,H (pixels inside the scan)";
    const auto v = parse_numbers("white", *o.white, form, 4, 4);
    if (!(v[0] >= 0 && v[1] >= 0 && v[2] >= 1 && v[3] >= 1 && v[0] + v[2] <= scan.width &&
          v[1] + v[3] <= scan.height))
        throw_usage("white", *o.white, form);
    try {
        light.balance_white(scan, int(v[0]), int(v[1]), int(v[2]), int(v[3]));
    } catch (const std::invalid_argument& error) {
        throw InputError(o.inputs[0] + ": the patch of --white: " + error.what());
    }
}

/// The correction of the scan's light that the options request.
ScanLight light_of(const RectifyOptions& o, const Image& scan, LightReport& report)
{
    ScanLight light;
    if (o.flat)
        try {
            light.divide_by_flat(read_scan(*o.flat).image, scan.width, scan.height,
                                 o.threads.count());
        } catch (const std::invalid_argument& error) {
            throw InputError(*o.flat + ": " + error.what());
        }
    const LightGrid grid = light_grid(scan, o.threads.count());
    if (o.even_light)
        light.divide_by_surface(grid);
    if (o.even_light || o.flat)
        report.add_evened(o.flat.has_value(), o.even_light, light.unevenness());
    const bool grey = !o.balance.value_or("").empty();
    if (grey)
        light.balance_grey(grid);
    if (o.white)
        balance_white(o, scan, light);
    if (grey || o.white)
        report.add_balanced(!grey, light.channel_gains());
    return light;
}

/// Checks the options before anything is read. Throws UsageError, OutputError.
void check_options(const RectifyOptions& o)
{
    const std::string balance = o.balance.value_or("");
    check_picture(needed_output(o.output, "FRAME"));
    if (!balance.empty() && balance != "grey")
        throw_usage("balance", balance, "grey");
    if (!balance.empty() && o.white)
        throw UsageError("--balance grey and --white do not go together");
    o.threads.count(); // throws before the scan is read
}

int run_calibration(const RectifyOptions& o)
{
    throw_if_given({{"scan-dpi", o.scan_dpi},
                    {"turn", o.turn},
                    {"middle", o.middle},
                    {"flat", o.flat},
                    {"even-light", o.even_light},
                    {"balance", o.balance},
                    {"white", o.white},
                    {"vignetting", o.vignetting},
                    {"aperture", o.aperture.aperture}},
                   "does not work with --calibration");
    return read_calibration({o.inputs[0], o.output, o.start, o.page, o.aperture.distance, o.sheet,
                             o.film, o.json, o.threads.count()});
}

int run(const RectifyOptions& o)
{
    if (o.calibration)
        return run_calibration(o);
    throw_if_given({{"page", o.page}}, "is for --calibration");
    check_options(o);
    FrameMetadata geometry = read_geometry(o);
    const Scan scan = read_scan(o.inputs[0]);
    stop_if_interrupted();
    const LatticeSearch search = search_of(o, geometry, scan);
    LightReport light_report;
    const ScanLight light = light_of(o, scan.image, light_report);
    const int threads = o.threads.count();
    const FoundLattice found = find_sure_lattice(o.inputs[0], scan.image, search, threads,
                                                 progress_bar("looking for the lenses"));

    const Film film = film_to_make(geometry.film, o.film.size.has_value(), found.map, scan.image);
    geometry.film = film;
    geometry.placement.reset();
    if (geometry.render)
        geometry.render->error.reset(); // an estimate for the rendered frame
    auto image = rectified(scan.image, found.map, film, light, threads, progress_bar("resampling"));
    if (!image)
        throw Interrupted();
    if (o.vignetting)
        light_report.add_flattened(flatten_micro_images(
            *image, film, SheetOptics(geometry.sheet, geometry.aperture), search.mapping, threads));
    stop_if_interrupted();
    Frame frame{std::move(*image), std::nullopt};
    set_metadata(frame, geometry);
    write_frame(*o.output, std::move(frame));
    const std::string report = o.json
                                   ? rectify_json(found, search, film, light_report).dump(2) + "\n"
                                   : rectify_text(found, search, film, light_report);
    print_figures(report, *o.output == "-");
    return exit_done;
}

} // namespace

const Command rectify_command = {
    "rectify",
    "a scan of a print, or of an integral photograph, as a frame",
    "SCAN -o FRAME [--sheet FILE.json | --pitch MM ...] [--middle X,Y] ... | --calibration PHOTO "
    "-o SHEET.json ...",
    R"(Finds the lattice of the micro-images in a scan: how far it is turned, the lenses' pitch in
the scan's pixels and where they are, to a few hundredths of a pixel, and says how sure that
is. The scan's resolution and turn need only be known roughly, the sheet well: its lattice is
the ruler. Then resamples the scan once, in linear light, to the film's own pixels. What the
scan does not hold stays black. Scan without the lens sheet on the print, at twice the
print's resolution or more; the light is changed only as asked for.

--calibration measures a lens sheet by one photograph of a page (integral print --calibration)
that lies under it: pitch, turn, phase, thickness / index, leak and dot gain, each with its
standard deviation. The squares around the sheet give the camera. Give exactly the options
that the page was made with (its heading has them): --distance is the page's, by default 400.
The pitch may differ from the nominal one by 1.5%, the sheet may be turned by 5 degrees.
)",
    1,
    1,
    described<RectifyOptions>,
    run_with<RectifyOptions, run>,
    true};

} // namespace integral
