// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws text into a picture for a printer or panel. Text sizes are in millimetres, and the device's
// pixels need not be square.
#ifndef INTEGRAL_IO_DEVICE_TEXT_H
#define INTEGRAL_IO_DEVICE_TEXT_H

#include "integral/frame/image.h"

#include <string>

namespace integral {

struct DeviceFont {
    double size = 2.4; ///< the em, mm
    bool bold = false;
};

/// The width of a line of text, mm. Throws std::invalid_argument if it is not UTF-8,
/// std::runtime_error if cairo fails, for lack of memory.
double text_width(const std::string& text, DeviceFont font);

/// Writes a line in black, blended in linear light. Its baseline begins at `at`, mm from the
/// picture's left and top edges. `upwards`: the line is turned by 90 degrees, to be read from
/// bottom to top. Parts outside the picture are cut off. Throws as text_width does.
void write_text(Image& image, Vec2 pixel_pitch, const std::string& text, Vec2 at, DeviceFont font,
                bool upwards = false);

/// Breaks a text at spaces into lines of at most `width` mm. A longer word gets a line of its own.
std::vector<std::string> wrapped(const std::string& text, double width, DeviceFont font);

} // namespace integral

#endif
