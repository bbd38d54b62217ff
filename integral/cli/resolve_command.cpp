// SPDX-License-Identifier: AGPL-3.0-or-later
// integral resolve: the thesis's resolution experiment.
#include "integral/base/file_bytes.h"
#include "integral/cli/command.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/thread_options.h"
#include "integral/cli/values.h"
#include "integral/laboratory/resolution_text.h"

namespace integral {
namespace {

struct ResolveOptions : CommonOptions {
    SheetOptions sheet;
    std::optional<std::string> dpi, depths, frequencies, distance, pupil, camera, output;
    bool json = false;
    ThreadOptions threads;
};

void declare(options::options_description& all, ResolveOptions& o)
{
    add(all, "depths", o.depths, "MM,...",
        "of the charts in front of the sheet (default 0,5,10,15,25,30,35)");
    add(all, "frequencies", o.frequencies, "F,...",
        "of the bars, in cycles (a bright and a dark bar) per mm (default the thesis's lines per "
        "mm and half of each)");
    add(all, "distance", o.distance, "MM",
        "from the sheet to the observer's eye and the aperture (default 400)");
    add(all, "pupil", o.pupil, "MM", "of that eye (default 4)");
    add(all, "camera", o.camera, "WORDS",
        "words of the integral camera that renders the charts (default \"pixel_samples 4 "
        "beam_samples 16\")");
    add(all, "dpi", o.dpi, "D", "film pixels per inch (default 300)");
    declare(all, o.sheet);
    add(all, "json", o.json, "print the figures as JSON");
    add(all, "output,o", o.output, "FILE", "print to FILE instead of standard output");
    declare(all, o.threads);
}

ResolutionRequest request_of(const ResolveOptions& o)
{
    ResolutionRequest request;
    FilmOptions film;
    film.dpi = o.dpi;
    const FrameMetadata geometry = given_geometry(std::nullopt, o.sheet, film);
    request.sheet = geometry.sheet;
    request.pixel_pitch = geometry.film.pixel_pitch;
    request.depths = {0, 5, 10, 15, 25, 30, 35};
    request.frequencies = {10, 5, 2.5, 2, 1, 0.666, 0.5, 0.333, 0.25};
    if (o.depths)
        request.depths = parse_numbers("depths", *o.depths, "numbers separated by commas", 1, 100);
    if (o.frequencies)
        request.frequencies = parse_numbers("frequencies", *o.frequencies,
                                            "numbers separated by commas", 1, 50);
    read_number("distance", o.distance, request.observer);
    read_number("pupil", o.pupil, request.pupil);
    if (!(request.observer >= 10 && request.observer <= 1e5 && request.pupil >= 0 &&
          request.pupil <= 100))
        throw UsageError("--distance of 10 to 100000 mm and --pupil of 0 to 100 mm are expected");
    request.camera_words = o.camera.value_or(request.camera_words);
    return request;
}

int run(const ResolveOptions& o)
{
    check_outputs({o.output});
    const ResolutionRequest request = request_of(o);
    const bool beside_thesis = !first_given(o.sheet);
    const ResolutionReport report = resolution_report(request, beside_thesis, o.threads.count(),
                                                      progress_bar("resolve"));
    print_result(o.output, o.json ? report.json.dump(2) + "\n" : report.text);
    return exit_done;
}

} // namespace

const Command resolve_command = {
    "resolve",
    "what detail survives at what depth: the thesis's resolution experiment",
    "[--depths MM,...] [--pitch MM --thickness MM --ior N] [--dpi D] [--json]",
    R"(Renders charts of bars in front of a sheet by povray-integral, replays the
frames on a diffusing screen at the chart's place and to an eye, and prints the
bars' modulation (thesis 4.3.7). Without a sheet's options it does so for the
thesis's two sheets, and prints tables 4-2 and 4-3 beside. doc/resolution.md is
the protocol.
)",
    0,
    0,
    described<ResolveOptions>,
    run_with<ResolveOptions, run>,
    true};

} // namespace integral
