// SPDX-License-Identifier: AGPL-3.0-or-later
// Shows a picture, or plays a sequence of picture files, on a display of the desktop, pixel for
// pixel.
#ifndef INTEGRAL_SCREEN_SCREEN_SHOW_H
#define INTEGRAL_SCREEN_SCREEN_SHOW_H

#include "integral/frame/image.h"
#include "integral/io/video_reader.h"
#include "integral/screen/screen_window.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace integral {

/// Display and duration for showing pictures.
struct ShowOptions {
    std::string display = "auto"; ///< the argument `requested` of choose_screen
    double seconds = 0;           ///< duration; 0: until the user ends it
};

/// Throws OutputError as show_picture does, before there is a picture of that size.
void check_display(int width, int height, const std::string& name, const ShowOptions& options);

/// Shows a picture, which messages call `name`. Throws OutputError if no display shows it pixel for
/// pixel, Interrupted after an interruption.
void show_picture(const Image& picture, const std::string& name, const ShowOptions& options);

struct PlayOptions {
    std::optional<double> rate; ///< pictures a second; nothing: the video's, or 30
    bool loop = false;
    int threads = 0; ///< decoding threads of files; 0: one for each core
};

/// Plays picture files of one size. An interruption ends play; the report says so. Throws
/// InputError if a file cannot be read or has another size, OutputError as show_picture does.
PlayReport play_files(const std::vector<std::string>& files, const PlayOptions& playing,
                      const ShowOptions& options);

/// Plays a video, which has not been read yet. `finish` makes, of each picture of the video, the
/// picture of width x height pixels to show; two threads call it at once. Throws as play_files
/// does.
PlayReport play_video(VideoReader& video, int width, int height,
                      const std::function<Image(Image)>& finish, const PlayOptions& playing,
                      const ShowOptions& options);

} // namespace integral

#endif
