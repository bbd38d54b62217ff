// SPDX-License-Identifier: AGPL-3.0-or-later
// Lists the displays of the desktop, and whether they show a picture's pixels as they are.
#ifndef INTEGRAL_SCREEN_SCREENS_H
#define INTEGRAL_SCREEN_SCREENS_H

#include <string>
#include <vector>

namespace integral {

/// A display.
struct Screen {
    int index = 0;             ///< SDL's number of the display
    std::string name;          ///< the desktop's name for it, such as HDMI-1
    int x = 0, y = 0;          ///< position of its top left corner on the desktop, pixels
    int width = 0, height = 0; ///< pixels
    double rate = 0;           ///< refresh rate, Hz; 0: not known
    std::string scaled; ///< why the desktop or the display would scale pixels, and what helps;
                        ///< empty if neither scales
};

/// A display as an X server drives it.
struct XOutput {
    std::string name;
    // All sizes are in pixels, after the display's rotation.
    int x = 0, y = 0, width = 0, height = 0;       ///< its part of the desktop
    int mode_width = 0, mode_height = 0;           ///< of the signal sent to it
    int preferred_width = 0, preferred_height = 0; ///< its native resolution; 0: not known
    double rate = 0;                               ///< refresh rate, Hz; 0: not known
    bool transformed = false; ///< the X server resamples pixels (xrandr --scale or --transform)
};

/// The X server's displays; empty if it does not list them. Sets `in_wayland` if the server is
/// XWayland, which a Wayland compositor runs.
std::vector<XOutput> x_outputs(bool& in_wayland);

/// The reason why the display does not show the desktop pixel for pixel, and the remedy; empty if
/// it does.
std::string why_scaled(const XOutput& output);

/// A connection to the desktop, with its displays. Only one may exist at a time. The constructor
/// throws OutputError if no display can be reached, or if the program was built without SDL2.
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

/// The name of screens[k] in messages: "display 2 (HDMI-1)".
std::string call(const std::vector<Screen>& screens, std::size_t k);

/// Index in `screens` of the display `requested`: a number from 1, a name, or "auto" for the only
/// display of width x height pixels. Throws OutputError if there is no such display, or if it would
/// not show width x height pixels as they are; the message calls the picture `picture`.
std::size_t choose_screen(const std::vector<Screen>& screens, const std::string& requested,
                          const std::string& picture, int width, int height);

} // namespace integral

#endif
