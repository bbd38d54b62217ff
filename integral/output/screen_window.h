// SPDX-License-Identifier: AGPL-3.0-or-later
// A window without borders that fills a display and shows pictures pixel for pixel.
#ifndef INTEGRAL_OUTPUT_SCREEN_WINDOW_H
#define INTEGRAL_OUTPUT_SCREEN_WINDOW_H

#include "integral/output/screen_picture.h"
#include "integral/output/screens.h"

#include <chrono>
#include <functional>
#include <memory>

namespace integral {

/// What the user asks of the window.
enum class Wish { none, end, pause };

/// Opened on a display of a Desktop that outlives it; all of its functions are for the thread that
/// opened it. The pointer is hidden and the screen saver held off meanwhile. `name` is how messages
/// call the display.
class ScreenWindow {
public:
    /// Throws OutputError where the window does not get exactly the display's pixels, or has less
    /// than 8 bits a colour.
    ScreenWindow(const Screen& screen, const std::string& name);
    ~ScreenWindow();
    ScreenWindow(const ScreenWindow&) = delete;
    ScreenWindow& operator=(const ScreenWindow&) = delete;

    /// Shows a picture of the display's size. The first is read back: throws OutputError where it
    /// is not what was drawn.
    void show(const ScreenPicture& picture);

    /// Waits so long, or until the user asks for something: Escape, q or closing the window is
    /// `end`, the space bar `pause`. Throws OutputError if the display's size changes meanwhile.
    Wish wait(std::chrono::nanoseconds longest);

private:
    struct Parts;
    void settle();
    void draw();
    void read_back(const ScreenPicture& picture);

    const Screen screen_;
    const std::string name_;
    std::unique_ptr<Parts> parts_;
};

/// Shows one picture until the user ends it, `seconds` have passed (0: no such end), or `go_on`
/// says no (it is asked ten times a second and more). Returns whether it ended otherwise than by
/// go_on.
bool show_still(ScreenWindow& window, const ScreenPicture& picture, double seconds,
                const std::function<bool()>& go_on);

/// How a sequence is played.
struct Playing {
    PicturesAhead::Source source; ///< all pictures of the display's size
    double rate = 30;             ///< pictures a second
    double seconds = 0;           ///< ends then; 0: after the last picture
};

struct PlayReport {
    long long shown = 0, dropped = 0; ///< together as many as came due
    double seconds = 0;        ///< between the first and the last picture shown, pauses left out
    double rate = 0;           ///< pictures shown a second; 0: there was one only
    double worst_lateness = 0; ///< seconds from when a picture was due until it had been handed to
                               ///< the display
    bool interrupted = false;  ///< by go_on
};

/// Shows picture k when k / rate seconds have passed since the first, pauses left out. Of pictures
/// that are late the newest is shown, the others are dropped. Begins when PicturesAhead is full.
/// Throws what `load` and the window throw.
PlayReport play(ScreenWindow& window, const Playing& playing, const std::function<bool()>& go_on);

} // namespace integral

#endif
