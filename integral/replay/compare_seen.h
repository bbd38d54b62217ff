// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares what eyes see of two frames through their sheets.
#ifndef INTEGRAL_REPLAY_COMPARE_SEEN_H
#define INTEGRAL_REPLAY_COMPARE_SEEN_H

#include "integral/compare/seen.h"

namespace integral {

/// Replays both frames, each by its own geometry, from the rules' eyes (default: nine eyes over the
/// reference's viewing zone), with pupil and blur as a person sees a print, and compares the views.
/// A pixel of the views is a 60th of a degree, but no less than a pixel of the reference's film,
/// within 600 pixels a side. Both have metadata. Throws std::invalid_argument as PixelWeights does,
/// InputError where the mask cannot be read.
SeenFigures compare_seen(const Frame& reference, const Frame& result, const ComparisonRules& rules);

/// Compares what eyes see of frames of other sizes in pixels, which are not compared: the
/// comparison has figures of `seen` alone. The rules have neither regions nor a mask. Throws as
/// compare_seen does.
Comparison compare_only_seen(const Frame& reference, const Frame& result,
                             const ComparisonRules& rules);

/// How the sizes of two films in mm differ, in words about `b`; empty if by no more than a pixel.
std::string other_sheet(const FrameMetadata& a, const FrameMetadata& b);

} // namespace integral

#endif
