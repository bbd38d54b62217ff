// SPDX-License-Identifier: AGPL-3.0-or-later
// Converts pictures from the ICC profile embedded in their file to the working space, by Little
// CMS.
#ifndef INTEGRAL_IO_EMBEDDED_PROFILE_H
#define INTEGRAL_IO_EMBEDDED_PROFILE_H

#include <cstddef>
#include <memory>
#include <string>

namespace integral {

/// Meaning of a stored pixel's numbers.
enum class Inks {
    grey,         ///< the first of three equal channels
    rgb,          ///< three channels
    cmyk,         ///< 0 is no ink
    inverted_cmyk ///< 0 is full ink, as in JPEGs
};

/// Converts pixels to the working space: sRGB, or for floats linear light of sRGB's primaries.
/// Relative colorimetric, with black point compensation.
class ToWorkingSpace {
public:
    /// `profile`: the bytes of an ICC file; "" is allowed for CMYK only; it gives the conversion
    /// that viewers use without a profile, red = (1 - C) (1 - K). `bits`: 8, 16 or 32 (floats; not
    /// CMYK). `extra`: number of further channels per pixel, which are left unchanged. Throws
    /// std::runtime_error, with a sentence for the user, if the bytes are not a profile for `inks`.
    ToWorkingSpace(const std::string& profile, Inks inks, int bits, int extra);

    /// False if no colour in a grid of 8-bit colours changes by more than 1, as with the many
    /// copies of sRGB's profile. The pixels are then best left unchanged.
    bool changes_colours() const;

    /// Converts `pixels` pixels to R, G and B. For grey and RGB, `from` and `to` are the same.
    void apply(const void* from, void* to, std::size_t pixels) const;

private:
    std::shared_ptr<void> transform_; ///< null for CMYK without a profile
    bool inverted_, wide_;
    bool changes_ = true;
};

} // namespace integral

#endif
