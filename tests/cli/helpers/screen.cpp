// SPDX-License-Identifier: AGPL-3.0-or-later
// For tests/cli/lcd_show.test: pictures of noise, and what stands on the displays of the X server
// DISPLAY.
//
// screen noise WIDTH HEIGHT SEED FILE [KIND]
//                     writes a picture whose samples are all random; KIND: rgb8 (default), rgba8
//                     (opaque), rgb16 (the same, before it was rounded to 8 bits)
// screen grab X Y WIDTH HEIGHT
//                     prints R, G and B of every pixel of the desktop's rectangle, row by row, a
//                     byte each
// screen key NAME     presses a key, by X's name of it, in the topmost window
// screen close        asks the topmost window to close, as a window manager does
// screen top          prints the topmost window's WIDTHxHEIGHT+X+Y
// Exit status: 0 done, 1 not possible, 2 wrong usage.
#include "integral/io/image_file.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <algorithm>
#include <iostream>
#include <random>
#include <stdexcept>

using namespace integral;

namespace {

bool write_noise(int width, int height, unsigned seed, const std::string& file,
                 const std::string& kind)
{
    std::mt19937 random(seed), rest(seed + 1);
    const int channels = kind == "rgba8" ? 4 : 3;
    Image eight = make_image<std::uint8_t>(width, height, channels, Encoding()),
          sixteen = make_image<std::uint16_t>(width, height, channels, Encoding());
    auto& samples = std::get<std::vector<std::uint8_t>>(eight.samples);
    for (std::size_t k = 0; k < samples.size(); ++k) {
        samples[k] = k % std::size_t(channels) == 3 ? 255 : std::uint8_t(random());
        std::get<std::vector<std::uint16_t>>(sixteen.samples)[k] = std::uint16_t(
            std::clamp(257 * samples[k] + int(rest() % 257) - 128, 0, 65535));
    }
    if (kind != "rgb8" && kind != "rgba8" && kind != "rgb16")
        return false;
    write_frame(file, Frame{kind == "rgb16" ? sixteen : eight, std::nullopt});
    return true;
}

Display* connection()
{
    Display* display = XOpenDisplay(nullptr);
    if (!display)
        throw std::runtime_error("no X server is reached");
    return display;
}

void grab(int x, int y, int width, int height)
{
    Display* display = connection();
    XImage* image = XGetImage(display, DefaultRootWindow(display), x, y, unsigned(width),
                              unsigned(height), AllPlanes, ZPixmap);
    if (!image || image->red_mask != 0xff0000 || image->green_mask != 0xff00 ||
        image->blue_mask != 0xff)
        throw std::runtime_error("the desktop cannot be read, or has other than 8 bits a colour");
    std::string samples;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const unsigned long pixel = XGetPixel(image, i, j);
            for (const int shift : {16, 8, 0})
                samples += char(pixel >> shift & 255);
        }
    std::cout << samples;
}

Window topmost(Display* display, XWindowAttributes& attributes)
{
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
    while (count-- > 0)
        if (XGetWindowAttributes(display, children[count], &attributes) &&
            attributes.map_state == IsViewable)
            return children[count];
    throw std::runtime_error("there is no window");
}

void press(const std::string& name)
{
    Display* display = connection();
    XWindowAttributes attributes;
    XKeyEvent event = {};
    event.display = display;
    event.window = topmost(display, attributes);
    event.root = DefaultRootWindow(display);
    event.same_screen = True;
    event.keycode = XKeysymToKeycode(display, XStringToKeysym(name.c_str()));
    for (const auto& [type, mask] :
         {std::pair(KeyPress, KeyPressMask), std::pair(KeyRelease, KeyReleaseMask)}) {
        event.type = type;
        XSendEvent(display, event.window, True, mask, reinterpret_cast<XEvent*>(&event));
    }
    XSync(display, False);
}

void close_window()
{
    Display* display = connection();
    XWindowAttributes attributes;
    XClientMessageEvent event = {};
    event.type = ClientMessage;
    event.window = topmost(display, attributes);
    event.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
    event.format = 32;
    event.data.l[0] = long(XInternAtom(display, "WM_DELETE_WINDOW", False));
    XSendEvent(display, event.window, False, NoEventMask, reinterpret_cast<XEvent*>(&event));
    XSync(display, False);
}

void print_topmost()
{
    XWindowAttributes a;
    topmost(connection(), a);
    std::cout << a.width << 'x' << a.height << '+' << a.x << '+' << a.y << '\n';
}

bool run(const std::vector<std::string>& w)
{
    const auto is = [&](const char* name, std::size_t count) {
        return w.size() == count + 1 && w[0] == name;
    };
    if (is("noise", 4) || is("noise", 5))
        return write_noise(std::stoi(w[1]), std::stoi(w[2]), unsigned(std::stoi(w[3])), w[4],
                           w.size() == 6 ? w[5] : "rgb8");
    if (is("grab", 4))
        grab(std::stoi(w[1]), std::stoi(w[2]), std::stoi(w[3]), std::stoi(w[4]));
    else if (is("key", 1))
        press(w[1]);
    else if (is("close", 0))
        close_window();
    else if (is("top", 0))
        print_topmost();
    else
        return false;
    return true;
}

} // namespace

int main(int count, char** words)
{
    try {
        if (run({words + 1, words + count}))
            return 0;
        std::cerr << "screen: wrong usage\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "screen: " << error.what() << '\n';
        return 1;
    }
}
