// SPDX-License-Identifier: AGPL-3.0-or-later
// Converts colours for a printer by ICC profiles, with Little CMS.
#ifndef INTEGRAL_PRINT_COLOUR_PROFILE_H
#define INTEGRAL_PRINT_COLOUR_PROFILE_H

#include "integral/frame/image.h"

#include <memory>
#include <string>

namespace integral {

enum class Intent { perceptual, relative, saturation, absolute };

/// The profile of sRGB: the bytes of an ICC file, the same in every run.
std::string srgb_profile();

/// Converts sRGB colours to the colours of an RGB device or the inks of a CMYK press.
class ProfileTransform {
public:
    /// `profile`: the bytes of the device's ICC file. `bits`: 8 or 16, of the pictures' samples.
    /// The relative intent compensates for the black point; black ink is generated as the profile
    /// has it. Throws std::runtime_error, with a sentence for the user, if the bytes are no ICC
    /// profile or the device is neither RGB nor CMYK.
    ProfileTransform(const std::string& profile, int bits, Intent intent);

    /// Three (R, G, B), or four (C, M, Y, K, where full scale is full ink).
    int channels() const { return channels_; }

    /// Returns a picture (three channels, encoded in sRGB) in the device's colours.
    Image apply(Image picture) const;

private:
    std::shared_ptr<void> transform_;
    int channels_ = 3;
};

/// The description in an ICC file's bytes, in ASCII; empty if it has none.
std::string profile_description(const std::string& profile);

/// Converts a picture by a ProfileTransform. Throws as its constructor does.
Image in_profile(Image picture, const std::string& profile, Intent intent);

} // namespace integral

#endif
