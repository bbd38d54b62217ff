// SPDX-License-Identifier: AGPL-3.0-or-later
// A window without borders that fills a display and shows pictures pixel for pixel.
#ifndef INTEGRAL_SCREEN_SCREEN_WINDOW_H
#define INTEGRAL_SCREEN_SCREEN_WINDOW_H

#include "integral/screen/screen_picture.h"
#include "integral/screen/screens.h"

#include <chrono>
#include <functional>
#include <memory>

namespace integral {

/// The user's request.
enum class Wish { none, end, pause };

/// A window that fills a display. While it is open, the mouse pointer is hidden and the screen
/// saver disabled. Only the thread that opened the window may call its functions. The Desktop must
/// outlive the window.
class ScreenWindow {
public:
    /// Messages call the display `name`. Throws OutputError if the window does not get exactly the
    /// display's pixels, or has less than 8 bits for each colour.
    ScreenWindow(const Screen& screen, const std::string& name);
    ~ScreenWindow();
    ScreenWindow(const ScreenWindow&) = delete;
    ScreenWindow& operator=(const ScreenWindow&) = delete;

    /// Shows a picture of the display's size. Reads the first picture back, and throws OutputError
    /// if what is drawn differs from it.
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

/// Settings for playing a sequence.
struct Playing {
    PicturesAhead::Source source; ///< all pictures have the display's size
    double rate = 30;             ///< pictures a second
    double seconds = 0;           ///< duration; 0: until the last picture has been shown
};

struct PlayReport {
    long long shown = 0, dropped = 0; ///< the sum is the number of pictures that were due
    double seconds = 0;        ///< between the first and the last picture shown, without pauses
    double rate = 0;           ///< pictures shown a second; 0 if only one was shown
    double worst_lateness = 0; ///< seconds from a picture's due time to its handover to the display
    bool interrupted = false;  ///< by go_on
};

/// Shows picture k when k / rate seconds have passed since the first picture, not counting pauses.
/// If several pictures are due, shows the newest and drops the older ones. Begins when
/// PicturesAhead is full. Throws what `load` and the window throw.
PlayReport play(ScreenWindow& window, const Playing& playing, const std::function<bool()>& go_on);

} // namespace integral

#endif
