// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/beam_samples.h"

#include <algorithm>
#include <utility>

namespace integral {

namespace {

constexpr float most_short = 32767;

/// Returns 0 for NaN. Uses comparisons, because fmin and fmax are function calls and this function
/// runs for every sample that is stored.
std::int16_t rounded(float x)
{
    constexpr float most = most_short;
    const float within = x > most ? most : x > -most ? x : x <= -most ? -most : 0;
    return std::int16_t(std::lrint(within));
}

} // namespace

LightFieldRay light_field_ray(const Lattice& lattice, const BeamRay& ray)
{
    const Vec2 slope = (1 / ray.direction.z) * Vec2{ray.direction.x, ray.direction.y};
    const Vec2 point = Vec2{ray.point.x, ray.point.y} - ray.point.z * slope;
    const auto along_axes = [&](Vec2 v) {
        return std::array<float, 2>{float(dot(v, lattice.across())),
                                    float(dot(v, lattice.along()))};
    };
    return {along_axes(point), along_axes(slope)};
}

/// The range of tilts that are stored: up to surfaces edge-on to a ray 1/100 of a pixel from the
/// sample's ray.
static double most_tilt_of(const IntegralCamera& camera)
{
    const LensSheet& sheet = camera.optics.sheet();
    const double pixel = std::max(camera.film.pixel_pitch.x, camera.film.pixel_pitch.y);
    return 100 * sheet.thickness / (sheet.ior * pixel);
}

BeamSamples::BeamSamples(const IntegralCamera& camera, std::shared_ptr<void> memory)
    : BeamSamples(camera.film.width, camera.film.height, most_tilt_of(camera),
                  furthest_depth_of_frames, std::move(memory))
{
}

BeamSamples::BeamSamples(int width, int height, double most_tilt, float furthest_depth,
                         std::shared_ptr<void> memory)
    : width_(width),
      size_(std::ptrdiff_t(width) * height),
      tilt_unit_(float(most_tilt) / most_short),
      furthest_depth_(furthest_depth),
      memory_(memory ? std::move(memory)
                     : zeroed_memory((bytes_of_pixels + bytes_of_lenders) * size_)),
      pixels_(static_cast<Pixel*>(memory_.get())),
      lenders_(reinterpret_cast<std::uint32_t*>(pixels_ + size_))
{
}

BeamSamples::Sample BeamSamples::stored(const Seen& seen) const
{
    Sample sample;
    sample.line = seen.line;
    // fmin turns NaN into the furthest depth.
    sample.depth = std::fmax(-furthest_depth_, std::fmin(float(seen.depth), furthest_depth_));
    for (int k = 0; k < 2; ++k)
        sample.tilt[k] = rounded(seen.tilt[k] / tilt_unit_);
    sample.light = StoredLight(seen.light);
    return sample;
}

void BeamSamples::set_first(int x, int y, const LightFieldRay& centre, LensIndex lens,
                            const Seen& seen)
{
    Pixel& pixel = pixels_[index(x, y)];
    pixel.centre = centre;
    pixel.first = stored(seen);
    pixel.number = 1;
    lenders_[index(x, y)] = StoredLight::holds(seen.light)
                                ? lender_behind(LightFieldImage::stored(lens))
                                : no_lens;
}

void BeamSamples::Gathered::add(const BeamSamples& store, const Seen& seen)
{
    Begun& pixel = pixels_.back();
    pixel.is_reusable = pixel.is_reusable && StoredLight::holds(seen.light);
    if (samples_.size() - pixel.at < std::size_t(most_stored - 1))
        samples_.push_back(store.stored(seen));
}

void BeamSamples::store(int top, Gathered& gathered)
{
    if (!gathered.samples_.empty()) {
        auto samples = std::make_unique<Sample[]>(gathered.samples_.size());
        std::copy(gathered.samples_.begin(), gathered.samples_.end(), samples.get());
        std::size_t end = gathered.samples_.size();
        for (auto begun = gathered.pixels_.rbegin(); begun != gathered.pixels_.rend(); ++begun) {
            Pixel& pixel = pixels_[index(begun->x, begun->y)];
            pixel.more = samples.get() + begun->at;
            pixel.number = std::uint16_t(1 + end - begun->at);
            if (!begun->is_reusable)
                lenders_[index(begun->x, begun->y)] = no_lens;
            end = begun->at;
        }
        std::lock_guard<std::mutex> lock(mutex_);
        further_.emplace(top, std::move(samples));
    }
    gathered.pixels_.clear();
    gathered.samples_.clear();
}

void BeamSamples::forget_above(int row)
{
    std::lock_guard<std::mutex> lock(mutex_);
    further_.erase(further_.begin(), further_.lower_bound(row));
}

} // namespace integral
