// SPDX-License-Identifier: AGPL-3.0-or-later
// depth_ghosts FRAME DEPTHS.exr PLOT.png: what method A of integral depth (thesis 5.4.3) sees, as
// the thesis's figure 5-8 draws it. In the frame's middle row of pixels, all places where rays of
// pixels behind different lenses meet that have nearly the same colour, and the surfaces that are
// there in truth. The plot is a section through the scene, seen from above.
#include "bench/program.h"
#include "integral/io/image_file.h"
#include "integral/io/plot.h"
#include "integral/optics/lens_mapping.h"

#include <cmath>
#include <random>

namespace {

using namespace integral;

constexpr double like = 0.04;      // as RayTraceSettings::colour
constexpr double depth_shown = 70; // mm from the sheet, to both sides
constexpr std::size_t dots = 3000; // of all meetings, a random part

struct PixelRay {
    double x, slope, depth; ///< mm at the sheet, mm a mm of depth, depth of the surface met
    std::int64_t lens;
    Colour colour;
    bool is_like(const PixelRay& other) const
    {
        const double r = colour.r - other.colour.r, g = colour.g - other.colour.g,
                     b = colour.b - other.colour.b;
        return r * r + g * g + b * b < like * like;
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

int draw(const std::string& frame_file, const std::string& depth_file, const std::string& plot_file)
{
    const Frame frame = read_frame_with_metadata(frame_file);
    const int y = frame.image.height / 2;
    const std::vector<PixelRay> rays = rays_of_row(frame, read_depths(depth_file), y);
    PlotSeries meetings, surfaces;
    for (std::size_t a = 0; a < rays.size(); ++a) {
        surfaces.x.push_back(rays[a].x + rays[a].depth * rays[a].slope);
        surfaces.y.push_back(-rays[a].depth);
        for (std::size_t b = a + 1; b < rays.size(); ++b) {
            const double z = (rays[b].x - rays[a].x) / (rays[a].slope - rays[b].slope);
            if (rays[a].lens != rays[b].lens && std::fabs(z) < depth_shown &&
                rays[a].is_like(rays[b])) {
                meetings.x.push_back(rays[a].x + z * rays[a].slope);
                meetings.y.push_back(-z);
            }
        }
    }
    std::printf("%zu rays, %zu meetings\n", rays.size(), meetings.x.size());
    std::mt19937 random(1);
    for (std::size_t k = 0; k < std::min(dots, meetings.x.size()); ++k) {
        const std::size_t other = k + random() % (meetings.x.size() - k);
        std::swap(meetings.x[k], meetings.x[other]);
        std::swap(meetings.y[k], meetings.y[other]);
    }
    meetings.x.resize(std::min(dots, meetings.x.size()));
    meetings.y.resize(meetings.x.size());
    meetings.label = "where rays of like colours meet";
    surfaces.label = "surfaces";
    meetings.style = surfaces.style = PlotSeries::Style::points;
    meetings.colour = 6;
    surfaces.colour = 1;
    Plot plot;
    plot.title = "Ghost points of reversed rays";
    plot.x.label = "across the sheet (mm)";
    plot.y = {"in front of the sheet (mm)", false, -depth_shown, depth_shown};
    plot.series = {meetings, surfaces};
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
