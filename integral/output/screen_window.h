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

/// What the user wants.
enum class Wish { none, end, pause };

/// A window that fills a display. While it is open, the mouse pointer is hidden and the screen
/// saver disabled. Only the thread that opened it may call its functions, and the Desktop must live
/// longer.
class ScreenWindow {
public:
    /// Messages call the display `name`. Throws OutputError if the window does not get exactly the
    /// display's pixels, or has less than 8 bits for each colour.
    ScreenWindow(const Screen& screen, const std::string& name);
    ~ScreenWindow();
    ScreenWindow(const ScreenWindow&) = delete;
    ScreenWindow& operator=(const ScreenWindow&) = delete;

    /// Shows a picture of the display's size. Reads the first one back, and throws OutputError if
    /// its pixels differ from the picture's.
    void show(const ScreenPicture& picture);

    /// Waits until the user acts, but no longer than `longest`. Escape, q and closing the window
    /// mean `end`; the space bar means `pause`. Throws OutputError if the display's size changes
    /// meanwhile.
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

/// Shows one picture until the user ends it, `seconds` have passed (0: no limit), or `go_on`
/// returns false; go_on is called at least ten times a second. Returns false if go_on ended it.
bool show_still(ScreenWindow& window, const ScreenPicture& picture, double seconds,
                const std::function<bool()>& go_on);

/// How a sequence is played.
struct Playing {
    PicturesAhead::Source source; ///< all pictures have the display's size
    double rate = 30;             ///< pictures a second
    double seconds = 0;           ///< until it ends; 0: it ends after the last picture
};

struct PlayReport {
    long long shown = 0, dropped = 0; ///< the sum is the number of pictures that were due
    double seconds = 0;        ///< between the first and the last picture shown, without pauses
    double rate = 0;           ///< pictures shown a second; 0 if only one was shown
    double worst_lateness = 0; ///< seconds from when a picture was due until it had been handed to
                               ///< the display
    bool interrupted = false;  ///< by go_on
};

/// Shows picture k when k / rate seconds have passed since the first, without pauses. If several
/// pictures are due, it shows the newest and drops the others. Begins when PicturesAhead is full.
/// Throws what `load` and the window throw.
PlayReport play(ScreenWindow& window, const Playing& playing, const std::function<bool()>& go_on);

} // namespace integral

#endif
