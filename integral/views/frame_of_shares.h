// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes a frame in which each of several pictures has a share of the viewing zone: a flip, motion
// or morph.
#ifndef INTEGRAL_VIEWS_FRAME_OF_SHARES_H
#define INTEGRAL_VIEWS_FRAME_OF_SHARES_H

#include "integral/base/parallel.h"
#include "integral/frame/frame.h"
#include "integral/frame/picture_fit.h"
#include "integral/sheet/zone_shares.h"

#include <memory>
#include <vector>

namespace integral {

/// A picture that has a share of the zone.
struct SharedPicture {
    Image image;
    FittedPicture fit;     ///< of a flat picture on the film
    bool is_frame = false; ///< it is a frame of the same sheet and film, and keeps its depth
};

/// The direction in which the zone is divided.
enum class ZoneAxis { sideways, upwards };

/// Sideways, or upwards for lenses that lie across.
ZoneAxis zone_axis(const LensSheet& sheet);

/// The picture as floats of linear light, reduced to at most two pixels a lens (along lenticular
/// lenses: one a film pixel): each new pixel is the mean of the pixels that it covers. A lens shows
/// an eye a single colour, so finer detail would alias. `threads`: 0: one per core.
Image for_lenses(const Image& picture, const FittedPicture& fit, const FrameMetadata& geometry,
                 int threads);

/// Makes the frame some rows at a time. A film pixel, or each of its subpixels, shows the picture
/// whose share of the zone its ray meets, at the point where the ray leaves the sheet. A pixel that
/// shows only one input frame is copied from it unchanged. Pixels that image nothing are black
/// (transparent).
class FrameOfShares {
public:
    /// `order`: a picture's index for each share of the zone, from left to right (or from below
    /// upwards). The pictures must outlive this. Throws std::invalid_argument where a frame has
    /// another size than the film.
    FrameOfShares(const std::vector<SharedPicture>& pictures, const std::vector<int>& order,
                  const FrameMetadata& geometry, const ZoneShares& shares, ZoneAxis axis);
    ~FrameOfShares();

    /// Draws rows as FrameOfViews::draw does.
    bool draw(int first, Image& band, int threads, const Progress& progress) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace integral

#endif
