// SPDX-License-Identifier: AGPL-3.0-or-later
// Shows pictures as viewers do: upright, in the colours that their embedded profile describes.
#ifndef INTEGRAL_IO_AS_SHOWN_H
#define INTEGRAL_IO_AS_SHOWN_H

#include "integral/io/codecs.h"
#include "integral/io/embedded_profile.h"

namespace integral {

/// A reader of the same picture, turned by its orientation and converted from its profile to the
/// working space. Returns `stored` itself if neither is needed. A turned picture is held in memory
/// whole. A profile that cannot be used is ignored, with a notice.
std::unique_ptr<RowReader> as_shown(std::unique_ptr<RowReader> stored);

/// A reader of the picture turned by an orientation, 1 to 8, whatever its own is. Returns `stored`
/// itself for 1.
std::unique_ptr<RowReader> turned(std::unique_ptr<RowReader> stored, int orientation);

/// The conversion of CMYK pixels from their profile. Without a usable profile, returns the
/// conversion for "" and adds a notice to `reader`.
ToWorkingSpace cmyk_conversion(const std::string& profile, Inks inks, int bits, RowReader& reader);

} // namespace integral

#endif
