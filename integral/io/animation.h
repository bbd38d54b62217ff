// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes an animated WebP from pictures.
#ifndef INTEGRAL_IO_ANIMATION_H
#define INTEGRAL_IO_ANIMATION_H

#include "integral/frame/image.h"

#include <string>
#include <vector>

namespace integral {

/// Whether this build has libwebp.
bool can_animate();

/// An animation of pictures of the same size, at most `largest_side` pixels wide and high. Each is
/// encoded when it is added: 8 bits, sRGB, not premultiplied.
class Animation {
public:
    static constexpr int largest_side = 16383;

    /// `quality`: 0 to 100; 100 is lossless for 8-bit values.
    explicit Animation(int quality) : quality_(quality) {}

    /// Appends a picture. Throws std::runtime_error with the reason if its size differs from the
    /// first picture's or is too large, or if libwebp fails.
    void add(const Image& picture);

    /// The file's bytes. Each picture is shown for `milliseconds` > 0, and the animation repeats
    /// without end. `there_and_back`: after the last picture, the inner pictures follow in reverse
    /// order. Throws std::runtime_error if libwebp fails or there are no pictures.
    std::string bytes(int milliseconds, bool there_and_back) const;

private:
    int quality_;
    int width_ = 0, height_ = 0;
    std::vector<std::string> pictures_; ///< WebP files
};

} // namespace integral

#endif
