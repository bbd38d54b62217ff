// SPDX-License-Identifier: AGPL-3.0-or-later
// integral replay: shows what an eye sees of a frame through its sheet.
#include "integral/base/message_text.h"
#include "integral/base/number_text.h"
#include "integral/cli/progress.h"
#include "integral/cli/replay_options.h"
#include "integral/cli/values.h"
#include "integral/frame/names.h"
#include "integral/io/image_file.h"
#include "integral/io/mpo_file.h"
#include "integral/replay/draft_frame.h"
#include "integral/replay/fit_part.h"
#include "integral/replay/replay_files.h"
#include "integral/replay/replay_page.h"

#include <limits>

namespace integral {
namespace {

constexpr int default_longer_side = 1000; // pixels

/// Throws UsageError for options that --html excludes.
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

/// Throws UsageError for options that need a single frame.
void check_frames(const ReplayOptions& o)
{
    if (o.inputs.size() < 2)
        return;
    if (o.html)
        throw UsageError("--html takes one frame; several make an animation, -o FILE.webp");
    if (o.output.value_or("").empty())
        throw UsageError("-o FILE.webp is missing: several frames make an animation");
}

/// Begins the output of -o. Returns a series for several frames or a moving eye; for one picture,
/// only checks the path and returns nothing.
std::optional<PictureSeries> begin_output(const ReplayOptions& o,
                                          const std::optional<EyeMovement>& movement)
{
    const std::string output = o.output.value_or("");
    if (is_mpo(output)) {
        if (!o.stereo || o.anaglyph || o.cross_eyed || o.half || movement || o.inputs.size() > 1)
            throw UsageError("-o " + output +
                             ": such a file holds a pair; --stereo MM makes one, of one frame and "
                             "without --path, --half, --cross-eyed and --anaglyph");
        check_writable(output);
        return std::nullopt;
    }
    const bool several = o.inputs.size() > 1;
    if (several || movement) {
        AnimationSettings settings = animation_settings(o.series);
        settings.there_and_back = !several && ends_apart(*movement);
        return PictureSeries(output, settings, several ? int(o.inputs.size()) : movement->steps, 1);
    }
    if (output.empty())
        return std::nullopt;
    if (is_animation(output))
        throw UsageError("-o " + output +
                         ": an animation needs --path, how the eye moves, or several frames");
    check_picture(output);
    return std::nullopt;
}

/// Fits the visible part of the sheet into a picture of --size.
void fit_size(const ReplayOptions& o, View& view, const FrameMetadata& metadata, Fit fit)
{
    const FittedPicture picture = fit_part_to_size(view, metadata, fit);
    if (picture.differs())
        say("replay", o.inputs[0] + ": " +
                          (o.part ? fit_text(picture, "--size", "more of the sheet")
                                  : fit_text(picture, "--size")));
}

/// Reads a frame. A draft is expanded to the print's pixels, unless its raw pixels are requested.
Frame read_replayed(const ReplayOptions& o, const std::string& path)
{
    Frame frame = read_frame_with_metadata(path, o.sheet.value_or(""));
    if (o.raw_draft || !is_draft(frame))
        return frame;
    const int draft = frame.metadata->render->draft;
    auto finer = with_final_pixels(frame, o.threads.count(), progress_bar("replay"));
    if (!finer)
        throw Interrupted();
    if (path == o.inputs[0])
        say("replay", path + " is a draft with " + std::to_string(draft) +
                          " times fewer pixels: shown as the print's pixels will fill it in; "
                          "--raw-draft shows its own");
    return std::move(*finer);
}

/// Writes the pictures: all requested ones of a single frame, or one of each of several frames.
void write_views(const ReplayOptions& o, Frame first, const ReplayRequest& request,
                 std::optional<PictureSeries>& series)
{
    constexpr int usual_quality = 95; // of a stereo pair
    const int quality = in_range("quality", o.series.quality.value_or(usual_quality), 0, 100);
    const auto take = [&](Image picture) {
        if (series)
            series->add(std::move(picture));
        else if (is_mpo(*o.output))
            write_mpo(*o.output, picture, quality, *request.arrangement.separation);
        else
            write_frame(*o.output, Frame{std::move(picture), std::nullopt});
    };
    const auto read = [&](const std::string& path) { return read_replayed(o, path); };
    if (!replay_files(o.inputs, read, std::move(first), request, take, progress_bar("replay")))
        throw Interrupted();
    if (series)
        series->finish();
}

int run(const ReplayOptions& o)
{
    const std::string output = o.output.value_or("");
    if (o.html)
        check_html_options(o);
    check_frames(o);
    if (!o.html)
        needed_output(o.output, "VIEW");
    if (o.focus && !o.pupil && !o.as_seen && !o.html)
        throw UsageError("--focus needs --pupil MM: an eye without one sees every depth sharply");
    check_series_options(o.series, output);
    ReplayRequest request;
    request.view = view_of(o);
    const Fit fit = o.fit.value();
    request.threads = o.threads.count();
    request.arrangement = arrangement_of(o);
    check_outputs({o.html});
    request.movement = movement_of(o);
    std::optional<PictureSeries> series = begin_output(o, request.movement);

    Frame frame = read_replayed(o, o.inputs[0]);
    stop_if_interrupted();
    if (!o.eye)
        request.view.eye = centre_eye(*frame.metadata);
    if (o.as_seen)
        set_as_seen(request.view, *frame.metadata);
    check_view(request.view, *frame.metadata);
    if (o.stereo && lenses_lie_across(frame.metadata->sheet))
        say("replay", "--stereo: these lenses lie across (slant " +
                          with_digits(frame.metadata->sheet.slant, 6) +
                          "), so both eyes of a pair see the same picture; views differ up and "
                          "down, as --path sweep shows");
    if (o.html)
        write_file(*o.html, replay_page(frame, request.view));
    if (output.empty())
        return exit_done;
    if (o.size)
        fit_size(o, request.view, *frame.metadata, fit);
    else
        set_view_size(request.view, frame.metadata->film, default_longer_side);
    write_views(o, std::move(frame), request, series);
    return exit_done;
}

} // namespace

const Command replay_command = {
    "replay",
    "what an eye sees of a frame through its lens sheet",
    "FRAME... (-o VIEW | --html PAGE) [--eye X,Y,DISTANCE] [--size WxH] [--stereo MM | --grid CxR] "
    "[--path KIND]",
    R"(Draws the view that an eye at a given place has of a frame under its lens sheet. The sheet
fills the picture. From the aperture's centre (the default) it is the picture that the
scene's perspective camera takes; beyond the viewing zone the eye sees side lobes, and black
where it looks past the film. A pupil blurs what is not at the depth that it focuses on.
Several frames, those of an animation, give a picture each, from one place or along --path.
)",
    1,
    std::numeric_limits<int>::max(),
    described<ReplayOptions>,
    run_with<ReplayOptions, run>};

} // namespace integral
