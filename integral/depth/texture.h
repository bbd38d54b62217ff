// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures the texture around a pixel: without texture no depth can be found.
#ifndef INTEGRAL_DEPTH_TEXTURE_H
#define INTEGRAL_DEPTH_TEXTURE_H

#include "integral/depth/view_set.h"

namespace integral {

class Texture {
public:
    explicit Texture(const ViewSet& views); ///< which must outlive this

    /// How much a shift of a pixel changes the colours of the pixels around one of the middle
    /// view, up to `reach` away: root of the mean square of the change (full scale 1), across or
    /// down, whichever is greater; only across where all views stand in a row.
    double at(int x, int y, int reach = 2) const;

private:
    const ViewSet& views_;
    bool also_down_ = false;
};

} // namespace integral

#endif
