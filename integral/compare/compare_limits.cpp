// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/compare_limits.h"

#include "integral/base/number_text.h"
#include "integral/compare/figures_text.h"
#include "integral/compare/seen.h"

#include <algorithm>
#include <charconv>
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
    {"max_differing", "share of differing pixels", true, 0, 1, "SHARE",
     "fail if more than this share of the pixels differ, as 0.1% or 0.001 (--channel-tolerance)",
     true},
    {"max_flip", "mean FLIP", true, 0, 1, "F", "fail if the mean FLIP is greater than F"},
}};

std::optional<double> figure_of(const Comparison& comparison, std::size_t kind)
{
    if (comparison.seen && kind != micro_image_limit)
        return figure_of(comparison.seen->overall, kind);
    if (std::isnan(comparison.rmse))
        return std::nullopt;
    switch (kind) {
    case 0: return comparison.rmse;
    case 1: return comparison.psnr;
    case 2: return comparison.ssim;
    case 3: return comparison.largest_difference;
    case 4: return comparison.worst ? std::optional<double>(comparison.worst->rmse) : std::nullopt;
    case 5: return comparison.differing;
    default: return comparison.flip ? std::optional<double>(comparison.flip->mean) : std::nullopt;
    }
}

std::optional<double> share_of(const std::string& text)
{
    const bool in_percent = !text.empty() && text.back() == '%';
    const char* const end = text.data() + text.size() - (in_percent ? 1 : 0);
    double value = 0;
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end)
        return std::nullopt;
    return in_percent ? value / 100 : value;
}

std::string limit_text(std::size_t kind, double value, int digits)
{
    return limit_kinds[kind].is_share ? with_digits(100 * value, digits) + "%"
                                      : with_digits(value, digits);
}

bool keeps(double figure, std::size_t kind, double limit)
{
    return limit_kinds[kind].is_most ? figure <= limit : figure >= limit;
}

std::vector<std::string> missed_limits(const Limits& limits, const Comparison& comparison)
{
    std::vector<std::string> missed;
    const std::string as_seen = comparison.seen ? "as seen, " : "";
    for (std::size_t kind = 0; kind < limit_count; ++kind) {
        const auto figure = figure_of(comparison, kind);
        if (figure && limits[kind] && !keeps(*figure, kind, *limits[kind]))
            missed.push_back((kind == micro_image_limit ? "" : as_seen) + limit_kinds[kind].name +
                             (" " + limit_text(kind, *figure, 6)) +
                             (limit_kinds[kind].is_most ? " is greater than " : " is less than ") +
                             limit_text(kind, *limits[kind], 6));
    }
    const NotFinitePixels& not_finite = comparison.seen ? comparison.seen->overall.not_finite
                                                        : comparison.not_finite;
    if (not_finite.unequal > 0 &&
        std::any_of(limits.begin(), limits.end(), [](const auto& limit) { return bool(limit); }))
        missed.push_back(as_seen + unequal_text(not_finite));
    return missed;
}

} // namespace integral
