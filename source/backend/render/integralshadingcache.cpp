// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralshadingcache.h"
#include "backend/scene/integralcamera.h"

#include <algorithm>
#include <cmath>
#include <cstring>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

/// The table's size: more slots than a frame has patches, except for very large frames. The table
/// of a small frame fits in the processor's cache.
std::size_t Slots_For(const integral::Film& film, double slots_a_pixel)
{
    constexpr std::size_t least = std::size_t(1) << 14, most = std::size_t(1) << 20;
    std::size_t slots = least;
    while (slots < most && slots < slots_a_pixel * film.width * film.height)
        slots *= 2;
    return slots;
}

/// floor(log2(x)) for x > 0.
int Exponent(double x)
{
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return int(bits >> 52) - 1023;
}

}

IntegralShadingCache::IntegralShadingCache(const integral::IntegralCamera& camera, double cells,
                                           double slots_a_pixel)
    : camera(camera),
      spread(camera.optics.medium().n * camera.film.pixel_pitch.x /
             camera.optics.sheet().thickness),
      cells(cells),
      scale(length(camera.placement.z)),
      patches(Slots_For(camera.film, slots_a_pixel)),
      locks(patches.size() / row_length)
{
}

std::size_t IntegralShadingCache::Slot(std::uint64_t row, std::size_t column) const
{
    return std::size_t(row % locks.size()) * row_length + column;
}

constexpr double farthest = 1e12; // mm

/// At the sheet a pixel's beam is as wide as its lens, and it spreads by the pixel's angle. Along a
/// cylindrical lens the beam is one pixel high at the sheet, and spreads as seen from the aperture.
int IntegralShadingCache::Level(const VECTOR point) const
{
    const integral::Placement& at = camera.placement;
    const double behind = dot(From_POV(point) - at.origin, at.z) / (scale * scale);
    const integral::Vec3 seen = camera.parallax
                                    ? image_of(camera.relief, integral::Vec3{0, 0, behind})
                                          .value_or(integral::Vec3{0, 0, farthest})
                                    : integral::Vec3{0, 0, behind};
    // In the scene, a beam is narrower or wider than the viewer sees it.
    const double z = std::min(std::fabs(seen.z), farthest),
                 narrower = std::max(1e-9, std::fabs(1 + camera.relief.bend * behind));
    const double pitch = camera.optics.sheet().pitch;
    double area = pitch * pitch + z * spread * z * spread;
    if (camera.optics.sheet().arrangement == integral::Arrangement::lenticular)
        area = std::sqrt(area) * camera.film.pixel_pitch.y *
               (1 + z / camera.optics.aperture().distance);
    return Exponent(narrower * scale * narrower * scale * (area / cells));
}

double IntegralShadingCache::Size(int level)
{
    return std::ldexp(level & 1 ? 1.4142135623730951 : 1.0, level >> 1);
}

int IntegralShadingCache::Coarser_For_Lights() const
{
    constexpr double steps = 3;
    return int(std::min(steps, std::max(0.0, std::floor(std::log2(cells)))));
}

bool IntegralShadingCache::Of_Use() const
{
    const integral::Vec3 sheet = camera.placement.origin;
    const VECTOR point = {sheet.x, sheet.y, sheet.z};
    return Size(Level(point)) > 1e-2;
}

bool IntegralShadingCache::Find(std::size_t slot, std::uint64_t key, Patch& patch) const
{
    std::atomic_flag& lock = locks[slot / row_length];
    while (lock.test_and_set(std::memory_order_acquire))
    {
    }
    patch = patches[slot];
    lock.clear(std::memory_order_release);
    return patch.key == key;
}

void IntegralShadingCache::Store(std::size_t slot, const Patch& patch)
{
    std::atomic_flag& lock = locks[slot / row_length];
    while (lock.test_and_set(std::memory_order_acquire))
    {
    }
    patches[slot] = patch;
    lock.clear(std::memory_order_release);
}

}
