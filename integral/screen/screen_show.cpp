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
    Playing pictures;
    pictures.rate = playing.rate;
    pictures.seconds = options.seconds;
    pictures.source.count = static_cast<long long>(files.size());
    pictures.source.loop = playing.loop;
    pictures.source.keep = pictures_to_keep(sizeof(std::uint32_t) * std::size_t(size.first) *
                                            std::size_t(size.second));
    pictures.source.threads = playing.threads > 0
                                  ? playing.threads
                                  : std::max(1, int(std::thread::hardware_concurrency()));
    pictures.source.load = [&](long long file) {
        return load_picture(files[std::size_t(file)], size);
    };
    const Desktop desktop;
    ScreenWindow window = window_on(desktop, options.display, files.front(), size);
    return play(window, pictures, may_go_on);
}

} // namespace integral
