// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/texture.h"

#include <algorithm>
#include <cmath>

namespace integral {

Texture::Texture(const ViewSet& views) : views_(views)
{
    for (const DepthView& view : views.others)
        also_down_ = also_down_ || view.shift.y != 0;
}

double Texture::at(int x, int y, int reach) const
{
    const std::size_t width = std::size_t(views_.width);
    double across = 0, down = 0;
    int count = 0;
    for (int j = std::max(1, y - reach); j <= std::min(views_.height - 2, y + reach); ++j)
        for (int i = std::max(1, x - reach); i <= std::min(views_.width - 2, x + reach);
             ++i, ++count)
            for (const auto& c : views_.colours) {
                const std::size_t at = width * std::size_t(j) + std::size_t(i);
                const double dx = 0.5 * (c[at + 1] - c[at - 1]),
                             dy = 0.5 * (c[at + width] - c[at - width]);
                across += dx * dx;
                down += also_down_ ? dy * dy : 0;
            }
    return count ? std::sqrt(std::max(across, down) / (3 * count)) : 0;
}

} // namespace integral
