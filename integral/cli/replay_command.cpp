// SPDX-License-Identifier: AGPL-3.0-or-later
// integral replay: what an eye sees of a frame through its sheet.
#include "integral/cli/progress.h"
#include "integral/cli/replay_options.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/lightfield/names.h"
#include "integral/replay/replay_page.h"

namespace integral {
namespace {

constexpr int default_longer_side = 1000; // pixels

/// Throws UsageError for options that --html does not go with.
void check_html_options(const ReplayOptions& o)
{
    if (o.html->empty())
        throw UsageError("--html: the name of a file is expected");
    if (o.html == o.output)
        throw UsageError("--html and -o do not go to the same file");
    if (const char* other = first_given({{"stereo", o.stereo},
                                         {"grid", o.grid},
                                         {"path", o.path},
                                         {"anaglyph", o.anaglyph},
                                         {"cross-eyed", o.cross_eyed}}))
        throw UsageError(std::string("--html and --") + other +
                         " do not go together: the page shows one view");
    if (o.lens_model == name_of(LensModel::full))
        throw UsageError(
            "--html and --lens-model full do not go together: the page has ideal lenses");
}

/// Begins what -o names: a series if the eye moves, else one picture, whose path is checked.
std::optional<PictureSeries> begin_output(const ReplayOptions& o,
                                          const std::optional<EyeMovement>& movement)
{
    const std::string output = o.output.value_or("");
    if (movement)
        return begin_series(o.series, output, movement->steps, 1);
    if (output.empty())
        return std::nullopt;
    if (is_animation(output))
        throw UsageError("-o " + output + ": an animation needs --path, how the eye moves");
    format_for(output);
    check_writable(output);
    return std::nullopt;
}

void write_views(const Frame& frame, const ReplayRequest& request, const std::string& output,
                 std::optional<PictureSeries>& series)
{
    const auto take = [&](Image picture) {
        if (series)
            series->add(std::move(picture));
        else
            write_frame(output, Frame{std::move(picture), std::nullopt});
    };
    if (!replay_pictures(frame, request, take, progress_bar("replay")))
        throw Interrupted();
    if (series)
        series->finish(ends_apart(*request.movement));
}

int run(const ReplayOptions& o)
{
    const std::string output = o.output.value_or("");
    if (o.html)
        check_html_options(o);
    if (output.empty() && !o.html)
        throw UsageError("-o VIEW is missing");
    if (o.focus && !o.pupil && !o.html)
        throw UsageError("--focus needs --pupil MM: an eye without one sees every depth sharply");
    check_series_options(o.series, output);
    ReplayRequest request;
    request.view = view_of(o);
    request.threads = o.threads.count();
    request.arrangement = arrangement_of(o);
    if (o.html)
        check_writable(*o.html);
    request.movement = movement_of(o);
    std::optional<PictureSeries> series = begin_output(o, request.movement);

    const Frame frame = read_frame_with_metadata(o.inputs[0], o.sheet.value_or(""));
    stop_if_interrupted();
    if (!o.eye)
        request.view.eye = centre_eye(*frame.metadata);
    try {
        check_view(request.view, *frame.metadata);
        if (o.html)
            write_file(*o.html, replay_page(frame, request.view));
        if (output.empty())
            return exit_done;
        if (!o.size)
            set_view_size(request.view, frame.metadata->film, default_longer_side);
        write_views(frame, request, output, series);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
    return exit_done;
}

} // namespace

const Command replay_command = {
    "replay",
    "what an eye sees of a frame through its lens sheet",
    "FRAME (-o VIEW | --html PAGE) [--eye X,Y,DISTANCE] [--size WxH] [--stereo MM | --grid CxR] "
    "[--path KIND]",
    "Draws the view that an eye at a given place has of a frame under its lens sheet. The sheet\n"
    "fills the picture. From the aperture's centre (the default) it is the picture that the\n"
    "scene's perspective camera takes; beyond the viewing zone the eye sees side lobes, and black\n"
    "where it looks past the film. A pupil blurs what is not at the depth that it focuses on.\n",
    1,
    1,
    described<ReplayOptions>,
    run_with<ReplayOptions, run>};

} // namespace integral
