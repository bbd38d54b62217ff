// SPDX-License-Identifier: AGPL-3.0-or-later
// Colours for a printer: ICC profiles, by Little CMS.
#ifndef INTEGRAL_OUTPUT_COLOUR_PROFILE_H
#define INTEGRAL_OUTPUT_COLOUR_PROFILE_H

#include "integral/lightfield/image.h"

#include <string>

namespace integral {

enum class Intent { perceptual, relative, saturation, absolute };

/// sRGB's own profile: the bytes of an ICC file, the same ones each time.
std::string srgb_profile();

/// A picture of three channels, encoded in sRGB, in the colours of an RGB device: bits as they are. Throws std::runtime_error, a
/// sentence, where the bytes are no ICC profile or not of an RGB device.
Image in_profile(const Image& picture, const std::string& profile, Intent intent);

} // namespace integral

#endif
