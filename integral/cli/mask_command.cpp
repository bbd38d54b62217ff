// SPDX-License-Identifier: AGPL-3.0-or-later
// integral mask: pictures for making lens sheets.
#include "integral/base/number_text.h"
#include "integral/cli/choices.h"
#include "integral/cli/command.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/thread_options.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/laboratory/mask_picture.h"
#include "integral/print/relief_chart.h"

namespace integral {
namespace {

struct MaskOptions : CommonOptions {
    SheetOptions sheet;
    FilmOptions film;
    std::optional<std::string> start, print, shape, conic, response, from_depth, calibrate, chart,
        distance, output;
    std::optional<int> bits;
    bool relief = false, spinning = false, lens = false, negative = false;
    ThreadOptions threads;
};

void declare(options::options_description& all, MaskOptions& o)
{
    add(all, "output,o", o.output, "FILE",
        "the mask: .png or .tiff; with --calibrate the response that was found");
    add(all, "shape", o.shape, "KIND",
        "spherical, or aspheric: the ellipsoid that has no spherical aberration on the axis "
        "(default spherical)");
    add(all, "conic", o.conic, "K", "another conic constant for the surface");
    add(all, "response", o.response, "FILE.csv",
        "lines GREY, DEPTH: how deep (mm) a grey from 0 to 1 is sculpted (default: in proportion, "
        "from pole to deepest corner)");
    add(all, "from-depth", o.from_depth, "MM",
        "how deep the poles are sculpted themselves (default 0)");
    add(all, "lens", o.lens,
        "one lens, to be scaled and multiplied by a lens array: --size pixels of its cell");
    add(all, "spinning", o.spinning,
        "one lens's shape that spins about its pole: white lets light through");
    add(all, "relief", o.relief,
        "a height map for a printer that builds up, as UV relief printers do: white is highest");
    add(all, "chart", o.chart, "FILE",
        "with --relief: print this picture, and the relief over it; together they tell the printed "
        "lenses' pitch and offset");
    add(all, "distance", o.distance, "MM", "of the eye that looks at the chart (default 400)");
    add(all, "negative", o.negative, "black and white exchanged");
    add(all, "calibrate", o.calibrate, "FILE.csv",
        "find a process's response by appendix C's loop of six steps; the file says how the "
        "process, which is simulated, answers");
    declare(all, o.sheet);
    declare(all, o.film);
    add(all, "print", o.print, "WxH", "size in mm, instead of --size");
    declare_start_geometry(all, o.start);
    add(all, "bits", o.bits, "N", "8 or 16 (default 16)");
    declare(all, o.threads);
}

LensShape shape_of(const MaskOptions& o, const LensSheet& sheet)
{
    const std::string kind = o.shape.value_or("spherical");
    const bool aspheric = meaning_of("shape", kind, shape_choices);
    if (o.shape && o.conic)
        throw UsageError("--shape and --conic both say the surface; give one of them");
    double conic = aspheric ? focusing_conic(sheet) : 0;
    read_number("conic", o.conic, conic);
    return focused_shape(sheet, conic);
}

/// Makes the film one lens's cell, with --size pixels.
void set_one_lens(const MaskOptions& o, MaskRequest& request)
{
    if (o.print || o.film.dpi || o.film.pixel_pitch)
        throw UsageError("one lens is given by its pixels, --size WxH; it is scaled later");
    if (!o.film.size)
        request.film.width = request.film.height = 1024;
    show_one_lens(request);
}

MaskRequest request_of(const MaskOptions& o)
{
    const FrameMetadata geometry = given_geometry(o.start, o.sheet, o.film, o.print);
    MaskRequest request;
    request.sheet = geometry.sheet;
    request.film = geometry.film;
    if (o.relief && o.spinning)
        throw UsageError("--relief and --spinning are different pictures; give one of them");
    request.kind = o.relief     ? MaskKind::relief
                   : o.spinning ? MaskKind::spinning
                                : MaskKind::greyscale;
    if (o.spinning && request.sheet.arrangement == Arrangement::lenticular)
        throw UsageError("--spinning makes lenses that are round; --arrangement square or "
                         "hexagonal is expected");
    if (o.lens || o.spinning)
        set_one_lens(o, request);
    else if (request.film.width < 1)
        throw UsageError("--print WxH (mm), --size WxH (pixels) or --lens is missing");
    request.shape = shape_of(o, request.sheet);
    if (o.relief && (o.response || o.from_depth))
        throw UsageError("--relief is heights in proportion; --response and --from-depth are for "
                         "masks");
    if (o.response)
        request.response = read_response(*o.response);
    read_number("from-depth", o.from_depth, request.from_depth);
    request.negative = o.negative;
    return request;
}

int run_calibration(const MaskOptions& o, int bits)
{
    const Response process = read_response(*o.calibrate);
    const Calibration found = calibrate(process, 1 << bits);
    if (o.output)
        write_file(*o.output, response_text(found.found));
    print_result(std::nullopt, rounds_text(found));
    return exit_done;
}

/// The chart of --chart; empty without it.
std::optional<ReliefChart> chart_of(const MaskOptions& o, const MaskRequest& request)
{
    if (!o.chart && !o.distance)
        return std::nullopt;
    if (!o.chart || !o.relief || o.lens)
        throw UsageError(std::string(o.chart ? "--chart" : "--distance") +
                         " belongs to --relief --chart FILE, of a whole page of lenses");
    if (format_for(*o.chart) == ImageFormat::exr || *o.chart == *o.output)
        throw_usage("chart", *o.chart, "another file, .png or .tiff,");
    ReliefChart chart;
    chart.sheet = request.sheet;
    chart.film = request.film;
    read_number("distance", o.distance, chart.distance);
    if (!(chart.distance >= 50 && chart.distance <= 1e5))
        throw UsageError("--distance " + *o.distance + ": 50 to 100000 mm are possible");
    check_writable(*o.chart);
    return chart;
}

int run(const MaskOptions& o)
{
    const int bits = bits_given(o.bits, 16);
    if (o.calibrate)
        return run_calibration(o, bits);
    if (!o.output)
        throw UsageError("-o FILE is missing");
    if (format_for(*o.output) == ImageFormat::exr)
        throw UsageError("-o " + *o.output + ": greys are stored values; .png or .tiff");
    check_writable(*o.output);
    MaskRequest request = request_of(o);
    request.bits = bits;
    const double deepest = SheetRelief(request.sheet, request.shape).deepest();
    const auto chart = chart_of(o, request);
    const auto bars = chart ? relief_bars(*chart) : std::vector<ReliefBar>();
    auto image = mask_picture(request, o.threads.count(), progress_bar("mask"));
    if (!image)
        throw Interrupted();
    if (chart) {
        flatten_beside(bars, o.negative ? 1 : 0, *image);
        write_page(*o.chart, relief_chart(*chart), request.film.pixel_pitch, "", std::nullopt);
    }
    write_page(*o.output, *image, request.film.pixel_pitch, "", std::nullopt);
    say("mask", "the lenses are " + with_digits(1000 * deepest, 5) +
                    " um deep from pole to corner; a grey level is " +
                    with_digits(1000 * deepest / ((1 << bits) - 1), 3) +
                    " um where the response is linear");
    return exit_done;
}

} // namespace

const Command mask_command = {
    "mask",
    "greyscale masks and height maps from which lens sheets are made",
    "-o MASK.png --print WxH --dpi D [--shape aspheric] [--response FILE.csv] | --relief ... | "
    "--lens | --spinning | --calibrate FILE.csv [-o FOUND.csv]",
    R"(Makes the greyscale mask by which a sheet of lenses is photo-sculpted (thesis
appendix C): each pixel's grey exposes the resist to the depth of the lens
there. --response is what the whole process answers to a grey, as measured, and
--calibrate finds that of a simulated one by the loop of appendix C: a ramp is
sculpted, measured, and corrected by. --relief writes heights instead, for
printers that build lenses up.
)",
    0,
    0,
    described<MaskOptions>,
    run_with<MaskOptions, run>,
    true};

} // namespace integral
