// SPDX-License-Identifier: AGPL-3.0-or-later
// Divides the viewing zone among pictures: which of them an eye at a place in it is to see.
#ifndef INTEGRAL_LIGHTFIELD_ZONE_SHARES_H
#define INTEGRAL_LIGHTFIELD_ZONE_SHARES_H

#include <vector>

namespace integral {

/// How pictures follow each other across the zone.
struct ZoneDivision {
    std::vector<double> shares; ///< by place in the order; each > 0, of any sum
    double transition = 0;      ///< 0 to 1: the part of the smaller of two neighbours' shares in
                                ///< which one picture turns evenly into the other
    bool loop = false;          ///< the last picture turns into the first at the zone's edge, too
};

/// A mixture of two pictures, by linear light.
struct PictureMix {
    int first = 0, second = 0; ///< places in the order
    double part = 0;           ///< of the second, 0 to 1
};

/// The pictures' shares of the zone. A place is a part of the zone, 0 at the edge where the order
/// begins and 1 at the other; beyond, it repeats, as the zone does in side lobes.
class ZoneShares {
public:
    /// Throws std::invalid_argument where there is no share, or one that is not > 0.
    explicit ZoneShares(const ZoneDivision& division);

    PictureMix at(double place) const;

    int count() const { return int(borders_.size()) - 1; }
    /// Where share number k begins: the border between k - 1 and k; k from 0 to count().
    double border(int k) const { return borders_[k]; }
    /// Half the width of the transition at that border; 0: a sudden change.
    double half_transition(int k) const { return halves_[k]; }

private:
    std::vector<double> borders_, halves_;
};

} // namespace integral

#endif
