// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures how fast wireframes are drawn: a ring of 33,410 vertices, 100,230 edges and 66,820
// triangles, 84 mm large and 45 mm behind the sheet of a 4 x 6 inch print. Prints seconds of one
// thread, the number of projections (of a vertex through a lens), and the ratio to the seconds that
// the same number of projections take one by one (film_point_imaging). The thesis's method cannot
// take less than these, even if it knew which lenses image what and drew nothing. Each figure is
// the least of several alternating runs.
// usage: wireframe_speed [N [ROUNDS]]: vertices fewer by N^2 (default 1); runs (default 3)
#include "integral/wireframe/wireframe.h"

#include "integral/optics/beam.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace integral;

namespace {

double processor_seconds()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

template <class Work> double seconds_of(const Work& work)
{
    const double start = processor_seconds();
    work();
    return processor_seconds() - start;
}

/// A ring of `around` x `through` vertices whose surface is cut into triangles.
Mesh ring(int around, int through)
{
    Mesh mesh;
    constexpr double turn = 6.28318530717958647692;
    const auto number = [&](int i, int j) {
        return std::uint32_t(i % around * through + j % through);
    };
    const Colour white{1, 1, 1, 1};
    const auto edge = [&](std::uint32_t a, std::uint32_t b) {
        mesh.face_edges.push_back({{a, b}, {white, white}});
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < through; ++j) {
            const double a = turn * i / around, b = turn * j / through, r = 1 + 0.4 * std::cos(b);
            mesh.vertices.push_back({r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)});
            const std::uint32_t v = number(i, j), right = number(i + 1, j), up = number(i, j + 1),
                                both = number(i + 1, j + 1);
            edge(v, right);
            edge(v, up);
            edge(v, both);
            mesh.triangles.push_back({{v, right, both}, white});
            mesh.triangles.push_back({{v, both, up}, white});
        }
    MeshPlace where;
    where.fit = 84;
    where.turn = {55, 20, 0};
    where.move = {0, 0, 45};
    place(mesh, where);
    return mesh;
}

WireframeRequest request_of(const LensSheet& sheet, const Mesh& mesh)
{
    return {mesh, SheetOptics(sheet, *filling_aperture(sheet, 300)),
            Film{1800, 1200, {mm_per_inch / 300, mm_per_inch / 300}}};
}

/// The seconds that `projections` projections take one by one.
double seconds_one_by_one(const WireframeRequest& request, double projections)
{
    const auto& vertices = request.mesh.vertices;
    double sum = 0, done = 0;
    const double seconds = seconds_of([&] {
        for (LensIndex lens{-40, 0}; done < projections / 8; ++lens.i)
            for (const Vec3& v : vertices) {
                if (const auto film = film_point_imaging(request.optics, v, lens))
                    sum += film->x;
                ++done;
            }
    });
    if (sum == 0.123) // so that the compiler cannot leave the work out
        std::puts("");
    return seconds * projections / done;
}

} // namespace

int main(int count, char** words)
{
    const int rounds = count > 2 ? std::max(1, std::atoi(words[2])) : 3;
    const int fewer = count > 1 ? std::max(1, std::atoi(words[1])) : 1;
    const Mesh mesh = ring(257 / fewer, 130 / fewer);
    std::printf("%zu vertices, %zu edges, %zu triangles; 1800 x 1200 pixels, one thread\n\n",
                mesh.vertices.size(), mesh.face_edges.size(), mesh.triangles.size());
    std::printf("%-18s %-7s %8s %15s %12s %6s\n", "sheet", "faces", "seconds", "projections",
                "one by one", "ratio");
    const struct {
        const char* name;
        LensSheet sheet;
    } sheets[] = {{"lenticular 1.27", {}},
                  {"square 1.124", {Arrangement::square, 1.124, 3.23, 1.675, 0, {}}},
                  {"square 1.124, 10", {Arrangement::square, 1.124, 3.23, 1.675, 10, {}}},
                  {"hexagonal 1.124", {Arrangement::hexagonal, 1.124, 3.23, 1.675, 0, {}}}};
    const struct {
        const char* name;
        FaceStyle style;
    } styles[] = {
        {"wire", FaceStyle::wire}, {"hidden", FaceStyle::hidden}, {"flat", FaceStyle::flat}};
    for (const auto& [name, sheet] : sheets)
        for (const auto& [style_name, style] : styles) {
            WireframeRequest request = request_of(sheet, mesh);
            request.faces = style;
            double drawing = 1e300, alone = 1e300;
            WireframeCost cost;
            for (int round = 0; round < rounds; ++round) {
                cost = {};
                drawing = std::min(drawing,
                                   seconds_of([&] { draw_wireframe(request, 8, 1, {}, cost); }));
                alone = std::min(alone, seconds_one_by_one(request, cost.projections));
            }
            std::printf("%-18s %-7s %8.3f %15.0f %12.3f %6.2f\n", name, style_name, drawing,
                        cost.projections, alone, drawing / alone);
        }
}
