// SPDX-License-Identifier: AGPL-3.0-or-later
// Settings of measuring depth, from quick to exact.
#ifndef INTEGRAL_DEPTH_DEPTH_QUALITY_H
#define INTEGRAL_DEPTH_DEPTH_QUALITY_H

#include "integral/depth/multibaseline.h"

#include <string>

namespace integral {

enum class DepthQuality { draft, good, best };

/// The quality of that name; nothing for another name.
std::optional<DepthQuality> depth_quality(const std::string& name);

MultibaselineSettings settings_for(DepthQuality quality);

/// Whether a view counts whose point of disparity 1 is so far from the middle one's.
bool is_kept(Vec2 shift, DepthQuality quality);

/// Leaves out views: draft keeps those to the left, right, above and below of the middle one, good
/// and best also those on the diagonals. The others lie between these: they cost time, and the half
/// of the views that agrees best is told worse with them. Views that all stand in one row are kept.
void keep_views(ViewSet& views, DepthQuality quality);

} // namespace integral

#endif
