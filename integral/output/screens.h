// SPDX-License-Identifier: AGPL-3.0-or-later
// The displays of the desktop, and whether they show a picture's pixels as they are.
#ifndef INTEGRAL_OUTPUT_SCREENS_H
#define INTEGRAL_OUTPUT_SCREENS_H

#include <string>
#include <vector>

namespace integral {

/// A display.
struct Screen {
    int index = 0;             ///< SDL's
    std::string name;          ///< as the desktop calls it: HDMI-1
    int x = 0, y = 0;          ///< where on the desktop its top left corner is
    int width = 0, height = 0; ///< its pixels
    double rate = 0;           ///< Hz; 0: not known
    std::string scaled; ///< why pixels would be scaled on their way to it, and what helps; empty:
                        ///< they are not
};

/// A display as an X server drives it.
struct XOutput {
    std::string name;
    int x = 0, y = 0, width = 0, height = 0; ///< its part of the desktop, after turning
    int mode_width = 0, mode_height = 0;     ///< what is sent to it, turned likewise
    int preferred_width = 0,
        preferred_height = 0; ///< the mode of its own pixels, turned likewise; 0: it has not told
    double rate = 0;
    bool transformed = false; ///< resampled on the way, as xrandr --scale and --transform do
};

/// The X server's displays; empty if it does not say. `in_wayland`: the server is a guest of a
/// Wayland compositor.
std::vector<XOutput> x_outputs(bool& in_wayland);

/// Why it does not show the desktop pixel for pixel, and what helps; empty if it does.
std::string why_scaled(const XOutput& output);

/// The desktop's displays as long as this lives; there may be one at a time. Without SDL2 in the
/// build, or where no display is reached, the constructor throws OutputError.
class Desktop {
public:
    Desktop();
    ~Desktop();
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    const std::vector<Screen>& screens() const { return screens_; }

private:
    std::vector<Screen> screens_;
};

/// "display 2 (HDMI-1)".
std::string call(const std::vector<Screen>& screens, std::size_t k);

/// The place in `screens` of the one that `wanted` tells, a number from 1 or a name, and that shows
/// width x height pixels of the picture `picture` as they are; "auto": of the only one with so many
/// pixels. Throws OutputError.
std::size_t choose_screen(const std::vector<Screen>& screens, const std::string& wanted,
                          const std::string& picture, int width, int height);

} // namespace integral

#endif
