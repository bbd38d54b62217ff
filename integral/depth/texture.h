// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures the texture around a pixel: without texture no depth can be found.
#ifndef INTEGRAL_DEPTH_TEXTURE_H
#define INTEGRAL_DEPTH_TEXTURE_H

#include "integral/depth/view_set.h"

namespace integral {

class Texture {
public:
    explicit Texture(const ViewSet& views); ///< the views must outlive this

    /// Root mean square change (full scale 1) of the colours within `reach` pixels of a pixel of
    /// the middle view when the view is shifted by one pixel: across or down, whichever changes
    /// them more; only across if all views stand in a row.
    double at(int x, int y, int reach = 2) const;

private:
    const ViewSet& views_;
    bool also_down_ = false;
};

} // namespace integral

#endif
