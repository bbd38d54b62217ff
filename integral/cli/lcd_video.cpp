// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/lcd_video.h"

#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/io/picture_series.h"
#include "integral/panel/panel_files.h"
#include "integral/panel/quilt_sequence.h"
#include "integral/screen/screen_text.h"

#include <algorithm>
#include <chrono>
#include <iostream>

namespace integral {
namespace {

/// Plays a video; warns about its rate and about faults in it.
void play_and_report(const LcdOptions& o, const LcdRequest& lcd, VideoReader& video, int width,
                     int height, const std::function<Image(Image)>& finish)
{
    if (!o.fps && video.rate_varies())
        say("lcd", video.path() +
                       ": its pictures do not follow at an even rate; they are played at " +
                       with_digits(video.rate(), 4) +
                       " a second, its mean; ffmpeg -i VIDEO -r N OUTPUT makes it even");
    const PlayReport report = play_video(video, width, height, finish, lcd.playing, lcd.showing);
    if (!video.fault().empty())
        say("lcd", video.path() + ": ffmpeg finds a fault in it: " + video.fault());
    print_play_report(o, report);
}

} // namespace

bool takes_whole_video(const LcdOptions& o)
{
    const bool has_video = std::any_of(o.inputs.begin(), o.inputs.end(), is_video);
    if (!has_video) {
        throw_if_given({{"at", o.at}}, "is for videos");
        return false;
    }
    if (o.inputs.size() > 1)
        throw UsageError("a video is the only INPUT; " + std::to_string(o.inputs.size()) +
                         " are given");
    if (o.play)
        throw_if_given({{"at", o.at}}, "selects one picture; --play plays the whole video");
    if (o.show && !o.play && !o.at)
        throw UsageError("--show shows one picture; --play plays a video, and --at SECONDS selects "
                         "one picture of it");
    throw_if_given({{"depth", o.depth.depth}, {"depth-range", o.depth.range}},
                   "does not work with a video");
    return !o.at;
}

void print_play_report(const LcdOptions& o, const PlayReport& report)
{
    if (report.shown > 0)
        std::cout << (o.json ? play_json(report).dump(2) + "\n" : play_text(report));
    if (report.interrupted)
        throw Interrupted();
}

void play_on_panel(const LcdOptions& o, const LcdRequest& lcd, const Panel& panel)
{
    const int width = panel.film.width, height = panel.film.height;
    check_display(width, height, o.inputs[0], lcd.showing);
    VideoReader video(o.inputs[0]);
    PanelImages images(panel, lcd.image);
    const QuiltSequence sequence(images, video.path(), video.form());
    play_and_report(o, lcd, video, width, height,
                    [&](const Image& quilt) { return sequence.image_of(quilt); });
}

void play_as_it_is(const LcdOptions& o, const LcdRequest& lcd)
{
    VideoReader video(o.inputs[0]);
    play_and_report(o, lcd, video, video.form().width, video.form().height,
                    [](Image picture) { return picture; });
}

void write_images_of_video(const LcdOptions& o, const LcdRequest& lcd, const Panel& panel)
{
    const std::string& path = o.inputs[0];
    const std::string output = sequence_path(lcd.output, path);
    VideoReader video(path);
    PanelImages images(panel, lcd.image);
    const QuiltSequence sequence(images, path, video.form());
    const int last = int(std::clamp<long long>(video.stated_count(), 1, 1 << 30));
    Json report = Json::array();
    Image quilt;
    for (int number = 1; video.read(quilt); ++number) {
        stop_if_interrupted();
        const auto begun = std::chrono::steady_clock::now();
        const Frame frame = images.frame_of_image(sequence.image_of(quilt));
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
        const std::string name = numbered(output, number, std::max(number, last));
        write_frame(name, frame);
        report.push_back({{"output", name},
                          {"width", frame.image.width},
                          {"height", frame.image.height},
                          {"views", sequence.grid().count()},
                          {"seconds", taken.count()}});
    }
    if (!video.fault().empty())
        throw InputError(path + ": ffmpeg finds a fault in it: " + video.fault() +
                         "; images of the " + counted(int(report.size()), "picture") +
                         " that it decodes are written");
    if (o.json)
        std::cout << Json{{"panel", panel.name}, {"images", report}}.dump(2) << '\n';
}

} // namespace integral
