// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares frames with a panel: which are shown as they are, and what the others lack.
#ifndef INTEGRAL_PANEL_PANEL_LIKENESS_H
#define INTEGRAL_PANEL_PANEL_LIKENESS_H

#include "integral/frame/view_eyes.h"
#include "integral/sheet/panel.h"

#include <optional>
#include <string>

namespace integral {

/// The properties that a frame shares with frames rendered for a panel.
struct FrameLikeness {
    bool lenses, size, pixel_pitch, colours;

    /// Whether the frame's pixels are the panel's, under the same lenses.
    bool all() const { return lenses && size && pixel_pitch && colours; }
    /// Whether the frame seems to be meant for the panel, with one of the two changed since.
    bool nearly() const { return pixel_pitch && (lenses || (size && colours)); }
};

FrameLikeness likeness(const FrameMetadata& frame, const FrameMetadata& panel);

/// The reason why a frame that seems to have been meant for the panel is not passed through;
/// nothing for other frames.
std::optional<std::string> near_miss(const FrameMetadata& frame, const FrameMetadata& panel);

/// Returns `eyes`, which are from a frame's views, if the panel is as large as the frame's film.
/// Otherwise nothing: a smaller or larger panel spreads the views over its own zone, as it spreads
/// their pictures over its pixels.
std::optional<EyeGrid> eyes_before(const Film& panel, const FrameMetadata& frame, EyeGrid eyes);

/// A message about a frame that was rendered for the panel, but for eyes at another distance or in
/// a zone of another size; nothing if both are the panel's.
std::optional<std::string> other_zone(const Aperture& frame, const Panel& of);

/// A message about a frame whose lenses show no new views in a direction in which the panel's
/// lenses do; nothing if there is no such direction.
std::optional<std::string> missing_views(const LensSheet& frame, const LensSheet& panel);

} // namespace integral

#endif
