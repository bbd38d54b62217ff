// SPDX-License-Identifier: AGPL-3.0-or-later
// The pictures of one pair of a suite in its report.
#ifndef INTEGRAL_COMPARE_SUITE_PICTURES_H
#define INTEGRAL_COMPARE_SUITE_PICTURES_H

#include "integral/compare/suite_pair.h"
#include "integral/lightfield/frame.h"

namespace integral {

/// What a comparison leaves for the pictures; empty where it has none.
struct PairDetails {
    std::shared_ptr<const PixelWeights> weights;
    std::optional<Image> flip_map; ///< in colours
};

/// HTML that shows reference, result and difference side by side, scaled down and embedded; smaller
/// where there is nothing to compare. A pair that failed is also shown magnified at its worst
/// micro-image, or without geometry around the pixel that differs most. `gain` multiplies the
/// difference, which is black where pixels are ignored; 0 brings eight times the RMSE, or the
/// largest difference if that is less, to full scale. Either picture may be missing.
std::string suite_pictures(const SuitePair& pair, const std::optional<Frame>& reference,
                           const std::optional<Frame>& result, double gain,
                           const PairDetails& details);

/// Reference, result and difference (brought to full scale) side by side, small; of what the worst
/// eye sees if that was compared. Empty where there is neither file.
std::optional<Image> suite_thumbnail(const SuitePair& pair, const std::optional<Frame>& reference,
                                     const std::optional<Frame>& result,
                                     const PairDetails& details);

/// The CSS that this HTML needs.
extern const char suite_pictures_style[];

} // namespace integral

#endif
