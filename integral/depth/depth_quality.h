// SPDX-License-Identifier: AGPL-3.0-or-later
// Settings for measuring depth, from fast to accurate.
#ifndef INTEGRAL_DEPTH_DEPTH_QUALITY_H
#define INTEGRAL_DEPTH_DEPTH_QUALITY_H

#include "integral/depth/multibaseline.h"

#include <string>

namespace integral {

enum class DepthQuality { draft, good, best };

/// The quality of that name; nothing for another name.
std::optional<DepthQuality> depth_quality(const std::string& name);

MultibaselineSettings settings_for(DepthQuality quality);

/// Whether a view with that DepthView::shift is used at that quality.
bool is_kept(Vec2 shift, DepthQuality quality);

/// Removes views: draft keeps the views to the left, right, above and below the middle one; good
/// and best also keep the views on the diagonals. Others cost time and make the half of the views
/// that agrees best harder to find. Keeps views that all stand in a row.
void keep_views(ViewSet& views, DepthQuality quality);

} // namespace integral

#endif
