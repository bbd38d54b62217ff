// SPDX-License-Identifier: AGPL-3.0-or-later
// Smooths weighted values within surfaces, by means or by planes. The colours of a picture show the
// surfaces' edges.
#ifndef INTEGRAL_DEPTH_PLANE_FILTER_H
#define INTEGRAL_DEPTH_PLANE_FILTER_H

#include "integral/depth/view_set.h"

namespace integral {

/// The distance over which a value has weight.
struct Reach {
    double pixels = 40;        ///< in an area of one colour; > 0
    double even_colour = 0.05; ///< sum of differences in R, G and B that divides a weight by e; > 0
    double slow_change = 0;    ///< differences between neighbouring pixels up to this are no edge
};

/// The recursive domain transform of Gastal and Oliveira (2011), guided by a set's middle view.
class PlaneFilter {
public:
    /// `threads` as in for_each_row.
    PlaneFilter(const ViewSet& views, const Reach& reach, int threads);

    /// For each pixel: the smoothed value (NaN if none has weight) and the mean weight around it.
    struct Fit {
        std::vector<float> value, weight;
    };
    /// Weighted means of the values around each pixel. Values whose weight is 0 may be anything.
    Fit means(const std::vector<float>& value, const std::vector<float>& weight) const;
    /// Planes fitted to the values by weighted least squares. A plane is less steep, the farther
    /// its pixel is from the values that have weight.
    Fit planes(const std::vector<float>& value, const std::vector<float>& weight) const;

private:
    using Plane = std::vector<float>;
    void smooth(std::vector<Plane>& planes) const;
    void smooth_row(std::vector<Plane>& planes, int y, float slope, Plane& carried) const;
    void smooth_columns(std::vector<Plane>& planes, int first, int count,
                        const Plane& carried) const;

    int width_, height_, threads_;
    double reach_;
    Plane across_, down_; ///< distances from a pixel to the next on the right, or below
};

} // namespace integral

#endif
