// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/coverage.h"

#include <algorithm>

namespace integral {

Vec2 spread_pixel(const Film& film, int k, int count)
{
    constexpr double golden = 0.61803398874989484820;
    if (count == double(film.width) * film.height)
        return {k % film.width + 0.5, k / film.width + 0.5};
    const double turn = k * golden;
    return {std::floor((turn - std::floor(turn)) * film.width) + 0.5,
            std::floor((k + 0.5) / count * film.height) + 0.5};
}

Coverage coverage(const IntegralCamera& camera, int samples)
{
    const Film& film = camera.film;
    const double pixels = double(film.width) * film.height;
    const int count = static_cast<int>(std::min<double>(pixels, std::max(samples, 1)));
    Coverage result;
    for (int k = 0; k < count; ++k) {
        const MappedPoint mapped = camera.optics.map(
            film_from_pixel(film, spread_pixel(film, k, count)), camera.mapping);
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
