// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/sampling_forecast.h"

#include "integral/sampling/pixel_sampler.h"

#include <algorithm>

namespace integral {
namespace {

constexpr int looked_at = 8;      // pixels, spread over one lens
constexpr int whole_samples = 24; // beam samples and pixel samples of the reference

using Rays = std::vector<PixelRay>;

/// Number of independent renders of a pixel to average: more for few rays, whose error varies more,
/// but 1 for a single ray.
int renders(const SamplingForecast& setting)
{
    return setting.rays() == 1 ? 1 : std::clamp(256 / setting.rays(), 6, 64);
}

Rays rays_of(IntegralCamera camera, int beam_samples, int pixel_samples, Vec2 centre,
             std::uint64_t seed)
{
    camera.beam_samples = beam_samples;
    camera.pixel_samples = pixel_samples;
    Rays rays;
    PixelSampler(camera, seed).append_rays(centre, rays);
    return rays;
}

std::vector<Vec2> points_at(const Rays& rays, double depth)
{
    std::vector<Vec2> points;
    for (const PixelRay& r : rays) {
        const double way = (depth - r.ray.point.z) / r.ray.direction.z;
        points.push_back(
            {r.ray.point.x + way * r.ray.direction.x, r.ray.point.y + way * r.ray.direction.y});
    }
    return points;
}

/// Mean covariance over all pairs of a point of `a` and a point of `b`.
double covariance(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double detail)
{
    double sum = 0;
    for (const Vec2 p : a)
        for (const Vec2 q : b)
            sum += std::exp(-2 / detail * length(p - q));
    return 0.25 * sum / (double(a.size()) * b.size());
}

/// Mean covariance over all pairs of points of `a`, including each point with itself.
double own_covariance(const std::vector<Vec2>& a, double detail)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            sum += std::exp(-2 / detail * length(a[i] - a[j]));
    return 0.25 * (a.size() + 2 * sum) / (double(a.size()) * a.size());
}

/// The centres of up to `looked_at` different pixels behind the lens in the middle of the film,
/// evenly distributed across it.
std::vector<Vec2> pixels_behind_a_lens(const IntegralCamera& camera)
{
    const LensSheet& sheet = camera.optics.sheet();
    const Vec2 cell = cell_extent(sheet);
    const Vec2 lens = camera.optics.lattice().pole(camera.optics.lattice().nearest({0, 0}));
    const bool lie_across = lenses_lie_across(sheet);
    std::vector<Vec2> centres;
    for (int i = 0; i < looked_at; ++i) {
        const double part = (i + 0.5) / looked_at - 0.5;
        const Vec2 at = lens + (lie_across ? Vec2{0, part * cell.y} : Vec2{part * cell.x, 0});
        const Vec2 pixel = pixel_from_film(camera.film, at);
        const Vec2 centre{std::floor(pixel.x) + 0.5, std::floor(pixel.y) + 0.5};
        if (centres.empty() || length(centre - centres.back()) > 0.5)
            centres.push_back(centre);
    }
    return centres;
}

} // namespace

std::vector<SamplingForecast> sampling_ladder()
{
    return {{1, 1, {}}, {4, 1, {}}, {1, 4, {}}, {4, 4, {}}, {16, 4, {}}};
}

bool forecast_errors(const IntegralCamera& camera, const std::vector<double>& depths, double detail,
                     std::vector<SamplingForecast>& settings)
{
    struct Sums {
        double square = 0;
        int count = 0;
    };
    std::vector<std::vector<Sums>> sums(settings.size(), std::vector<Sums>(depths.size()));
    for (const Vec2 centre : pixels_behind_a_lens(camera)) {
        const Rays all = rays_of(camera, whole_samples, whole_samples, centre, 0);
        if (all.empty())
            continue;
        std::vector<std::vector<Vec2>> whole;
        std::vector<double> of_whole;
        for (const double depth : depths) {
            whole.push_back(points_at(all, depth));
            of_whole.push_back(own_covariance(whole.back(), detail));
        }
        for (std::size_t i = 0; i < settings.size(); ++i)
            for (int seed = 1; seed <= renders(settings[i]); ++seed) {
                const Rays rays = rays_of(camera, settings[i].beam_samples,
                                          settings[i].pixel_samples, centre, seed);
                if (rays.empty())
                    continue; // between two lenses, all samples may belong to the other lens
                for (std::size_t k = 0; k < depths.size(); ++k) {
                    const auto points = points_at(rays, depths[k]);
                    sums[i][k].square += own_covariance(points, detail) -
                                         2 * covariance(points, whole[k], detail) + of_whole[k];
                    ++sums[i][k].count;
                }
            }
    }
    bool complete = true;
    for (std::size_t i = 0; i < settings.size(); ++i)
        for (const Sums& sum : sums[i]) {
            complete = complete && sum.count > 0;
            settings[i].rms.push_back(
                std::sqrt(std::max(0.0, sum.square / std::max(1, sum.count))));
        }
    if (!complete)
        for (SamplingForecast& setting : settings)
            setting.rms.clear();
    return complete;
}

} // namespace integral
