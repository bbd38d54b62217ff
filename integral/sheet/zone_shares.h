// SPDX-License-Identifier: AGPL-3.0-or-later
// Divides the viewing zone among pictures by the eye's place in it.
#ifndef INTEGRAL_SHEET_ZONE_SHARES_H
#define INTEGRAL_SHEET_ZONE_SHARES_H

#include <vector>

namespace integral {

/// Division of the zone among pictures.
struct ZoneDivision {
    std::vector<double> shares; ///< in order across the zone; each > 0, of any sum
    double transition = 0;      ///< 0 to 1: width of the transition between two pictures, as a
                                ///< fraction of the smaller of their shares; linear
    bool loop = false;          ///< the last picture turns into the first at the zone's edge, too
};

/// A mixture of two pictures in linear light.
struct PictureMix {
    int first = 0, second = 0; ///< places in the order
    double part = 0;           ///< weight of the second, 0 to 1
};

/// The pictures' shares of the zone. A place in the zone is 0 at the edge where the order begins
/// and 1 at the other edge; places beyond repeat with period 1, as the zone does in side lobes.
class ZoneShares {
public:
    /// Throws std::invalid_argument if there is no share, or a share is not finite and > 0.
    explicit ZoneShares(const ZoneDivision& division);

    PictureMix at(double place) const;

    int count() const { return int(borders_.size()) - 1; }
    /// The beginning of share k: the border between k - 1 and k; k from 0 to count().
    double border(int k) const { return borders_[k]; }
    /// Half the width of the transition at that border; 0: a sudden change.
    double half_transition(int k) const { return halves_[k]; }

private:
    std::vector<double> borders_, halves_;
};

} // namespace integral

#endif
