// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/screen/screen_show.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace integral {
namespace {

using Size = std::pair<int, int>; // width and height, pixels

constexpr double pictures_a_second = 30; // of files, unless a rate is given

std::string text_of(Size size) { return size_text(size.first, size.second); }

/// The size of all files. Throws if they differ.
Size common_size(const std::vector<std::string>& files)
{
    Size first;
    for (const std::string& file : files) {
        stop_if_interrupted();
        const Size size = picture_size(file);
        if (&file == &files.front())
            first = size;
        else if (size != first)
            throw InputError(file + ": it has " + text_of(size) + " pixels, and " + files.front() +
                             " " + text_of(first) + "; pictures that are played have one size");
    }
    return first;
}

ScreenPicture load_picture(const std::string& file, Size size)
{
    ScreenPicture picture = screen_picture(read_views(file, false).image);
    const Size loaded{picture.width, picture.height};
    if (loaded != size)
        throw InputError(file + ": it has " + text_of(loaded) + " pixels, and had " +
                         text_of(size) + " before");
    return picture;
}

/// Opens a window on the display that shows pictures of this size pixel for pixel.
ScreenWindow window_on(const Desktop& desktop, const std::string& display,
                       const std::string& picture, Size size)
{
    const std::size_t k = choose_screen(desktop.screens(), display, picture, size.first,
                                        size.second);
    return ScreenWindow(desktop.screens()[k], call(desktop.screens(), k));
}

bool may_go_on() { return !interrupted(); }

/// Plays the pictures of a source, whose other fields are set, on a display. `name`: the first
/// picture's, in messages.
PlayReport play_source(PicturesAhead::Source source, Size size, const std::string& name,
                       double rate, bool loop, const ShowOptions& options)
{
    source.loop = loop;
    source.keep = pictures_to_keep(sizeof(std::uint32_t) * std::size_t(size.first) *
                                   std::size_t(size.second));
    const Desktop desktop;
    ScreenWindow window = window_on(desktop, options.display, name, size);
    return play(window, {std::move(source), rate, options.seconds}, may_go_on);
}

} // namespace

void check_display(int width, int height, const std::string& name, const ShowOptions& options)
{
    choose_screen(Desktop().screens(), options.display, name, width, height);
}

void show_picture(const Image& picture, const std::string& name, const ShowOptions& options)
{
    const Desktop desktop;
    ScreenWindow window = window_on(desktop, options.display, name,
                                    {picture.width, picture.height});
    if (!show_still(window, screen_picture(picture), options.seconds, may_go_on))
        throw Interrupted();
}

PlayReport play_files(const std::vector<std::string>& files, const PlayOptions& playing,
                      const ShowOptions& options)
{
    const Size size = common_size(files);
    PicturesAhead::Source source;
    source.count = static_cast<long long>(files.size());
    source.threads = playing.threads > 0 ? playing.threads
                                         : std::max(1, int(std::thread::hardware_concurrency()));
    source.load = [&](long long file) { return load_picture(files[std::size_t(file)], size); };
    return play_source(std::move(source), size, files.front(),
                       playing.rate.value_or(pictures_a_second), playing.loop, options);
}

PlayReport play_video(VideoReader& video, int width, int height,
                      const std::function<Image(Image)>& finish, const PlayOptions& playing,
                      const ShowOptions& options)
{
    PicturesAhead::Source source;
    source.threads = 2; // one reads while the other finishes a picture
    source.read = [&](long long number) -> PicturesAhead::Completion {
        if (number == 0)
            video.rewind();
        const auto picture = std::make_shared<Image>();
        if (!video.read(*picture))
            return {};
        return [&finish, picture] { return screen_picture(finish(std::move(*picture))); };
    };
    return play_source(std::move(source), {width, height}, video.path(),
                       playing.rate.value_or(video.rate()), playing.loop, options);
}

} // namespace integral
