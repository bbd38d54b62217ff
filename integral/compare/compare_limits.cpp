// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/compare_limits.h"

#include "integral/base/number_text.h"
#include "integral/compare/figures_text.h"

#include <algorithm>
#include <cmath>

namespace integral {

const std::array<LimitKind, limit_count> limit_kinds = {{
    {"max_rmse", "RMSE", true, 0, 1e6, "R", "fail (exit status 1) if the RMSE is greater than R"},
    {"min_psnr", "PSNR", false, -1e6, 1e6, "P", "fail if the PSNR is less than P dB"},
    {"min_ssim", "SSIM", false, -1, 1, "S", "fail if the SSIM is less than S"},
    {"max_difference", "largest difference", true, 0, 1e6, "D",
     "fail if a channel of a pixel differs by more than D"},
    {"max_micro_image_rmse", "the worst micro-image's RMSE", true, 0, 1e6, "R",
     "fail if the RMSE of a frame's worst micro-image is greater than R"},
}};

std::optional<double> figure_of(const Comparison& comparison, std::size_t kind)
{
    if (std::isnan(comparison.rmse))
        return std::nullopt;
    switch (kind) {
    case 0: return comparison.rmse;
    case 1: return comparison.psnr;
    case 2: return comparison.ssim;
    case 3: return comparison.largest_difference;
    default: return comparison.worst ? std::optional<double>(comparison.worst->rmse) : std::nullopt;
    }
}

bool keeps(double figure, std::size_t kind, double limit)
{
    return limit_kinds[kind].is_most ? figure <= limit : figure >= limit;
}

std::vector<std::string> missed_limits(const Limits& limits, const Comparison& comparison)
{
    std::vector<std::string> missed;
    for (std::size_t kind = 0; kind < limit_count; ++kind) {
        const auto figure = figure_of(comparison, kind);
        if (figure && limits[kind] && !keeps(*figure, kind, *limits[kind]))
            missed.push_back(limit_kinds[kind].name + (" " + with_digits(*figure, 6)) +
                             (limit_kinds[kind].is_most ? " is greater than " : " is less than ") +
                             with_digits(*limits[kind], 6));
    }
    if (comparison.not_finite.unequal > 0 &&
        std::any_of(limits.begin(), limits.end(), [](const auto& limit) { return bool(limit); }))
        missed.push_back(unequal_text(comparison.not_finite));
    return missed;
}

} // namespace integral
