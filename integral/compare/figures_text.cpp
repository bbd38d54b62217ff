// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/figures_text.h"

#include "integral/lightfield/names.h"

#include <cstdio>

namespace integral {

std::string figures_text(const Comparison& c)
{
    char text[400];
    std::snprintf(text, sizeof text,
                  "RMSE                %.6f\n"
                  "PSNR                %.3f dB\n"
                  "SSIM                %.6f\n"
                  "largest difference  %.6f\n"
                  "within 2/255        %.4f%% of the pixels\n"
                  "encoding            %s\n",
                  c.rmse, c.psnr, c.ssim, c.largest_difference, 100 * c.within_two,
                  name_of(c.encoding.kind));
    std::string result = text;
    if (c.worst) {
        std::snprintf(
            text, sizeof text, "worst micro-image   lens %lld,%lld at %.3f,%.3f mm: RMSE %.6f\n",
            static_cast<long long>(c.worst->lens.i), static_cast<long long>(c.worst->lens.j),
            c.worst->pole.x, c.worst->pole.y, c.worst->rmse);
        result += text;
    }
    return result;
}

} // namespace integral
