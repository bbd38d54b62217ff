// SPDX-License-Identifier: AGPL-3.0-or-later
// Smooths weighted values within surfaces, whose edges a picture tells by its colours, by means or
// by planes.
#ifndef INTEGRAL_DEPTH_PLANE_FILTER_H
#define INTEGRAL_DEPTH_PLANE_FILTER_H

#include "integral/depth/view_set.h"

namespace integral {

/// How far a value counts.
struct Reach {
    double pixels = 40;        ///< over even colours; > 0
    double even_colour = 0.05; ///< sum of differences in R, G and B over which it counts e times
                               ///< less; > 0
    double slow_change = 0;    ///< the differences of neighbouring pixels up to that are no edge
};

/// The recursive domain transform of Gastal and Oliveira (2011), of a set's middle view.
class PlaneFilter {
public:
    /// `threads` as in for_each_row.
    PlaneFilter(const ViewSet& views, const Reach& reach, int threads);

    /// At each pixel: the value there (NaN where nothing counts), and the mean weight around.
    struct Fit {
        std::vector<float> value, weight;
    };
    /// The weighted means of the values around. Values whose weight is 0 may be anything.
    Fit means(const std::vector<float>& value, const std::vector<float>& weight) const;
    /// Planes through the values, by weighted least squares; the less they slope, the farther a
    /// pixel is from what counts.
    Fit planes(const std::vector<float>& value, const std::vector<float>& weight) const;

private:
    using Plane = std::vector<float>;
    void smooth(std::vector<Plane>& planes) const;
    void smooth_row(std::vector<Plane>& planes, int y, float slope, Plane& carried) const;
    void smooth_columns(std::vector<Plane>& planes, int first, int count,
                        const Plane& carried) const;

    int width_, height_, threads_;
    double reach_;
    Plane across_, down_; ///< from a pixel to the next: its distance
};

} // namespace integral

#endif
