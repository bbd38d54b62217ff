// SPDX-License-Identifier: AGPL-3.0-or-later
// Pictures that are shown one after another, as an animated WebP.
#ifndef INTEGRAL_IO_ANIMATION_H
#define INTEGRAL_IO_ANIMATION_H

#include "integral/lightfield/image.h"

#include <string>
#include <vector>

namespace integral {

/// Whether this build has libwebp.
bool can_animate();

/// Pictures of one size, at most `largest_side` pixels either way. Each is kept encoded: 8 bits,
/// sRGB, not premultiplied.
class Animation {
public:
    static constexpr int largest_side = 16383;

    /// `quality` 0 to 100; 100 keeps every 8-bit value.
    explicit Animation(int quality) : quality_(quality) {}

    /// Throws std::runtime_error with the reason.
    void add(const Image& picture);

    /// The file: each picture shown for `milliseconds` > 0, for ever. there_and_back: from the last
    /// one back to the first, the two ends once each. Throws as add does, or where there are no
    /// pictures.
    std::string bytes(int milliseconds, bool there_and_back) const;

private:
    int quality_;
    int width_ = 0, height_ = 0;
    std::vector<std::string> pictures_; ///< WebP files
};

} // namespace integral

#endif
