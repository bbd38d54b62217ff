// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/beam_samples.h"

#include <algorithm>
#include <utility>

namespace integral {

namespace {

/// 0 for NaN. Comparisons in place of fmin and fmax, which are calls: every sample is stored by
/// this function.
std::int16_t rounded(float x)
{
    constexpr float most = 32767;
    const float within = x > most ? most : x > -most ? x : x <= -most ? -most : 0;
    return std::int16_t(std::lrint(within));
}

} // namespace

SightSlope sight_slope(const Lattice& lattice, const BeamRay& ray)
{
    const Vec2 slope = (1 / ray.direction.z) * Vec2{ray.direction.x, ray.direction.y};
    const Vec2 point = Vec2{ray.point.x, ray.point.y} - ray.point.z * slope;
    const auto along_axes = [&](Vec2 v) {
        return std::array<float, 2>{float(dot(v, lattice.across())),
                                    float(dot(v, lattice.along()))};
    };
    return {along_axes(point), along_axes(slope)};
}

BeamSamples::Units BeamSamples::units(const IntegralCamera& camera)
{
    constexpr double most = 32767;
    const LensSheet& sheet = camera.optics.sheet();
    const double pixel = std::max(camera.film.pixel_pitch.x, camera.film.pixel_pitch.y),
                 pixel_slope = sheet.ior * pixel / sheet.thickness;
    // A sample is at most a lens's cell and a pixel away from the centre; four times that is room.
    // So is room for surfaces that are seen edge-on from a hundredth of a pixel beside the sample.
    return {float(4 * std::max(sheet.pitch, pixel) / most), float(16 * pixel_slope / most),
            float(100 / pixel_slope / most)};
}

BeamSamples::BeamSamples(const IntegralCamera& camera, std::shared_ptr<void> memory)
    : width_(camera.film.width),
      units_(units(camera)),
      memory_(memory ? std::move(memory)
                     : zeroed_memory(bytes_a_pixel * camera.film.width * camera.film.height)),
      pixels_(static_cast<Pixel*>(memory_.get()))
{
}

BeamSamples::Sample BeamSamples::stored(const SightSlope& centre, const Seen& seen) const
{
    Sample sample;
    // fmin makes the furthest depth of NaN.
    sample.depth = std::fmax(-furthest_depth, std::fmin(float(seen.depth), furthest_depth));
    for (int k = 0; k < 2; ++k) {
        sample.point[k] = rounded((seen.line.point[k] - centre.point[k]) / units_.point);
        sample.slope[k] = rounded((seen.line.slope[k] - centre.slope[k]) / units_.slope);
        sample.tilt[k] = rounded(seen.tilt[k] / units_.tilt);
    }
    sample.light = StoredLight(seen.light);
    return sample;
}

void BeamSamples::set_first(int x, int y, const SightSlope& centre, LensIndex lens,
                            const Seen& seen)
{
    Pixel& pixel = pixels_[std::size_t(y) * width_ + x];
    pixel.centre = centre;
    pixel.first = stored(centre, seen);
    pixel.number = 1;
    pixel.lens = {std::uint16_t(lens.i), std::uint16_t(lens.j)};
    pixel.lends = StoredLight::holds(seen.light);
}

void BeamSamples::Gathered::add(const BeamSamples& store, const Seen& seen)
{
    Begun& pixel = pixels_.back();
    pixel.lends = pixel.lends && StoredLight::holds(seen.light);
    if (samples_.size() - pixel.at < std::size_t(most_stored - 1))
        samples_.push_back(store.stored(store.pixel(pixel.x, pixel.y).centre, seen));
}

void BeamSamples::store(int top, Gathered& gathered)
{
    if (!gathered.samples_.empty()) {
        auto samples = std::make_unique<Sample[]>(gathered.samples_.size());
        std::copy(gathered.samples_.begin(), gathered.samples_.end(), samples.get());
        std::size_t end = gathered.samples_.size();
        for (auto begun = gathered.pixels_.rbegin(); begun != gathered.pixels_.rend(); ++begun) {
            Pixel& pixel = pixels_[std::size_t(begun->y) * width_ + begun->x];
            pixel.more = samples.get() + begun->at;
            pixel.number = std::uint16_t(1 + end - begun->at);
            pixel.lends = pixel.lends && begun->lends;
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
