// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes a frame in which each of several pictures has a share of the viewing zone: a flip, motion
// or morph.
#ifndef INTEGRAL_REPLAY_FRAME_OF_SHARES_H
#define INTEGRAL_REPLAY_FRAME_OF_SHARES_H

#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"
#include "integral/lightfield/picture_fit.h"
#include "integral/lightfield/zone_shares.h"

#include <memory>
#include <vector>

namespace integral {

/// A picture that has a share of the zone.
struct SharedPicture {
    Image image;
    FittedPicture fit;     ///< on the film, of a flat picture
    bool is_frame = false; ///< it is a frame of the same sheet and film, whose depth stays
};

/// Across which way the zone is divided.
enum class ZoneAxis { sideways, upwards };

/// Sideways, or upwards for lenses that lie across.
ZoneAxis zone_axis(const LensSheet& sheet);

/// The picture as floats of linear light, made smaller where it has more than two pixels a lens
/// across the lenses, or more than one a film pixel along them, by the mean of what each new pixel
/// covers. So it does not alias behind lenses that show one colour each. `threads`: 0: one per core.
Image for_lenses(const Image& picture, const FittedPicture& fit, const FrameMetadata& geometry,
                 int threads);

/// Makes the frame some rows at a time. A film pixel, or each of its subpixels, belongs to the
/// picture of the eye that its ray meets, seen at the point where the ray leaves the sheet. A pixel
/// of a frame goes over unchanged where no other picture has a part in it. Pixels that image nothing
/// are black (transparent).
class FrameOfShares {
public:
    /// `order`: a picture's index for each share of the zone, from left to right (or from below
    /// upwards). The pictures must outlive this. Throws std::invalid_argument where a frame has
    /// another size than the film.
    FrameOfShares(const std::vector<SharedPicture>& pictures, const std::vector<int>& order,
                  const FrameMetadata& geometry, const ZoneShares& shares, ZoneAxis axis);
    ~FrameOfShares();

    /// As FrameOfViews::draw.
    bool draw(int first, Image& band, int threads, const Progress& progress) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace integral

#endif
