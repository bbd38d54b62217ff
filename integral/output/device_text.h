// SPDX-License-Identifier: AGPL-3.0-or-later
// Words in a picture that is to be printed: of a size in millimetres, in the device's own pixels,
// which need not be square.
#ifndef INTEGRAL_OUTPUT_DEVICE_TEXT_H
#define INTEGRAL_OUTPUT_DEVICE_TEXT_H

#include "integral/lightfield/image.h"

#include <string>

namespace integral {

struct DeviceFont {
    double size = 2.4; ///< mm, the em
    bool bold = false;
};

/// mm that a line of text takes. Throws std::invalid_argument where it is not UTF-8,
/// std::runtime_error where memory is short.
double text_width(const std::string& text, DeviceFont font);

/// Writes a line in black, blended in linear light, its baseline beginning at `at`: mm from the
/// picture's left and top edges. `upwards`: turned a quarter to the left. What is outside of the
/// picture is cut off. Throws as text_width does.
void write_text(Image& image, Vec2 pixel_pitch, const std::string& text, Vec2 at, DeviceFont font,
                bool upwards = false);

/// The text in lines of at most `width` mm, broken at spaces; a longer word stays whole.
std::vector<std::string> wrapped(const std::string& text, double width, DeviceFont font);

} // namespace integral

#endif
