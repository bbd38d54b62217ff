// SPDX-License-Identifier: AGPL-3.0-or-later
// Colours for a printer: ICC profiles, by Little CMS.
#ifndef INTEGRAL_OUTPUT_COLOUR_PROFILE_H
#define INTEGRAL_OUTPUT_COLOUR_PROFILE_H

#include "integral/lightfield/image.h"

#include <memory>
#include <string>

namespace integral {

enum class Intent { perceptual, relative, saturation, absolute };

/// The profile of sRGB: the bytes of an ICC file, the same in every run.
std::string srgb_profile();

/// Converts colours from sRGB to an RGB device's.
class ProfileTransform {
public:
    /// `profile`: the bytes of the device's ICC file. `bits`: 8 or 16, of the pictures' samples.
    /// Throws std::runtime_error, with a sentence for the user, where the bytes are no ICC profile
    /// or the device is not RGB.
    ProfileTransform(const std::string& profile, int bits, Intent intent);

    /// Converts a picture in place: three channels, encoded in sRGB.
    void apply(Image& picture) const;

private:
    std::shared_ptr<void> transform_;
};

/// A picture, converted. Throws as ProfileTransform does.
Image in_profile(Image picture, const std::string& profile, Intent intent);

} // namespace integral

#endif
