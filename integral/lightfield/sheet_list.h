// SPDX-License-Identifier: AGPL-3.0-or-later
// The table of `integral sheet --list`: what each lens sheet would give for one print.
#ifndef INTEGRAL_LIGHTFIELD_SHEET_LIST_H
#define INTEGRAL_LIGHTFIELD_SHEET_LIST_H

#include "integral/lightfield/frame_metadata.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace integral {

/// A table of the known sheets over the print's film, seen from its aperture's distance. Its own
/// sheet comes first, if `with_own`. Figures that there are not are "-"; those of the picture's
/// size need a film with a size.
std::string sheet_list_text(const FrameMetadata& print, bool with_own);

/// The same figures as a list, lengths in mm. Figures that there are not are null.
nlohmann::ordered_json sheet_list_json(const FrameMetadata& print, bool with_own);

} // namespace integral

#endif
