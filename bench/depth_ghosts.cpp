// SPDX-License-Identifier: AGPL-3.0-or-later
// depth_ghosts FRAME DEPTHS.exr PLOT.png: plots the matches of method A of integral depth (thesis
// 5.4.3), like the thesis's figure 5-8. For the frame's middle row of pixels, it draws places where
// rays of nearly equal colour through different lenses meet, and the true surfaces. The plot is a
// section through the scene, seen from above.
#include "bench/program.h"
#include "integral/depth/ray_trace.h"
#include "integral/io/image_file.h"
#include "integral/io/plot.h"
#include "integral/optics/lens_mapping.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

namespace {

using namespace integral;

constexpr double depth_shown = 70; // mm from the sheet, to both sides
constexpr std::size_t dots = 3000; // number of meetings drawn, chosen at random

struct PixelRay {
    double x, slope, depth; ///< mm at the sheet, mm a mm of depth, depth of the surface met
    std::int64_t lens;
    Colour colour;
    bool is_like(const PixelRay& other) const
    {
        const double r = colour.r - other.colour.r, g = colour.g - other.colour.g,
                     b = colour.b - other.colour.b;
        return std::sqrt(r * r + g * g + b * b) < RayTraceSettings{}.colour;
    }
};

std::vector<PixelRay> rays_of_row(const Frame& frame, const DepthFrame& depths, int y)
{
    const FrameMetadata& geometry = *frame.metadata;
    const SheetOptics optics(geometry.sheet, geometry.aperture);
    std::vector<PixelRay> rays;
    for (int x = 0; x < geometry.film.width; ++x) {
        const Vec2 point = film_from_pixel(geometry.film, {x + 0.5, y + 0.5});
        if (const auto ray = optics.map(point, LensMapping::automatic).ray)
            rays.push_back({ray->pole.x, ray->direction.x / ray->direction.z,
                            depths.depth[std::size_t(y) * geometry.film.width + x], ray->lens.i,
                            stored_pixel(frame.image, x, y)});
    }
    return rays;
}

/// Meeting points of rays of similar colours: mm across, and mm behind the sheet.
std::vector<Vec2> meetings_of(const std::vector<PixelRay>& rays)
{
    std::vector<Vec2> meetings;
    for (auto a = rays.begin(); a != rays.end(); ++a)
        for (auto b = a + 1; b != rays.end(); ++b) {
            const double z = (b->x - a->x) / (a->slope - b->slope);
            if (a->lens != b->lens && std::fabs(z) < depth_shown && a->is_like(*b))
                meetings.push_back({a->x + z * a->slope, z});
        }
    return meetings;
}

PlotSeries dots_at(const std::vector<Vec2>& places, const char* label, int colour)
{
    PlotSeries series;
    series.label = label;
    series.style = PlotSeries::Style::points;
    series.colour = colour;
    for (const Vec2 place : places) {
        series.x.push_back(place.x);
        series.y.push_back(-place.y);
    }
    return series;
}

int draw(const std::string& frame_file, const std::string& depth_file, const std::string& plot_file)
{
    const Frame frame = read_frame_with_metadata(frame_file);
    const std::vector<PixelRay> rays = rays_of_row(frame, read_depths(depth_file),
                                                   frame.image.height / 2);
    std::vector<Vec2> surfaces, shown;
    for (const PixelRay& ray : rays)
        surfaces.push_back({ray.x + ray.depth * ray.slope, ray.depth});
    const std::vector<Vec2> meetings = meetings_of(rays);
    std::printf("%zu rays, %zu meetings\n", rays.size(), meetings.size());
    std::sample(meetings.begin(), meetings.end(), std::back_inserter(shown), dots, std::mt19937(1));
    Plot plot;
    plot.title = "Ghost points of reversed rays";
    plot.x.label = "across the sheet (mm)";
    plot.y = {"in front of the sheet (mm)", false, -depth_shown, depth_shown};
    plot.series = {dots_at(shown, "where rays of like colours meet", 6),
                   dots_at(surfaces, "surfaces", 1)};
    write_plot(plot, plot_file);
    return 0;
}

} // namespace

int main(int count, char** words)
{
    return integral::bench::status_of("depth_ghosts", [&] {
        if (count != 4)
            throw integral::bench::UsageError("FRAME DEPTHS.exr PLOT.png are expected");
        return draw(words[1], words[2], words[3]);
    });
}
