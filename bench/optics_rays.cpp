// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures how many camera rays integral/optics makes in a second, without tracing, on one core,
// for every arrangement and mapping, and compares with the rays of a perspective camera in the same
// run. The frame is a sheet of 300 x 200 mm at 300 dpi, seen from 300 mm through the aperture that
// fills the lenses. Only every seventh row is mapped.
//
// optics_rays                     prints the table
// optics_rays SHEET MAPPING       makes one pass, for a profiler; e.g. optics_rays square accurate
#include "integral/optics/pixel_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>

using namespace integral;

namespace {

constexpr int width = 3543, height = 2362, row_step = 7, rows = (height + row_step - 1) / row_step,
              rounds = 7;
constexpr double pixel_pitch = mm_per_inch / 300, points = double(width) * rows;

const char* const sheet_names[] = {"lenticular", "square", "hexagonal"};
const LensMapping mappings[] = {LensMapping::closest, LensMapping::automatic, LensMapping::accurate,
                                LensMapping::exhaustive};
const char* const mapping_names[] = {"closest", "auto", "accurate", "exhaustive"};
constexpr int mapping_count = 4;

const ViewFrame view{
    {0, 2, -300}, {0, 0, 300}, {width * pixel_pitch, 0, 0}, {0, height* pixel_pitch, 0}, 1};

IntegralCamera camera_of(int arrangement, double slant, LensMapping mapping)
{
    CameraParameters parameters;
    const bool lenticular = Arrangement(arrangement) == Arrangement::lenticular;
    parameters.sheet = {Arrangement(arrangement),
                        lenticular ? 1.27 : 1.124,
                        lenticular ? 3.08 : 3.23,
                        lenticular ? 1.6 : 1.675,
                        slant,
                        {0, 0}};
    parameters.mapping = mapping;
    return make_camera(parameters, view, width, height);
}

/// Seconds of a pass over the sheet, and the number of points that have a ray. `sum` keeps the
/// compiler from removing the work.
struct Pass {
    double seconds, sum;
    long traced;
};

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// location + direction + x right + y up, of unit length: POV-Ray's perspective camera.
Pass perspective()
{
    Pass pass{-cpu_seconds(), 0, 0};
    for (int j = 0; j < height; j += row_step)
        for (int i = 0; i < width; ++i) {
            const double x = (i + 0.5) / width - 0.5, y = 0.5 - (j + 0.5) / height;
            const Vec3 ray = view.direction + x * view.right + y * view.up;
            pass.sum += ((1 / length(ray)) * ray).x;
            ++pass.traced;
        }
    pass.seconds += cpu_seconds();
    return pass;
}

Pass integral_rays(const IntegralCamera& camera)
{
    Pass pass{-cpu_seconds(), 0, 0};
    for (int j = 0; j < height; j += row_step)
        for (int i = 0; i < width; ++i) {
            const MappedPoint mapped = camera.optics.map(
                film_from_pixel(camera.film, {i + 0.5, j + 0.5}), camera.mapping);
            if (!mapped.ray)
                continue;
            const SightLine line = sight_line(camera, pole_beam(*mapped.ray));
            pass.sum += line.direction.x + line.origin.x;
            ++pass.traced;
        }
    pass.seconds += cpu_seconds();
    return pass;
}

/// Does the same with runs of pixels, which map several pixels at once where possible.
Pass rays_in_runs(const IntegralCamera& camera)
{
    Pass pass{-cpu_seconds(), 0, 0};
    PixelRun run;
    for (int j = 0; j < height; j += row_step)
        for (int i = 0; i < width; ++i) {
            const int k = i % run_length;
            if (k == 0)
                map_pixel_run(camera, {i + 0.5, j + 0.5}, run);
            if (!run.mapped[k].ray)
                continue;
            pass.sum += run.lines[k].direction.x + run.lines[k].origin.x;
            ++pass.traced;
        }
    pass.seconds += cpu_seconds();
    return pass;
}

/// Maps points by the mapping's definition, which tries every lens of the sheet. It is slow, so
/// only some of the points are mapped. `unlike_accurate`: number of points that get another lens
/// than by the mapping `accurate`.
Pass every_lens(const IntegralCamera& camera, long& unlike_accurate)
{
    constexpr int step = 173;
    const SheetOptics& optics = camera.optics;
    const bool lenticular = optics.sheet().arrangement == Arrangement::lenticular;
    const double radius = 0.5 * std::hypot(width * pixel_pitch, height * pixel_pitch) +
                          optics.sheet().pitch;
    Pass pass{-cpu_seconds(), 0, 0};
    unlike_accurate = 0;
    long asked = 0;
    for (int j = 0; j < height; j += step)
        for (int i = 0; i < width; i += step) {
            const Vec2 film_point = film_from_pixel(camera.film, {i + 0.5, j + 0.5});
            std::optional<LensRay> best;
            double least = 0;
            optics.lattice().for_each_within({0, 0}, radius, [&](LensIndex lens) {
                auto ray = optics.ray_through(film_point, lens);
                if (!ray)
                    return;
                const Vec2 at = lenticular ? Vec2{ray->aperture_point.x, 0} : ray->aperture_point;
                if (contains(optics.aperture(), at) && (!best || length(at) < least)) {
                    least = length(at);
                    best = ray;
                }
            });
            ++asked;
            pass.traced += best.has_value();
            const auto accurate = optics.map(film_point, LensMapping::accurate).ray;
            unlike_accurate += best.has_value() != accurate.has_value() ||
                               (best && best->lens != accurate->lens);
        }
    pass.seconds += cpu_seconds();
    pass.seconds *= points / asked; // extrapolated to all points
    return pass;
}

/// Keeps the faster of two passes.
void keep(Pass& best, const Pass& pass)
{
    if (pass.seconds < best.seconds)
        best = pass;
}

/// Prints a line of the table: a pass, compared with the perspective camera and with `closest`.
void print_pass(int arrangement, double slant, const char* mapping, const Pass& pass,
                const Pass& straight, const Pass& closest)
{
    const double per_point = pass.seconds / closest.seconds;
    std::printf("%-10s%6.2f  %-16s %9.2f %8.1f%% %9.2f %11.3f %11.3f\n", sheet_names[arrangement],
                slant, mapping, points / pass.seconds / 1e6, 100 * pass.traced / points,
                pass.seconds / straight.seconds, per_point,
                per_point * closest.traced / pass.traced);
}

void print_sheet(int arrangement, double slant)
{
    Pass best[mapping_count], in_runs[2], straight = perspective();
    const bool runs = Arrangement(arrangement) != Arrangement::hexagonal;
    const auto pass_of = [&](int m) {
        return integral_rays(camera_of(arrangement, slant, mappings[m]));
    };
    const auto run_of = [&](int m) {
        return rays_in_runs(camera_of(arrangement, slant, mappings[m]));
    };
    for (int m = 0; m < mapping_count; ++m)
        best[m] = pass_of(m);
    for (int m = 0; m < 2 && runs; ++m)
        in_runs[m] = run_of(m);
    for (int round = 1; round < rounds; ++round) {
        keep(straight, perspective());
        for (int m = 0; m + 1 < mapping_count; ++m) // all but the last, exhaustive, which is slow
            keep(best[m], pass_of(m));
        for (int m = 0; m < 2 && runs; ++m)
            keep(in_runs[m], run_of(m));
    }
    for (int m = 0; m < mapping_count; ++m) {
        print_pass(arrangement, slant, mapping_names[m], best[m], straight, best[0]);
        if (m < 2 && runs)
            print_pass(arrangement, slant, m == 0 ? "closest, in runs" : "auto, in runs",
                       in_runs[m], straight, best[0]);
    }
    long unlike = 0;
    const Pass all = every_lens(camera_of(arrangement, slant, LensMapping::accurate), unlike);
    std::printf("%-16s  exhaustive / accurate %.1f; every lens of the sheet / accurate %.0f (%ld "
                "points get another lens)\n",
                "", best[3].seconds / best[2].seconds, all.seconds / best[2].seconds, unlike);
}

int index_of(const char* word, const char* const* names, int count)
{
    for (int k = 0; k < count; ++k)
        if (!std::strcmp(word, names[k]))
            return k;
    return -1;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc > 1) {
        const int arrangement = index_of(argv[1], sheet_names, 3);
        const int mapping = argc > 2 ? index_of(argv[2], mapping_names, mapping_count) : -1;
        if (arrangement < 0 || mapping < 0) {
            std::fprintf(
                stderr,
                "optics_rays [lenticular|square|hexagonal closest|auto|accurate|exhaustive]\n");
            return 2;
        }
        const Pass pass = integral_rays(camera_of(arrangement, 0, mappings[mapping]));
        std::printf("%.0f points, %ld rays, sum %.17g\n", points, pass.traced, pass.sum);
        return 0;
    }
    std::printf("camera rays alone, one core, %d x %d pixels, every %dth row\n\n", width, height,
                row_step);
    std::printf("%-10s%6s  %-16s %9s %9s %9s %11s %11s\n", "", "", "", "", "", "cost to",
                "to closest:", "");
    std::printf("%-10s%6s  %-16s %9s %9s %9s %11s %11s\n", "sheet", "slant", "mapping", "Mpoint/s",
                "traced", "persp.", "a point", "a ray");
    for (int arrangement = 0; arrangement < 3; ++arrangement)
        for (const double slant : {0.0, 9.46})
            print_sheet(arrangement, slant);
}
