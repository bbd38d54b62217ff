// SPDX-License-Identifier: AGPL-3.0-or-later
// Camera rays that integral/optics alone makes in a second, on one core: pixel to a ray of the
// scene, for each arrangement and mapping, beside a perspective camera's in the same run.
#include "integral/optics/camera.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>

using namespace integral;

namespace {

constexpr int width = 2400, height = 800;

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// Best of three runs, in CPU seconds; `sum` keeps the work from being optimised away.
double seconds_of(const std::function<double()>& work)
{
    double best = 1e9;
    for (int run = 0; run < 3; ++run) {
        const double start = cpu_seconds();
        volatile double sum = work();
        (void)sum;
        best = std::min(best, cpu_seconds() - start);
    }
    return best;
}

/// location + direction + x right + y up, of unit length: POV-Ray's perspective camera.
double perspective(const ViewFrame& view)
{
    double sum = 0;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const double x = (i + 0.5) / width - 0.5, y = 0.5 - (j + 0.5) / height;
            const Vec3 ray = view.direction + x * view.right + y * view.up;
            sum += ((1 / length(ray)) * ray).x;
        }
    return sum;
}

double integral_rays(const IntegralCamera& camera, long& traced)
{
    double sum = 0;
    traced = 0;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const MappedPoint mapped = camera.optics.map(film_from_pixel(camera.film, {i + 0.5, j + 0.5}), camera.mapping);
            if (!mapped.ray)
                continue;
            const SightLine line = sight_line(camera, *mapped.ray);
            sum += line.direction.x + line.origin.x;
            ++traced;
        }
    return sum;
}

} // namespace

int main()
{
    const ViewFrame view{{0, 2, -10}, {0, 0, 2.5}, {1.5, 0, 0}, {0, 0.5, 0}, 4};
    const double pixels = double(width) * height;
    const double base = seconds_of([&] { return perspective(view); });
    std::printf("camera rays alone, one core, %d x %d pixels\n\n", width, height);
    std::printf("%-12s %-9s %14s %14s %10s\n", "sheet", "mapping", "Mpixels/s", "traced", "to persp.");
    std::printf("%-12s %-9s %14.1f %13.1f%% %10.2f\n", "perspective", "", pixels / base / 1e6, 100.0, 1.0);

    const char* sheets[] = {"lenticular", "square", "hexagonal"};
    const LensMapping mappings[] = {LensMapping::closest, LensMapping::automatic, LensMapping::accurate};
    const char* names[] = {"closest", "auto", "accurate"};
    CameraParameters parameters;
    for (int a = 0; a < 3; ++a)
        for (int slanted = 0; slanted < 2; ++slanted)
            for (int m = 0; m < 3; ++m) {
                parameters.sheet = {Arrangement(a), a ? 1.124 : 1.27, a ? 3.23 : 3.08, a ? 1.675 : 1.6, slanted ? 9.46 : 0.0, {0, 0}};
                parameters.mapping = mappings[m];
                const IntegralCamera camera = make_camera(parameters, view, width, height);
                long traced = 0;
                const double seconds = seconds_of([&] { return integral_rays(camera, traced); });
                std::printf("%-12s %-9s %14.1f %13.1f%% %10.2f\n", (std::string(sheets[a]) + (slanted ? " /" : "")).c_str(),
                            names[m], pixels / seconds / 1e6, 100.0 * traced / pixels, seconds / base);
            }
}
