// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/figures_text.h"

#include "integral/base/number_text.h"
#include "integral/compare/seen.h"
#include "integral/frame/names.h"

#include <cmath>
#include <cstdio>

namespace integral {

std::string unequal_text(const NotFinitePixels& pixels)
{
    return counted(pixels.unequal, "pixel") + (pixels.unequal == 1 ? " differs" : " differ") +
           " by NaN or infinite values, the first at " + std::to_string(pixels.x) + "," +
           std::to_string(pixels.y);
}

std::string flip_text(const FlipFigures& flip)
{
    const auto& exposures = flip.settings.exposures;
    char text[400];
    std::snprintf(text, sizeof text,
                  "%-20s%.6f, at %.1f pixels per degree%s\n"
                  "FLIP's quartiles    %.6f, %.6f, %.6f (weighted); greatest %.6f at %d,%d\n",
                  exposures ? "HDR-FLIP" : "FLIP", flip.mean, flip.settings.ppd,
                  exposures ? (" and " + counted(exposures->count, "exposure") + " from " +
                               with_decimals(exposures->start, 2) + " to " +
                               with_decimals(exposures->stop, 2) + " stops")
                                  .c_str()
                            : "",
                  flip.quartiles[0], flip.quartiles[1], flip.quartiles[2], flip.greatest, flip.x,
                  flip.y);
    return text;
}

std::string figures_text(const Comparison& c)
{
    char text[400];
    std::string result;
    if (!c.of_pixels)
        return "pixels              not compared, as the sizes differ\n" + seen_text(*c.seen);
    if (std::isnan(c.rmse)) {
        result = "RMSE, PSNR, SSIM    none: no value is a finite number in both pictures\n";
    } else {
        std::snprintf(text, sizeof text,
                      "RMSE                %.6f\n"
                      "PSNR                %.3f dB\n"
                      "SSIM                %.6f\n"
                      "largest difference  %.6f\n",
                      c.rmse, c.psnr, c.ssim, c.largest_difference);
        result = text;
    }
    std::snprintf(text, sizeof text,
                  "within 2/255        %.4f%% of the pixels\n"
                  "encoding            %s\n",
                  100 * c.within_two, name_of(c.encoding.kind));
    result += text;
    if (c.channel_tolerance != default_channel_tolerance)
        result += "differing           " + with_digits(100 * c.differing, 4) +
                  "% of the pixels, by more than " + with_digits(c.channel_tolerance, 4) + "\n";
    if (c.flip)
        result += flip_text(*c.flip);
    if (c.worst) {
        std::snprintf(
            text, sizeof text, "worst micro-image   lens %lld,%lld at %.3f,%.3f mm: RMSE %.6f\n",
            static_cast<long long>(c.worst->lens.i), static_cast<long long>(c.worst->lens.j),
            c.worst->pole.x, c.worst->pole.y, c.worst->rmse);
        result += text;
    }
    if (c.not_finite.equal > 0)
        result += "NaN or infinite     " + counted(c.not_finite.equal, "pixel") +
                  " equal in both pictures\n";
    if (c.not_finite.unequal > 0)
        result += "NaN or infinite     " + unequal_text(c.not_finite) +
                  "; RMSE, PSNR and SSIM leave these values out\n";
    if (c.seen)
        result += seen_text(*c.seen);
    return result;
}

} // namespace integral
