// SPDX-License-Identifier: AGPL-3.0-or-later
// The pictures of one pair of a suite in its report.
#ifndef INTEGRAL_COMPARE_SUITE_PICTURES_H
#define INTEGRAL_COMPARE_SUITE_PICTURES_H

#include "integral/compare/suite_pair.h"
#include "integral/frame/frame.h"

namespace integral {

/// Results of a comparison for its pictures; empty where it has none.
struct PairDetails {
    std::shared_ptr<const PixelWeights> weights;
    std::optional<Image> flip_map; ///< in colours
};

/// HTML that shows reference, result and difference side by side, scaled down and embedded; smaller
/// unless the comparison failed. Equal pictures are shown once. A failed pair is also shown
/// magnified at its worst micro-image, or without geometry around the pixel that differs most.
/// `gain` multiplies the difference, which is black where pixels are ignored; 0: a gain at which
/// full scale is eight times the RMSE or, if less, the largest difference. Either may be missing.
std::string suite_pictures(const SuitePair& pair, const std::optional<Frame>& reference,
                           const std::optional<Frame>& result, double gain,
                           const PairDetails& details);

/// Reference, result and difference (brought to full scale) side by side, small; from the worst
/// eye's views if these were compared. Empty where there is neither file.
std::optional<Image> suite_thumbnail(const SuitePair& pair, const std::optional<Frame>& reference,
                                     const std::optional<Frame>& result,
                                     const PairDetails& details);

/// The CSS that this HTML needs.
extern const char suite_pictures_style[];

} // namespace integral

#endif
