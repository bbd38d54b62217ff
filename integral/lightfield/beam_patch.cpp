// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/beam_patch.h"

#include <algorithm>

namespace integral {

namespace {

// A pixel uses the samples of pixels whose directions are at most this far from its own, in pixels.
// At a distance of r pixels they have the weight exp(-fall r^2). Their lenses are at most
// most_lenses steps from its own. Behind a line of lenses fewer pixels share a place, so that it
// pays to go further. Found by trying on sample scenes of POV-Ray's: with 2.5 pixels behind square
// lenses, and 7.2 behind lines, frames err 3 to 4% and 0.5% less, and take 9% and 2% longer.
constexpr double most_pixels = 2, most_pixels_across_lines = 5, fall = 0.17,
                 fall_across_lines = 0.03;
constexpr int most_lenses = 1, most_lenses_across_lines = 3;

// The weights of samples fall towards the ends of the range of directions. Equal weights over this
// part of the range have about the same spread.
constexpr double spread = 0.8;

// A pixel's samples are left out where the product of its nearness along both axes
// (LendingPixels::find_nearness) and of the root of its weight is less. Found by trying on sample
// scenes of POV-Ray's: behind square lenses that takes some 10% less time and errs 1.6% more.
constexpr float least_nearness = 0.15f;

// A height that is little beside a lens, and much beside the rounding of a place on the sheet.
constexpr float little_height = 2e-4f;

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

/// How far a way along the slit goes along the lines, for each unit that it goes across them.
double lean_of_slit(const Lattice& lattice)
{
    const Vec2 slit = slit_direction(lattice);
    return dot(slit, lattice.along()) / dot(slit, lattice.across());
}

} // namespace

BeamPatch::BeamPatch(const IntegralCamera& camera, const SightSlope& centre, Vec2 size,
                     float furthest)
{
    const Lattice& lattice = camera.optics.lattice();
    const Medium& medium = camera.optics.medium();
    const Vec2 pixel = camera.film.pixel_pitch, part{size.x * pixel.x, size.y * pixel.y};
    const double n = medium.n, m = n * n - 1;
    // The slope is n q/sqrt(1 - m q^2), q being the way on the film divided by the thickness.
    const double sx = centre.slope[0], sy = centre.slope[1],
                 rest = n * n / (n * n + m * (sx * sx + sy * sy));
    const auto steepness = [&](double slope) {
        const double q = slope * std::sqrt(rest) / n;
        return n / medium.t / std::sqrt(rest) * (1 + m * q * q / rest);
    };
    const auto lent = [](Axis& axis, double pixels, int lenses) {
        axis.lent_slope = float(spread * pixels * axis.step_slope);
        axis.lent_way = (lenses + 0.5f) * axis.cell_at_sheet;
    };
    axes_[0].cell_at_sheet = float(lattice.pitch());
    const auto set_slopes = [&](Axis& axis, double slope, Vec2 direction) {
        axis.step_slope = float(steepness(slope) * pixel_along(pixel, direction));
        axis.pixel_slope = float(steepness(slope) * pixel_along(part, direction));
    };
    set_slopes(axes_[0], sx, lattice.across());
    if (lattice.arrangement() != Arrangement::lenticular) {
        axes_[1].cell_at_sheet = float(lattice.row_spacing());
        set_slopes(axes_[1], sy, lattice.along());
        for (Axis& axis : axes_)
            lent(axis, most_pixels, most_lenses);
        return;
    }
    lent(axes_[0], most_pixels_across_lines, most_lenses_across_lines);
    // A pixel's rays spread along the lines by its height, seen from the slit in the aperture.
    const double d = camera.optics.aperture().distance;
    const double by_film = n * d / (n * d + medium.t),
                 height = by_film * pixel_along(part, lattice.along());
    axes_[1].pixel_at_sheet = float(height);
    axes_[1].pixel_slope = float(height / d);
    axes_[1].step_slope = float(by_film * pixel_along(pixel, lattice.along()) / d);
    axes_[1].cell_slope = float(camera.slit_height({0, 0}) / d);
    // In the plane of the eye all of them are at one height. There the patch is this high, so that
    // the rounding of stored samples does not decide which count.
    axes_[1].cell_at_sheet = little_height * axes_[0].cell_at_sheet;
    axes_[1].cell_slope += little_height * axes_[0].pixel_slope;
    // If the lines lean, a pixel's width adds to the one along them, or a lens's to the one off the
    // slit, whichever is less.
    const float lean = float(lean_of_slit(lattice)),
                by_pixel = axes_[0].pixel_slope *
                           float(std::fabs(dot(slit_direction(lattice), lattice.along()))),
                by_cell = std::fabs(lean) * axes_[0].cell_at_sheet;
    if (furthest * by_pixel < by_cell) {
        axes_[1].cell_slope += by_pixel;
    } else {
        axes_[1].cell_at_sheet += by_cell;
        lean_ = lean;
    }
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
                add_lens(lattice, film, row, {i, j});
}

/// Adds the pixels behind the lens that is a step away from one in an even (0) or odd row (1).
void LendingPixels::add_lens(const Lattice& lattice, const Film& film, int row, LensIndex step)
{
    Vec2 way = lattice.pole({step.i, row + step.j}) - lattice.pole({0, row});
    if (!lines_ && !(length(way) < (most_lenses + 0.5) * lattice.pitch()))
        return;
    const Vec2 a = lattice.across(), b = lattice.along(), pixel = film.pixel_pitch;
    double furthest = most_pixels, furthest_along = most_pixels, fall_across = fall;
    if (lines_) { // not the shortest way across the lines, but the one along the slit
        const Vec2 slit = slit_direction(lattice);
        way = (dot(way, a) / dot(slit, a)) * slit;
        furthest = most_pixels_across_lines;
        fall_across = fall_across_lines;
        // Beams of pixels that are further away along the lines do not meet.
        const double rows = std::fabs(lean_of_slit(lattice)) * lattice.pitch() /
                            pixel_along(pixel, b);
        furthest_along = std::min(most_pixels, 0.5 + rows);
    }
    // How far the direction of a pixel is from that of the pixel's own, in pixels along both axes.
    const int right = int(std::lround(way.x / pixel.x)), down = int(std::lround(-way.y / pixel.y));
    const auto off = [&](int u, int v) -> Vec2 {
        const Vec2 film_way = Vec2{(right + u) * pixel.x, -(down + v) * pixel.y} - way;
        return {dot(film_way, a) / pixel_along(pixel, a), dot(film_way, b) / pixel_along(pixel, b)};
    };
    const auto is_near = [&](Vec2 off) {
        return std::hypot(off.x / furthest, off.y / furthest_along) <= 1;
    };
    const int around = int(std::ceil(furthest)) + 1;
    int first = around + 1, last = -around - 1;
    for (int v = -around; v <= around; ++v)
        for (int u = -around; u <= around; ++u)
            if (is_near(off(u, v))) {
                first = std::min(first, u);
                last = std::max(last, u);
            }
    for (int v = -around; v <= around; ++v)
        for (int u = first; u <= last; u += 8) {
            Lenders lenders{right + u, down + v, std::int16_t(step.i), std::int16_t(step.j)};
            EightSteps across, along;
            bool any = false;
            for (int k = 0; k < 8; ++k) {
                const Vec2 at = off(u + k, v);
                across.lens[k] = float(dot(way, a));
                across.pixels[k] = float(at.x);
                along.lens[k] = lines_ ? 0 : float(dot(way, b));
                along.pixels[k] = lines_ ? 0 : float(at.y);
                if (!is_near(at))
                    continue;
                any = true;
                lenders.parts[k] = float(std::exp(-fall_across * at.x * at.x - fall * at.y * at.y));
                lenders.nearness[k] = std::sqrt(lenders.parts[k]);
            }
            if (!any)
                continue;
            lenders.steps = {index_of(0, across), index_of(1, along)};
            lenders_[row].push_back(lenders);
            rows_ = std::max(rows_, std::abs(lenders.y));
        }
}

/// The index of eight steps along an axis, which are added if they are new.
int LendingPixels::index_of(int axis, const EightSteps& steps)
{
    const auto alike = [](const Eight& a, const Eight& b) {
        return std::equal(a.values, a.values + 8, b.values, [](double x, double y) {
            return std::fabs(x - y) < 1e-4 * (1 + std::fabs(y));
        });
    };
    std::vector<EightSteps>& all = steps_[axis];
    const auto same = std::find_if(all.begin(), all.end(), [&](const EightSteps& other) {
        return alike(steps.lens, other.lens) && alike(steps.pixels, other.pixels);
    });
    const int index = int(same - all.begin());
    if (same == all.end())
        all.push_back(steps);
    return index;
}

/// Works out for each step along an axis how near the patch of a pixel that is so far away comes to
/// a patch at any depth of a range: 1 where the two have the same centre, 0 where they do not meet.
template <class Floats>
INTEGRAL_INLINE void LendingPixels::find_nearness(int axis, const BeamPatch& patch, float nearest,
                                                  float furthest, Scratch& scratch) const
{
    std::vector<Eight>& nearness = scratch.nearness[axis];
    nearness.resize(steps_[axis].size());
    const BeamPatch::Axis& widths = patch.axis(axis);
    // On either side of the sheet, the distance of two centres and the patch's width are linear in
    // the depth. So their ratio is least at an end of the range, at the sheet, or where the centres
    // meet.
    const bool crosses_sheet = nearest < 0 && furthest > 0;
    const Floats by_nearest = eight_of<Floats>(0.5f / widths.reach(nearest)),
                 by_furthest = eight_of<Floats>(0.5f / widths.reach(furthest)),
                 by_sheet = eight_of<Floats>(crosses_sheet ? 0.5f / widths.reach(0.0f) : 1e9f),
                 step_slope = eight_of<Floats>(widths.step_slope), one = eight_of<Floats>(1),
                 none = eight_of<Floats>(0);
    for (std::size_t k = 0; k < nearness.size(); ++k) {
        const Floats lens = loaded<Floats>(steps_[axis][k].lens),
                     slope = step_slope * loaded<Floats>(steps_[axis][k].pixels),
                     at_nearest = lens + eight_of<Floats>(nearest) * slope,
                     at_furthest = lens + eight_of<Floats>(furthest) * slope,
                     at_ends = least(by_nearest * magnitude(at_nearest),
                                     by_furthest * magnitude(at_furthest)),
                     apart = least(at_ends, by_sheet * magnitude(lens));
        // Where the signs differ, the centres meet at a depth between.
        store(nearness[k], most(one - chosen(at_nearest * at_furthest < none, none, apart), none));
    }
}

/// The bits of those of eight numbers beside each other, the first of which is `first`, that are
/// from 0 to `number` - 1.
inline unsigned inside(int first, int number)
{
    const int before = std::clamp(-first, 0, 8), after = std::clamp(first + 8 - number, 0, 8);
    return (0xffu << before) & (0xffu >> after);
}

template <class Floats>
INTEGRAL_INLINE void LendingPixels::find_with(int x, int y, FirstSamples::StoredLens own,
                                              const BeamPatch& patch, float nearest, float furthest,
                                              Scratch& scratch) const
{
    for (int axis = 0; axis < 2; ++axis)
        find_nearness<Floats>(axis, patch, nearest, furthest, scratch);
    const Eight *across = scratch.nearness[0].data(), *along = scratch.nearness[1].data();
    const std::vector<Lenders>& all = lenders_[own[1] & 1];
    if (scratch.found.size() < all.size())
        scratch.found.resize(all.size());
    Found* found = scratch.found.data();
    for (const Lenders& lenders : all) {
        const Floats near = loaded<Floats>(across[lenders.steps[0]]) *
                            loaded<Floats>(along[lenders.steps[1]]) *
                            loaded<Floats>(lenders.nearness);
        unsigned which = bits(near > eight_of<Floats>(least_nearness));
        const int i = x + lenders.x, j = y + lenders.y;
        if (which == 0 || j < 0 || j >= height_)
            continue;
        if (i < 0 || i + 8 > width_)
            which &= inside(i, width_);
        *found++ = {std::ptrdiff_t(j) * width_ + i,
                    which,
                    {std::uint16_t(own[0] + lenders.i), std::uint16_t(own[1] + lenders.j)},
                    &lenders.parts};
    }
    scratch.number = std::size_t(found - scratch.found.data());
}

#ifdef INTEGRAL_HAS_AVX2
INTEGRAL_TARGET_AVX2
void LendingPixels::find_with_avx2(int x, int y, FirstSamples::StoredLens own,
                                   const BeamPatch& patch, float nearest, float furthest,
                                   Scratch& scratch) const
{
    find_with<EightFloats>(x, y, own, patch, nearest, furthest, scratch);
}
#endif

void LendingPixels::find(int x, int y, FirstSamples::StoredLens own, const BeamPatch& patch,
                         float nearest, float furthest, Scratch& scratch) const
{
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return find_with_avx2(x, y, own, patch, nearest, furthest, scratch);
#endif
    find_with<TwiceFourFloats>(x, y, own, patch, nearest, furthest, scratch);
}

} // namespace integral
