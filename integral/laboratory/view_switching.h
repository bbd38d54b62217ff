// SPDX-License-Identifier: AGPL-3.0-or-later
// Interleaves views behind a lenticular sheet, one view to each subpixel, and measures in replay
// which view each eye sees.
#ifndef INTEGRAL_LABORATORY_VIEW_SWITCHING_H
#define INTEGRAL_LABORATORY_VIEW_SWITCHING_H

#include "integral/frame/frame.h"
#include "integral/replay/replay.h"

#include <memory>
#include <optional>
#include <vector>

namespace integral {

/// The eyes for which views are interleaved.
enum class Interleaving {
    to_eyes,     ///< eyes at the aperture's distance (figure 5-2)
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

/// Figures of numbered views, as seen by eyes spread over the viewing zone.
struct ViewSwitching {
    double crosstalk; ///< the part of the sheet that shows a view of another part of the zone than
                      ///< the eye's: mean over all eyes
    double at_once;   ///< the greatest part of it that changes its view from an eye to the next
    double step;      ///< mm that an eye moves from view to view, in the zone's middle half
};
ViewSwitching view_switching(const Interleaver& interleaver, const FrameMetadata& geometry,
                             int views, const std::vector<Eye>& eyes, int threads);

/// The moire of lenses and pixels: views that are white (those with even numbers) and black (odd
/// numbers), as seen by an eye at the border of two views.
Image moire_picture(const Interleaver& interleaver, const FrameMetadata& geometry, int views,
                    int threads);

/// The period (mm) of the strongest stripes in that picture, among periods from 2.5 lenses to two
/// thirds of the picture's width. Returns nothing if those stripes are faint.
std::optional<double> stripes_period(const Image& moire, const FrameMetadata& geometry);

} // namespace integral

#endif
