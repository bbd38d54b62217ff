// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares two frames as eyes see them through their sheets.
#ifndef INTEGRAL_REPLAY_COMPARE_SEEN_H
#define INTEGRAL_REPLAY_COMPARE_SEEN_H

#include "integral/compare/seen.h"

namespace integral {

/// Replays both frames, each by its own geometry, from the rules' eyes (default: nine eyes over the
/// reference's viewing zone), with pupil and blur as a person sees a print, and compares the views.
/// A pixel of the views spans a 60th of a degree or a pixel of the reference's film, whichever is
/// more; a view has at most 600 pixels a side. Both frames have metadata. Throws
/// std::invalid_argument as PixelWeights does, InputError if the mask cannot be read.
SeenFigures compare_seen(const Frame& reference, const Frame& result, const ComparisonRules& rules);

/// Compares the eyes' views of two frames with different numbers of pixels. The frames' own pixels
/// are not compared: only `seen` has figures. The rules must have neither regions nor a mask.
/// Throws as compare_seen does.
Comparison compare_only_seen(const Frame& reference, const Frame& result,
                             const ComparisonRules& rules);

/// The difference in size of two films, mm, in words about `b`; empty if it is at most a pixel.
std::string other_sheet(const FrameMetadata& a, const FrameMetadata& b);

} // namespace integral

#endif
