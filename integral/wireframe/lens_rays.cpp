// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/lens_rays.h"

#include <algorithm>

namespace integral {
namespace {

/// Points spread evenly over the unit square: one column for each sample, rows by a lattice.
Vec2 unit_point(int k, int samples)
{
    constexpr double golden = 0.6180339887498949;
    const double row = 0.5 + (k - 0.5 * (samples - 1)) * golden;
    return {(k + 0.5) / samples, row - std::floor(row)};
}

/// I(v) = cos(atan 4v), thesis figure 3-19.
double synthetic_spread(double v) { return 1 / std::sqrt(1 + 16 * v * v); }

std::vector<RayBundle> full_bundles(const SheetOptics& optics, int samples)
{
    const Aperture& aperture = optics.aperture();
    const bool lenticular = optics.sheet().arrangement == Arrangement::lenticular;
    const double slit = lenticular
                            ? extent_across_slit(optics.sheet(), {aperture.width, aperture.height})
                            : 0;
    std::vector<RayBundle> bundles;
    for (int k = 0; k < samples; ++k) {
        const LensPoint point = cell_point(optics.lattice(), unit_point(k, samples), slit);
        bundles.push_back({{point}, {{1.0 / samples, {1, 0, 0, 0, 0}, point}}});
    }
    return bundles;
}

RayBundle hybrid_bundle(const SheetOptics& optics, int samples)
{
    const Lattice& lattice = optics.lattice();
    const bool lenticular = lattice.arrangement() == Arrangement::lenticular;
    RayBundle bundle;
    for (const WeightedLensPoint& point : hybrid_points(lattice))
        bundle.rays.push_back(point.point);
    double sum = 0;
    for (int k = 0; k < samples; ++k) {
        const Vec2 unit = unit_point(k, samples);
        const Vec2 v{2 * unit.x - 1, lenticular ? 0 : 2 * unit.y - 1};
        if (length(v) > 1)
            continue;
        SharpPicture picture;
        picture.weight = synthetic_spread(length(v));
        // The rays are in the order pole, -across, +across, -along, +along.
        picture.share = {1 - std::fabs(v.x) - std::fabs(v.y), std::max(-v.x, 0.0),
                         std::max(v.x, 0.0), std::max(-v.y, 0.0), std::max(v.y, 0.0)};
        const double half = 0.5 * lattice.pitch();
        picture.through.offset = (v.x * half) * lattice.across() + (v.y * half) * lattice.along();
        sum += picture.weight;
        bundle.pictures.push_back(picture);
    }
    for (SharpPicture& picture : bundle.pictures)
        picture.weight /= sum;
    return bundle;
}

} // namespace

std::vector<RayBundle> bundles_of(const SheetOptics& optics, int samples)
{
    if (optics.model() == LensModel::full)
        return full_bundles(optics, samples);
    if (optics.model() == LensModel::hybrid)
        return {hybrid_bundle(optics, samples)};
    return {{{LensPoint{}}, {SharpPicture{}}}};
}

} // namespace integral
