// SPDX-License-Identifier: AGPL-3.0-or-later
// Colours for a printer: ICC profiles, by Little CMS.
#ifndef INTEGRAL_OUTPUT_COLOUR_PROFILE_H
#define INTEGRAL_OUTPUT_COLOUR_PROFILE_H

#include "integral/lightfield/image.h"

#include <memory>
#include <string>

namespace integral {

enum class Intent { perceptual, relative, saturation, absolute };

/// sRGB's own profile: the bytes of an ICC file, the same ones each time.
std::string srgb_profile();

/// Brings colours of sRGB to those of an RGB device.
class ProfileTransform {
public:
    /// `profile`: the device's, an ICC file's bytes; `bits` of the samples, 8 or 16. Throws
    /// std::runtime_error, a sentence, where the bytes are no ICC profile or not of an RGB device.
    ProfileTransform(const std::string& profile, int bits, Intent intent);

    /// Changes a picture of three channels, encoded in sRGB.
    void apply(Image& picture) const;

private:
    std::shared_ptr<void> transform_;
};

/// A picture in the colours of a device. Throws as ProfileTransform does.
Image in_profile(Image picture, const std::string& profile, Intent intent);

} // namespace integral

#endif
