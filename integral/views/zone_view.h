// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes where eyes in the viewing zone see one of several pictures alone, and the share of the
// other pictures in its light.
#ifndef INTEGRAL_VIEWS_ZONE_VIEW_H
#define INTEGRAL_VIEWS_ZONE_VIEW_H

#include "integral/views/frame_of_shares.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

constexpr int eyes_across_zone = 41;

/// A part of the zone, mm from its middle: to the right, or upwards.
struct ZonePart {
    double from = 0, to = 0;
};

/// One share of the zone, with its picture.
struct ShareView {
    int picture = 0;               ///< index
    ZonePart part;                 ///< between the middles of the transitions
    std::optional<ZonePart> alone; ///< where at most 3% of the light is other pictures'
};

/// The shares of the pictures in the light that reaches an eye at the viewing distance.
struct EyeShares {
    double place = 0;           ///< mm from the zone's middle
    std::optional<int> picture; ///< the picture expected there alone; nothing: a transition
    std::vector<double> shares; ///< by the picture's index; their sum is 1
};

/// The figures of a division of the zone.
struct ZoneView {
    ZoneAxis axis = ZoneAxis::sideways;
    double distance = 0; ///< mm from the sheet
    double width = 0;    ///< of the zone, mm
    double blur = 0;     ///< mm on either side of a border in which the sheet mixes more than 3% of
                         ///< one neighbour into the other, besides the requested transition
    std::vector<ShareView> parts;
    std::vector<EyeShares> eyes; ///< eyes_across_zone of them, at the centres of equal parts
    double greatest_other = 0;   ///< greatest share of other pictures where one is expected alone
    double lost_contrast = 0;    ///< of Deghosting; 0: none
    double other_with_ghosts = 0; ///< greatest_other without Deghosting
};

/// Width of a flip's ghost at the viewing distance: the distance from a change, mm in the zone, up
/// to which the sheet mixes more than 3% of one picture into the other, by pupil, printed dots and
/// the lenses' blur (set_as_seen). Along zone_axis; empty for a frame behind a projection lens.
std::optional<double> ghost_in_zone(const FrameMetadata& geometry);

/// Computes the figures by replay, with pupil, printed dots and the lenses' blur (set_as_seen), on
/// a narrow strip of the sheet. `count`: the number of pictures; `order` as in FrameOfShares.
/// `contrast`: of the frame's Deghosting; 0: none.
ZoneView zone_view(const FrameMetadata& geometry, const ZoneShares& shares,
                   const std::vector<int>& order, int count, ZoneAxis axis, double contrast,
                   int threads);

/// Degrees from the sheet's axis.
double angle_of(const ZoneView& view, double place);

/// The report for people. `names`: of the pictures.
std::string zone_view_text(const ZoneView& view, const std::vector<std::string>& names);

/// The same as JSON, of objects `zone`, `pictures` and `eyes`.
std::string zone_view_json(const ZoneView& view, const std::vector<std::string>& names);

/// An HTML page: the picture that is seen at each angle, a plot of the shares, and the frame as
/// seen by an eye in the middle of each share.
std::string zone_view_page(const ZoneView& view, const std::vector<std::string>& names,
                           const Frame& frame, int threads);

} // namespace integral

#endif
