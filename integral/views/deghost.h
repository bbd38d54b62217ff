// SPDX-License-Identifier: AGPL-3.0-or-later
// Subtracts the ghosts that neighbouring film pixels leave in what an eye sees behind a lens.
#ifndef INTEGRAL_VIEWS_DEGHOST_H
#define INTEGRAL_VIEWS_DEGHOST_H

#include "integral/views/frame_of_shares.h"

namespace integral {

/// Changes a frame's light, linear floats, so that an eye sees less of pixels beside those that it
/// should see. Pupil, printed dots and the lenses' blur (set_as_seen) mix neighbouring pixels along
/// the zone's axis with known weights. The new light is the one from 0 to 1 that these weights mix,
/// as nearly as possible (least squares, by projected Landweber iteration), to the old light with
/// less contrast: 0 becomes contrast / 2, and 1 becomes 1 - contrast / 2. Without this loss there
/// would be nothing to subtract from where the light is 0. Places at the border of two pictures,
/// which no eye sees alone, hardly count.
class Deghosting {
public:
    /// `contrast`: the fraction that is lost, 0 to 1.
    Deghosting(const FrameMetadata& geometry, double contrast, ZoneAxis axis);

    /// Number of rows above and below that a row's light depends on.
    int reach() const { return axis_ == ZoneAxis::upwards ? reach_ : 0; }

    void apply(Image& light, int threads) const;

    /// The light that an eye should see in place of `light`.
    double with_less_contrast(double light) const
    {
        return 0.5 * contrast_ + (1 - contrast_) * light;
    }

private:
    std::vector<float> weights_; ///< of a pixel and its neighbours on one side, the nearest first
    double contrast_;
    ZoneAxis axis_;
    int reach_; ///< pixels

    /// A line of light, which becomes the new light, and memory for its computing.
    struct Work {
        std::vector<float> line, wanted, counts, mixed, errors;
    };
    void apply(Work& work) const;
    void mix(const std::vector<float>& line, std::vector<float>& mixed) const;
};

} // namespace integral

#endif
