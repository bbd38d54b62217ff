// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/screen/screens.h"

#include "integral/base/file_bytes.h"
#include "integral/base/number_text.h"

#ifdef HAVE_SDL2
#include <SDL.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace integral {

std::string why_scaled(const XOutput& o)
{
    const std::string xrandr = "; xrandr --output " + o.name;
    if (o.transformed || o.width != o.mode_width || o.height != o.mode_height)
        return size_text(o.width, o.height) + " pixels of the desktop are resampled to its " +
               size_text(o.mode_width, o.mode_height) + xrandr +
               " --scale 1x1 --transform none ends that";
    if (o.preferred_width > 0 &&
        (o.preferred_width != o.mode_width || o.preferred_height != o.mode_height))
        return "it is sent " + size_text(o.mode_width, o.mode_height) + " pixels and has itself " +
               size_text(o.preferred_width, o.preferred_height) + xrandr +
               " --preferred sends those";
    return "";
}

std::string call(const std::vector<Screen>& screens, std::size_t k)
{
    return "display " + std::to_string(k + 1) + " (" + screens[k].name + ")";
}

std::size_t choose_screen(const std::vector<Screen>& screens, const std::string& requested,
                          const std::string& picture, int width, int height)
{
    std::vector<std::size_t> chosen;
    std::string all;
    for (std::size_t k = 0; k < screens.size(); ++k) {
        const bool fits = screens[k].width == width && screens[k].height == height;
        if (requested == "auto"
                ? fits
                : requested == std::to_string(k + 1) || requested == screens[k].name)
            chosen.push_back(k);
        all += std::string(k ? ", " : "") + call(screens, k) + " " +
               size_text(screens[k].width, screens[k].height);
    }
    const std::string pixels = picture + ": " + size_text(width, height) + " pixels";
    if (requested == "auto" && chosen.empty())
        throw OutputError(pixels + " fit no display, and pictures are never scaled; there is " +
                          all);
    if (requested == "auto" && chosen.size() > 1)
        throw OutputError(pixels + " fit " + std::to_string(chosen.size()) +
                          " displays; --show NUMBER says which: " + all);
    if (chosen.empty())
        throw OutputError(requested + ": there is no such display; there is " + all);
    const Screen& screen = screens[chosen[0]];
    if (screen.width != width || screen.height != height)
        throw OutputError(pixels + ", but " + call(screens, chosen[0]) + " has " +
                          size_text(screen.width, screen.height) +
                          "; pictures are never scaled: make one of its size");
    if (!screen.scaled.empty())
        throw OutputError(call(screens, chosen[0]) + ": " + screen.scaled);
    return chosen[0];
}

#ifdef HAVE_SDL2

namespace {

bool is_set(const char* variable)
{
    const char* value = std::getenv(variable);
    return value && *value;
}

/// Calls visit(Screen, const SDL_DisplayMode& desktop) with each display of SDL. The Screen's size
/// is its part of the desktop.
template <class Visit> void for_each_display(Visit visit)
{
    for (int k = 0; k < SDL_GetNumVideoDisplays(); ++k) {
        SDL_Rect place;
        SDL_DisplayMode mode;
        if (SDL_GetDisplayBounds(k, &place) != 0 || SDL_GetDesktopDisplayMode(k, &mode) != 0)
            continue;
        const char* name = SDL_GetDisplayName(k);
        visit(Screen{k, name ? name : "", place.x, place.y, place.w, place.h,
                     double(mode.refresh_rate), ""},
              mode);
    }
}

/// All displays of SDL, with the X server's data on them.
std::vector<Screen> x_screens()
{
    bool in_wayland = false;
    std::vector<XOutput> outputs = x_outputs(in_wayland);
    const bool told = !outputs.empty();
    std::vector<Screen> screens;
    for_each_display([&](Screen screen, const SDL_DisplayMode&) {
        const auto output = std::find_if(outputs.begin(), outputs.end(), [&](const XOutput& o) {
            return o.x == screen.x && o.y == screen.y && o.width == screen.width &&
                   o.height == screen.height;
        });
        if (output != outputs.end()) {
            screen.name = output->name;
            screen.rate = output->rate;
            screen.scaled = why_scaled(*output);
            screen.width = output->mode_width;
            screen.height = output->mode_height;
            outputs.erase(output);
        } else if (told) {
            return; // the display belongs to another X screen, out of this one's reach
        }
        if (in_wayland)
            screen.scaled = "its X server is the guest of a Wayland compositor, which may scale; "
                            "SDL_VIDEODRIVER=wayland asks that itself";
        screens.push_back(screen);
    });
    return screens;
}

/// All displays of SDL if its driver is not x11. The largest mode is taken as the native
/// resolution, which SDL does not report.
std::vector<Screen> other_screens()
{
    std::vector<Screen> screens;
    for_each_display([&](Screen screen, const SDL_DisplayMode& desktop) {
        screen.width = desktop.w;
        screen.height = desktop.h;
        SDL_DisplayMode mode;
        for (int m = 0; m < SDL_GetNumDisplayModes(screen.index); ++m)
            if (SDL_GetDisplayMode(screen.index, m, &mode) == 0 &&
                double(mode.w) * mode.h > double(screen.width) * screen.height) {
                screen.width = mode.w;
                screen.height = mode.h;
            }
        screens.push_back(screen);
    });
    return screens;
}

} // namespace

Desktop::Desktop()
{
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    // The window stays when the user types into a window on another display.
    SDL_SetHint(SDL_HINT_VIDEO_MINIMIZE_ON_FOCUS_LOSS, "0");
    // Pairs of a driver's name and the environment variable that is set if the driver works.
    // Wayland comes first, because the X server that a Wayland compositor runs hides the
    // compositor's scaling. (SDL's own choice would include drivers without a display.)
    std::vector<std::pair<const char*, const char*>> drivers;
    for (const auto& driver :
         {std::pair("wayland", "WAYLAND_DISPLAY"), std::pair("x11", "DISPLAY")})
        if (is_set(driver.second))
            drivers.push_back(driver);
    if (is_set("SDL_VIDEODRIVER"))
        drivers = {{std::getenv("SDL_VIDEODRIVER"), "SDL_VIDEODRIVER"}};
    if (drivers.empty())
        throw OutputError("no display is reached: neither DISPLAY nor WAYLAND_DISPLAY is set; run "
                          "in a desktop's session, or set DISPLAY=:0");
    std::string failures;
    for (const auto& [driver, variable] : drivers) {
        SDL_SetHint("SDL_VIDEODRIVER", driver);
        if (SDL_Init(SDL_INIT_VIDEO) == 0)
            break;
        failures += std::string(failures.empty() ? "" : ", ") + variable + "=" +
                    std::getenv(variable) + " (" + SDL_GetError() + ")";
        SDL_Quit();
    }
    if (!SDL_WasInit(SDL_INIT_VIDEO))
        throw OutputError("no display is reached by " + failures + "; run in a desktop's session");
    const std::string driver = SDL_GetCurrentVideoDriver();
    screens_ = driver == "x11" ? x_screens() : other_screens();
    if (screens_.empty()) {
        SDL_Quit();
        throw OutputError("there is no display; connect one and switch it on");
    }
}

Desktop::~Desktop() { SDL_Quit(); }

#else

Desktop::Desktop()
{
    throw OutputError("this program was built without SDL2 and shows nothing; install libsdl2-dev "
                      "and build it again");
}
Desktop::~Desktop() = default;

#endif

} // namespace integral
