// SPDX-License-Identifier: AGPL-3.0-or-later
// Shows pictures on a display of the desktop, pixel for pixel: one, or files one after another.
#ifndef INTEGRAL_OUTPUT_SCREEN_SHOW_H
#define INTEGRAL_OUTPUT_SCREEN_SHOW_H

#include "integral/lightfield/image.h"
#include "integral/output/screen_window.h"

#include <string>
#include <vector>

namespace integral {

/// Where and how long pictures are shown.
struct ShowOptions {
    std::string display = "auto"; ///< as choose_screen takes it
    double seconds = 0;           ///< ends after so long; 0: when the user ends it
};

/// Shows a picture. `name` is how messages call it. Throws OutputError where no display takes the
/// picture as it is, Interrupted.
void show_picture(const Image& picture, const std::string& name, const ShowOptions& options);

struct PlayOptions {
    double rate = 30; ///< pictures a second
    bool loop = false;
    int threads = 0; ///< that decode files; 0: one per core
};

/// Plays picture files of one size. An interruption ends it, as the report says. Throws InputError
/// where a file cannot be read or is of another size, OutputError as show_picture does.
PlayReport play_files(const std::vector<std::string>& files, const PlayOptions& playing,
                      const ShowOptions& options);

} // namespace integral

#endif
