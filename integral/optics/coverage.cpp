// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/coverage.h"

#include <algorithm>

namespace integral {

Coverage coverage(const IntegralCamera& camera, int samples)
{
    // An even sample: every step-th pixel of the film, on a rank-1 lattice so that it does not
    // fall into step with the lenses.
    const Film& film = camera.film;
    const double pixels = double(film.width) * film.height;
    const int count = static_cast<int>(std::min<double>(pixels, std::max(samples, 1)));
    constexpr double golden = 0.61803398874989484820;
    Coverage result;
    for (int k = 0; k < count; ++k) {
        double x, y;
        if (count == pixels) {
            x = k % film.width;
            y = k / film.width;
        } else {
            const double turn = k * golden;
            x = std::floor((turn - std::floor(turn)) * film.width);
            y = std::floor((k + 0.5) / count * film.height);
        }
        const MappedPoint mapped = camera.optics.map(film_from_pixel(film, {x + 0.5, y + 0.5}),
                                                     camera.mapping);
        result.imaged += mapped.ray.has_value();
        result.outside_aperture += mapped.empty == Empty::outside_aperture;
        result.total_reflection += mapped.empty == Empty::total_reflection;
        result.searched += mapped.ray.has_value() && mapped.searched;
    }
    for (double* share :
         {&result.imaged, &result.outside_aperture, &result.total_reflection, &result.searched})
        *share /= count;
    return result;
}

} // namespace integral
