// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes where eyes in the viewing zone see one of several pictures alone, and the share of the
// other pictures in its light.
#ifndef INTEGRAL_OUTPUT_ZONE_VIEW_H
#define INTEGRAL_OUTPUT_ZONE_VIEW_H

#include "integral/replay/frame_of_shares.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

constexpr int eyes_across_zone = 41;

/// A part of the zone, mm from its middle: to the right, or upwards.
struct ZonePart {
    double from = 0, to = 0;
};

/// The share of one place in the order.
struct ShareView {
    int picture = 0;               ///< index
    ZonePart part;                 ///< between the middles of the transitions
    std::optional<ZonePart> alone; ///< where at most 3% of the light is others'
};

/// The shares of the pictures in the light that an eye at the viewing distance gets.
struct EyeShares {
    double place = 0;           ///< mm from the zone's middle
    std::optional<int> picture; ///< that should be seen alone; nothing: a transition
    std::vector<double> shares; ///< of each picture in the light, by index; their sum is 1
};

/// All that is known of a division.
struct ZoneView {
    ZoneAxis axis = ZoneAxis::sideways;
    double distance = 0; ///< mm from the sheet
    double width = 0;    ///< of the zone, mm
    double blur = 0;     ///< mm on either side of a border in which the sheet mixes more than 3% of
                         ///< one neighbour into the other, beside the transition that was asked for
    std::vector<ShareView> parts;
    std::vector<EyeShares> eyes;  ///< eyes_across_zone of them, at the centres of equal parts
    double greatest_other = 0;    ///< what an eye outside all transitions sees of other pictures
};

/// Works it out by replay, with pupil, printed dots and the lenses' blur (set_as_seen), of a part
/// of the sheet a few lenses high. `count`: the number of pictures; `order` as in FrameOfShares.
ZoneView zone_view(const FrameMetadata& geometry, const ZoneShares& shares,
                   const std::vector<int>& order, int count, ZoneAxis axis, int threads);

/// Degrees from the sheet's axis.
double angle_of(const ZoneView& view, double place);

/// The report for people. `names`: of the pictures.
std::string zone_view_text(const ZoneView& view, const std::vector<std::string>& names);

/// The same as JSON, of objects `zone`, `pictures` and `eyes`.
std::string zone_view_json(const ZoneView& view, const std::vector<std::string>& names);

/// An HTML page: who sees what at which angle, with a plot of the shares, and what an eye in the
/// middle of each share sees of the frame.
std::string zone_view_page(const ZoneView& view, const std::vector<std::string>& names,
                           const Frame& frame, int threads);

} // namespace integral

#endif
