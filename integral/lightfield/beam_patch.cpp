// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/beam_patch.h"

#include <algorithm>

namespace integral {

namespace {

// A pixel uses the samples of pixels whose directions are at most this far from its own, in pixels.
// At a distance of r pixels they have the weight exp(-fall r^2). Their lenses are at most
// most_lenses steps from its own. Behind a line of lenses fewer pixels share a place, so that it
// pays to go further. Found by trying on sample scenes of POV-Ray's.
constexpr double most_pixels = 3.2, most_pixels_across_lines = 7.2, fall = 0.17,
                 fall_across_lines = 0.03;
constexpr int most_lenses = 1, most_lenses_across_lines = 3;

// The weights of samples fall towards the ends of the range of directions. Equal weights over this
// part of the range have about the same spread.
constexpr double spread = 0.8;

// A pixel's samples are left out where the product of its nearness along both axes
// (LendingPixels::find_nearness) and of the root of its weight is less. Found by trying on sample
// scenes of POV-Ray's: behind square lenses that takes 6% less time and errs 1% more.
constexpr float least_nearness = 0.25f;

/// A pixel's width along an axis. A square one that is turned is taken for an upright one.
double pixel_along(Vec2 pixel, Vec2 axis)
{
    return std::fabs(axis.x) > std::fabs(axis.y) ? pixel.x : pixel.y;
}

/// The direction of the slit in the aperture of a sheet of lines.
Vec2 slit_direction(const Lattice& lattice)
{
    return std::fabs(lattice.along().y) >= std::fabs(lattice.along().x) ? Vec2{1, 0} : Vec2{0, 1};
}

} // namespace

BeamPatch::BeamPatch(const IntegralCamera& camera, const SightSlope& centre)
{
    const Lattice& lattice = camera.optics.lattice();
    const Medium& medium = camera.optics.medium();
    const Vec2 pixel = camera.film.pixel_pitch;
    const double n = medium.n, m = n * n - 1;
    // The slope is n q/sqrt(1 - m q^2), q being the way on the film divided by the thickness.
    const double sx = centre.slope[0], sy = centre.slope[1],
                 rest = n * n / (n * n + m * (sx * sx + sy * sy));
    const auto steepness = [&](double slope) {
        const double q = slope * std::sqrt(rest) / n;
        return n / medium.t / std::sqrt(rest) * (1 + m * q * q / rest);
    };
    const auto lent = [](Axis& axis, double pixels, int lenses) {
        axis.lent_slope = float(spread * pixels * axis.pixel_slope);
        axis.lent_way = (lenses + 0.5f) * axis.cell_at_sheet;
    };
    axes_[0].cell_at_sheet = float(lattice.pitch());
    axes_[0].pixel_slope = float(steepness(sx) * pixel_along(pixel, lattice.across()));
    if (lattice.arrangement() != Arrangement::lenticular) {
        axes_[1].cell_at_sheet = float(lattice.row_spacing());
        axes_[1].pixel_slope = float(steepness(sy) * pixel_along(pixel, lattice.along()));
        for (Axis& axis : axes_)
            lent(axis, most_pixels, most_lenses);
        return;
    }
    lent(axes_[0], most_pixels_across_lines, most_lenses_across_lines);
    // A pixel's rays spread along the lines by its height, seen from the slit in the aperture. If
    // the lines lean, they spread along them by a part of its width, too.
    const Vec2 slit = slit_direction(lattice);
    const double d = camera.optics.aperture().distance;
    const double height = n * d / (n * d + medium.t) * pixel_along(pixel, lattice.along());
    axes_[1].pixel_at_sheet = float(height);
    axes_[1].pixel_slope = float(height / d);
    axes_[1].cell_slope = float(camera.slit_height({0, 0}) / d +
                                axes_[0].pixel_slope * std::fabs(dot(slit, lattice.along())));
}

LendingPixels::LendingPixels(const Lattice& lattice, const Film& film)
    : lines_(lattice.arrangement() == Arrangement::lenticular),
      width_(film.width),
      height_(film.height)
{
    const int across = lines_ ? most_lenses_across_lines : most_lenses,
              along = lines_ ? 0 : most_lenses;
    for (int row = 0; row < 2; ++row)
        for (int j = -along; j <= along; ++j)
            for (int i = -across; i <= across; ++i)
                add_pixels(lattice, film, row, {i, j});
    for (Lenders& lenders : lenders_)
        find_runs(lenders);
}

/// Adds the pixels behind the lens that is a step away from one in an even (0) or odd row (1).
void LendingPixels::add_pixels(const Lattice& lattice, const Film& film, int row, LensIndex step)
{
    Vec2 way = lattice.pole({step.i, row + step.j}) - lattice.pole({0, row});
    if (!lines_ && !(length(way) < (most_lenses + 0.5) * lattice.pitch()))
        return;
    const Vec2 a = lattice.across(), b = lattice.along(), pixel = film.pixel_pitch;
    const double across = pixel_along(pixel, a), along = pixel_along(pixel, b);
    double most = most_pixels, most_along = most_pixels, fall_across = fall;
    if (lines_) { // not the shortest way across the lines, but the one along the slit
        const Vec2 slit = slit_direction(lattice);
        way = (dot(way, a) / dot(slit, a)) * slit;
        most = most_pixels_across_lines;
        fall_across = fall_across_lines;
        most_along = std::fabs(dot(slit, b)) > 1e-6 ? most_pixels : 0.5;
    }
    const int right = int(std::lround(way.x / pixel.x)), down = int(std::lround(-way.y / pixel.y)),
              around = int(std::ceil(most)) + 1;
    for (int v = -around; v <= around; ++v)
        for (int u = -around; u <= around; ++u) {
            const Vec2 film_way = {(right + u) * pixel.x, -(down + v) * pixel.y},
                       off = film_way - way;
            const double x = dot(off, a) / across, y = dot(off, b) / along;
            if (std::hypot(x / most, y / most_along) > 1)
                continue;
            Lender lender{right + u, down + v, std::int16_t(step.i), std::int16_t(step.j)};
            lender.part = float(std::exp(-fall_across * x * x - fall * y * y));
            lender.nearness = std::sqrt(lender.part);
            lender.steps = {index_of(0, dot(way, a), x),
                            lines_ ? index_of(1, 0, 0) : index_of(1, dot(way, b), y)};
            lenders_[row].all.push_back(lender);
            rows_ = std::max(rows_, std::abs(lender.y));
        }
}

/// The index of a step along an axis, which is added if it is new.
int LendingPixels::index_of(int axis, double lens, double pixels)
{
    const auto alike = [](double a, double b) {
        return std::fabs(a - b) < 1e-4 * (1 + std::fabs(b));
    };
    std::vector<EightSteps>& steps = steps_[axis];
    int& number = step_numbers_[axis];
    for (int k = 0; k < number; ++k)
        if (alike(steps[k / 8].lens[k % 8], lens) && alike(steps[k / 8].pixels[k % 8], pixels))
            return k;
    if (number % 8 == 0)
        steps.emplace_back();
    steps.back().lens[number % 8] = float(lens);
    steps.back().pixels[number % 8] = float(pixels);
    return number++;
}

/// Sorts lenders by their steps across.
void LendingPixels::find_runs(Lenders& lenders) const
{
    std::stable_sort(lenders.all.begin(), lenders.all.end(),
                     [](const Lender& a, const Lender& b) { return a.steps[0] < b.steps[0]; });
    for (int k = 0; k < int(lenders.all.size()); ++k) {
        const int step = lenders.all[k].steps[0];
        if (lenders.runs.empty() || lenders.runs.back().step != step)
            lenders.runs.push_back({step, k, k});
        lenders.runs.back().end = k + 1;
    }
}

/// Works out for each step along an axis how near the patch of a pixel that is so far away comes to
/// a patch at any depth of a range: 1 where the two have the same centre, 0 where they do not meet.
/// Its loop, which runs for every pixel, has no branches.
template <class Floats>
INTEGRAL_INLINE void LendingPixels::find_nearness_with(int axis, const BeamPatch& patch,
                                                       float nearest, float furthest,
                                                       Scratch& scratch) const
{
    std::vector<Eight>& nearness = scratch.nearness[axis];
    nearness.resize(steps_[axis].size());
    const BeamPatch::Axis& widths = patch.axis(axis);
    // The distance of two centres is linear in the depth, and what it may be is so from 0 on.
    const bool crosses_sheet = nearest < 0 && furthest > 0;
    const Floats by_nearest = eight_of<Floats>(0.5f / widths.reach(nearest)),
                 by_furthest = eight_of<Floats>(0.5f / widths.reach(furthest)),
                 by_sheet = eight_of<Floats>(crosses_sheet ? 0.5f / widths.reach(0) : 1e9f),
                 pixel_slope = eight_of<Floats>(widths.pixel_slope), one = eight_of<Floats>(1),
                 none = eight_of<Floats>(0);
    for (std::size_t k = 0; k < nearness.size(); ++k) {
        const Floats lens = loaded<Floats>(steps_[axis][k].lens),
                     slope = pixel_slope * loaded<Floats>(steps_[axis][k].pixels),
                     at_nearest = lens + eight_of<Floats>(nearest) * slope,
                     at_furthest = lens + eight_of<Floats>(furthest) * slope,
                     at_ends = least(by_nearest * magnitude(at_nearest),
                                     by_furthest * magnitude(at_furthest)),
                     apart = least(at_ends, by_sheet * magnitude(lens));
        // Where the signs differ, the centres meet at a depth between.
        store(nearness[k], one - chosen(at_nearest * at_furthest < none, none, apart));
    }
}

#ifdef INTEGRAL_HAS_AVX2
INTEGRAL_TARGET_AVX2
void LendingPixels::find_nearness_with_avx2(int axis, const BeamPatch& patch, float nearest,
                                            float furthest, Scratch& scratch) const
{
    find_nearness_with<EightFloats>(axis, patch, nearest, furthest, scratch);
}
#endif

void LendingPixels::find_nearness(int axis, const BeamPatch& patch, float nearest, float furthest,
                                  Scratch& scratch) const
{
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return find_nearness_with_avx2(axis, patch, nearest, furthest, scratch);
#endif
    find_nearness_with<TwiceFourFloats>(axis, patch, nearest, furthest, scratch);
}

void LendingPixels::find(int x, int y, FirstSamples::StoredLens own, const BeamPatch& patch,
                         float nearest, float furthest, Scratch& scratch) const
{
    for (int axis = 0; axis < 2; ++axis)
        find_nearness(axis, patch, nearest, furthest, scratch);
    const Eight *across = scratch.nearness[0].data(), *along = scratch.nearness[1].data();
    const auto at = [](const Eight* nearness, int step) { return nearness[step / 8u][step % 8u]; };
    const Lenders& lenders = lenders_[own[1] & 1];
    scratch.found.clear();
    for (const Lenders::Run& run : lenders.runs) {
        const float near_across = at(across, run.step);
        if (near_across < least_nearness)
            continue;
        for (int k = run.begin; k < run.end; ++k) {
            const Lender& lender = lenders.all[k];
            const int i = x + lender.x, j = y + lender.y;
            if (near_across * at(along, lender.steps[1]) * lender.nearness < least_nearness ||
                i < 0 || j < 0 || i >= width_ || j >= height_)
                continue;
            scratch.found.push_back(
                {std::size_t(j) * width_ + i,
                 {std::uint16_t(own[0] + lender.i), std::uint16_t(own[1] + lender.j)},
                 lender.part});
        }
    }
}

} // namespace integral
