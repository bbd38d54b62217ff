// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/zone_shares.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {

ZoneShares::ZoneShares(const ZoneDivision& division)
{
    const std::vector<double>& shares = division.shares;
    double sum = 0;
    for (const double share : shares) {
        if (!(share > 0) || !std::isfinite(share))
            throw std::invalid_argument("a share of the zone must be greater than 0");
        sum += share;
    }
    if (shares.empty())
        throw std::invalid_argument("there is no picture");
    const std::size_t count = shares.size();
    double end = 0;
    for (std::size_t k = 0; k <= count; ++k) {
        borders_.push_back(k == count ? 1 : end / sum);
        const bool at_edge = k == 0 || k == count;
        const double before = shares[(k + count - 1) % count], after = shares[k % count];
        halves_.push_back(at_edge && (!division.loop || count == 1)
                              ? 0
                              : division.transition / 2 * std::min(before, after) / sum);
        end += after;
    }
}

PictureMix ZoneShares::at(double place) const
{
    place -= std::floor(place);
    const int count = this->count();
    const int k = std::clamp(int(std::upper_bound(borders_.begin(), borders_.end(), place) -
                                 borders_.begin()) -
                                 1,
                             0, count - 1);
    const auto mixture = [&](int border) {
        const int second = border % count;
        return PictureMix{(border + count - 1) % count, second,
                          0.5 + 0.5 * (place - borders_[border]) / halves_[border]};
    };
    if (place - borders_[k] < halves_[k])
        return mixture(k);
    if (borders_[k + 1] - place < halves_[k + 1])
        return mixture(k + 1);
    return {k, k, 0};
}

} // namespace integral
