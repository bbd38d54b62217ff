// SPDX-License-Identifier: AGPL-3.0-or-later
// The table of `integral sheet --list`: figures of each lens sheet for one print.
#ifndef INTEGRAL_SHEET_SHEET_LIST_H
#define INTEGRAL_SHEET_SHEET_LIST_H

#include "integral/frame/frame_metadata.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace integral {

/// A table of the known sheets over the print's film, seen from the distance of the print's
/// aperture. The print's own sheet comes first if `with_own`. Missing figures are "-"; figures that
/// depend on the picture's size need a film with a size.
std::string sheet_list_text(const FrameMetadata& print, bool with_own);

/// The same figures as a list, lengths in mm. Missing figures are null.
nlohmann::ordered_json sheet_list_json(const FrameMetadata& print, bool with_own);

} // namespace integral

#endif
