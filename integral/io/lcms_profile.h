// SPDX-License-Identifier: AGPL-3.0-or-later
// Owns an ICC profile opened by Little CMS.
#ifndef INTEGRAL_IO_LCMS_PROFILE_H
#define INTEGRAL_IO_LCMS_PROFILE_H

#include <lcms2.h>

#include <memory>

namespace integral {

struct CloseProfile {
    void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using Profile = std::unique_ptr<void, CloseProfile>;

} // namespace integral

#endif
