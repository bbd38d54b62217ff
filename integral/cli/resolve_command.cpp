// SPDX-License-Identifier: AGPL-3.0-or-later
// integral resolve: the thesis's resolution experiment.
#include "integral/base/file_bytes.h"
#include "integral/cli/command.h"
#include "integral/cli/geometry_options.h"
#include "integral/cli/progress.h"
#include "integral/cli/thread_options.h"
#include "integral/cli/values.h"
#include "integral/resolution/resolution_text.h"

#include <nlohmann/json.hpp>

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
    all.add_options()("depths", fills(o.depths, "MM,..."),
                      "of the charts in front of the sheet (default 0,5,10,15,25,30,35)");
    all.add_options()("frequencies", fills(o.frequencies, "F,..."),
                      "of the bars, in cycles (a bright and a dark bar) per mm (default the "
                      "thesis's lines per mm and half of each)");
    all.add_options()("distance", fills(o.distance, "MM"),
                      "from the sheet to the observer's eye and the aperture (default 400)");
    all.add_options()("pupil", fills(o.pupil, "MM"), "of that eye (default 4)");
    all.add_options()("camera", fills(o.camera, "WORDS"),
                      "words of the integral camera that renders the charts (default "
                      "\"pixel_samples 4 beam_samples 16\")");
    all.add_options()("dpi", fills(o.dpi, "D"), "film pixels per inch (default 300)");
    declare(all, o.sheet);
    all.add_options()("json", sets(o.json), "print the figures as JSON");
    all.add_options()("output,o", fills(o.output, "FILE"),
                      "print to FILE instead of standard output");
    declare(all, o.threads);
}

ResolutionRequest request_of(const ResolveOptions& o)
{
    ResolutionRequest request;
    FilmOptions film;
    film.dpi = o.dpi;
    FrameMetadata geometry = default_geometry();
    change_sheet(o.sheet, geometry.sheet);
    change_film(film, geometry.film);
    check_geometry(geometry);
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
    if (o.output)
        check_writable(*o.output);
    ResolutionRequest request = request_of(o);
    const bool own = first_given(o.sheet) != nullptr;
    const auto& thesis = thesis_tables();
    const int count = own ? 1 : int(thesis.size());
    const Progress bar = progress_bar("resolve");
    std::string text;
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (int k = 0; k < count; ++k) {
        const ThesisTable* beside = own ? nullptr : &thesis[std::size_t(k)];
        if (beside) {
            request.sheet.pitch = beside->pitch;
            request.sheet.thickness = beside->thickness;
            request.sheet.ior = beside->ior;
        }
        try {
            const ResolutionTable table = measured_resolution(request, o.threads.count(),
                                                              piece_of(bar, k, count));
            text += (k > 0 ? "\n" : "") + resolution_text(request, table, beside);
            json.push_back(resolution_json(request, table));
        } catch (const std::invalid_argument& error) {
            throw UsageError(error.what());
        }
    }
    print_result(o.output, o.json ? json.dump(2) + "\n" : text);
    return exit_done;
}

} // namespace

const Command resolve_command = {
    "resolve",
    "what detail survives at what depth: the thesis's resolution experiment",
    "[--depths MM,...] [--pitch MM --thickness MM --ior N] [--dpi D] [--json]",
    "Renders charts of bars in front of a sheet by povray-integral, replays the\n"
    "frames on a diffusing screen at the chart's place and to an eye, and prints the\n"
    "bars' modulation (thesis 4.3.7). Without a sheet's options it does so for the\n"
    "thesis's two sheets, and prints tables 4-2 and 4-3 beside. doc/resolution.md is\n"
    "the protocol.\n",
    0,
    0,
    described<ResolveOptions>,
    run_with<ResolveOptions, run>};

} // namespace integral
