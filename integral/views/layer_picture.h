// SPDX-License-Identifier: AGPL-3.0-or-later
// A layer's picture in memory, and its light at any place.
#ifndef INTEGRAL_VIEWS_LAYER_PICTURE_H
#define INTEGRAL_VIEWS_LAYER_PICTURE_H

#include "integral/base/four_floats.h"
#include "integral/frame/image.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace integral {

/// A picture in linear light with alpha; beyond its edges all is transparent.
class LayerPicture {
public:
    /// `picture`: as covered_means makes it. `fade`: width, in pixels across and down, of the strip
    /// in which the picture's edges become transparent, half inside and half outside; 0 < fade
    /// <= 1.
    LayerPicture(Image picture, Vec2 fade) : picture_(std::move(picture)), fade_(fade) {}

    int width() const { return picture_.width; }
    int height() const { return picture_.height; }

    /// The light at a place in pixels from the top left corner, premultiplied, interpolated between
    /// the four pixels around it: red, green, blue and alpha.
    FourFloats at(double x, double y) const
    {
        const double beside = std::min(x, width() - x), above = std::min(y, height() - y);
        const std::size_t row = 4 * std::size_t(width());
        if (beside > 0.5 && above > 0.5) // most places: no edge is near
            return between(x - 0.5, y - 0.5, 4, row);
        const double across = 0.5 * fade_.x, down = 0.5 * fade_.y;
        if (!(beside > -across && above > -down))
            return FourFloats{0, 0, 0, 0};
        const double u = std::clamp(x - 0.5, 0.0, width() - 1.0),
                     v = std::clamp(y - 0.5, 0.0, height() - 1.0);
        FourFloats light = between(u, v, u < width() - 1 ? 4 : 0, v < height() - 1 ? row : 0);
        if (beside < across)
            light *= float((beside + across) / fade_.x);
        if (above < down)
            light *= float((above + down) / fade_.y);
        return light;
    }

private:
    /// The light at a place between pixels' centres: 0 to width - 1 and height - 1. `next`,
    /// `below`: samples to the pixels at the right and below; 0 at the picture's edge.
    FourFloats between(double u, double v, std::size_t next, std::size_t below) const
    {
        const int i = int(u), j = int(v);
        const float right = float(u - i), low = float(v - j);
        const float* upper = std::get<std::vector<float>>(picture_.samples).data() +
                             4 * (std::size_t(j) * std::size_t(width()) + std::size_t(i));
        const FourFloats left = pixel(upper), under = pixel(upper + below);
        const FourFloats first = left + right * (pixel(upper + next) - left),
                         second = under + right * (pixel(upper + below + next) - under);
        return first + low * (second - first);
    }
    static FourFloats pixel(const float* samples)
    {
        FourFloats light;
        std::memcpy(&light, samples, sizeof light);
        return light;
    }

    Image picture_;
    Vec2 fade_;
};

} // namespace integral

#endif
