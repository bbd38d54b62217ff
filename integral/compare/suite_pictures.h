// SPDX-License-Identifier: AGPL-3.0-or-later
// The pictures of one pair of a suite in its report.
#ifndef INTEGRAL_COMPARE_SUITE_PICTURES_H
#define INTEGRAL_COMPARE_SUITE_PICTURES_H

#include "integral/compare/suite_pair.h"
#include "integral/lightfield/frame.h"

namespace integral {

/// HTML: reference, result and difference side by side, scaled down and embedded; of a pair that
/// failed also the worst micro-image of each (without geometry, the surroundings of the pixel that
/// differs most), magnified. Where there is nothing to compare they are smaller. `gain` multiplies
/// the difference; 0: so that what differs is seen, eight times the RMSE or the largest difference
/// at full scale. Either picture may be missing.
std::string suite_pictures(const SuitePair& pair, const std::optional<Frame>& reference,
                           const std::optional<Frame>& result, double gain);

/// The CSS that they need.
extern const char suite_pictures_style[];

} // namespace integral

#endif
