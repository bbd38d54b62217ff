// SPDX-License-Identifier: AGPL-3.0-or-later
// Interleaves views behind a lenticular sheet, one view to each subpixel, and measures in replay
// which view an eye sees where.
#ifndef INTEGRAL_MULTIVIEW_VIEW_SWITCHING_H
#define INTEGRAL_MULTIVIEW_VIEW_SWITCHING_H

#include "integral/lightfield/frame.h"
#include "integral/replay/replay.h"

#include <memory>
#include <optional>
#include <vector>

namespace integral {

/// For whom views are interleaved.
enum class Interleaving {
    to_eyes,     ///< eyes at the viewing distance (figure 5-2): the aperture's
    to_infinity, ///< eyes infinitely far away (figure 5-1): every lens has the same views
};

/// Interleaves views for a lenticular sheet.
class Interleaver {
public:
    Interleaver(const FrameMetadata& geometry, Interleaving kind, int threads);
    ~Interleaver();

    /// The frame of these views, from left to right: three channels of 8 or 16 bits, all of one
    /// size and form. A film pixel shows the nearest pixel of one view.
    Frame frame(const std::vector<Image>& views) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// What eyes spread over the viewing zone see of numbered views.
struct ViewSwitching {
    double crosstalk; ///< the part of the sheet that shows another view than the one of the eye's
                      ///< part of the zone: mean over all eyes
    double at_once;   ///< the greatest part that changes its view from an eye to the next
    double step;      ///< mm that an eye moves from view to view, in the zone's middle half
};
ViewSwitching view_switching(const Interleaver& interleaver, const FrameMetadata& geometry,
                             int views, const std::vector<Eye>& eyes, int threads);

/// What an eye at the border of two views sees of a flat field that the even views show white, the
/// odd ones black: the moire of lenses and pixels.
Image moire_picture(const Interleaver& interleaver, const FrameMetadata& geometry, int views,
                    int threads);

/// The period (mm) of that picture's stripes: the strongest one between 2.5 lenses and two thirds
/// of the picture's width. Nothing: it is even.
std::optional<double> stripes_period(const Image& moire, const FrameMetadata& geometry);

} // namespace integral

#endif
