// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/pixel_run.h"

namespace integral {

void map_pixel_run(const IntegralCamera& camera, Vec2 centre, PixelRun& run)
{
    RayRun<Vec2> film_points;
    for (int k = 0; k < run_length; ++k)
        film_points[k] = film_from_pixel(camera.film, {centre.x + k, centre.y});
    camera.optics.map_run(run_length, film_points, camera.mapping, run.mapped);
    for (int k = 0; k < run_length; ++k)
        if (run.mapped[k].ray)
            run.lines[k] = sight_line(camera, pole_beam(*run.mapped[k].ray));
}

} // namespace integral
