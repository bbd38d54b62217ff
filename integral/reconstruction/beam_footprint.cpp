// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/beam_footprint.h"

#include <algorithm>

namespace integral {

namespace {

// A pixel uses samples of pixels whose directions differ from its own by at most most_pixels pixels
// and whose lenses are at most most_lenses steps away. At a difference of r pixels the weight is
// exp(-fall r^2). Behind lines (lenticular lenses) fewer pixels look at one place, so that larger
// limits pay. Tuned on POV-Ray's sample scenes: 2.5 pixels behind square lenses would lower the
// error by 3 to 4% in 9% more time; 7.2 behind lines, by 0.5% in 2% more time.
constexpr double most_pixels = 2, most_pixels_across_lines = 5, fall = 0.17,
                 fall_across_lines = 0.03;
constexpr int most_lenses = 1, most_lenses_across_lines = 3;

// Samples' weights fall towards the ends of the range of directions. Equal weights over this
// fraction of the range would have about the same standard deviation over direction.
constexpr double spread = 0.8;

// Another pixel's samples are left out if the product of its two nearnesses, one along each axis
// (ReuseNeighbourhood::find_nearness), and of the square root of its weight is below this. Tuned on
// POV-Ray's sample scenes: behind square lenses this saves some 10% of the time and increases the
// error by 1.6%.
constexpr float least_nearness = 0.15f;

// The furthest depth in a quilt, in distances of the eyes from the sheet. There a place moves from
// view to view by less than 1/100 of a pixel less than at infinity, if views are 1000 pixels wide.
constexpr double furthest_of_distance = 1e5;

// A height, as a fraction of a lens's width, that is small for a footprint but exceeds the rounding
// of stored places on the sheet.
constexpr float little_height = 2e-4f;

/// A pixel's extent along an axis, approximated: its width if the axis is nearer to horizontal,
/// else its height.
double pixel_along(Vec2 pixel, Vec2 axis)
{
    return std::fabs(axis.x) > std::fabs(axis.y) ? pixel.x : pixel.y;
}

/// The direction of the slit in the aperture of a lenticular sheet.
Vec2 slit_direction(const Lattice& lattice)
{
    return std::fabs(lattice.along().y) >= std::fabs(lattice.along().x) ? Vec2{1, 0} : Vec2{0, 1};
}

/// Slope of the slit: its component along the lines, divided by its component across them.
double lean_of_slit(const Lattice& lattice)
{
    const Vec2 slit = slit_direction(lattice);
    return dot(slit, lattice.along()) / dot(slit, lattice.across());
}

} // namespace

BeamFootprint::BeamFootprint(const IntegralCamera& camera, const LightFieldRay& centre, Vec2 size,
                             float furthest)
{
    const Lattice& lattice = camera.optics.lattice();
    const Medium& medium = camera.optics.medium();
    const Vec2 pixel = camera.film.pixel_pitch, part{size.x * pixel.x, size.y * pixel.y};
    const double n = medium.n, m = n * n - 1;
    // The slope is n q/sqrt(1 - m q^2), where q is the offset on the film divided by the thickness.
    const double sx = centre.slope[0], sy = centre.slope[1],
                 rest = n * n / (n * n + m * (sx * sx + sy * sy));
    const auto steepness = [&](double slope) {
        const double q = slope * std::sqrt(rest) / n;
        return n / medium.t / std::sqrt(rest) * (1 + m * q * q / rest);
    };
    const auto lent = [](Axis& axis, double pixels, int lenses) {
        axis.max_slope_offset = float(spread * pixels * axis.step_slope);
        axis.max_lens_distance = (lenses + 0.5f) * axis.cell_at_sheet;
    };
    axes_[0].cell_at_sheet = float(lattice.pitch());
    const auto set_slopes = [&](Axis& axis, double slope, Vec2 direction) {
        axis.step_slope = float(steepness(slope) * pixel_along(pixel, direction));
        axis.pixel_slope = float(steepness(slope) * pixel_along(part, direction));
    };
    set_slopes(axes_[0], sx, lattice.across());
    divergence_ = widening_ = axes_[0].pixel_slope / axes_[0].cell_at_sheet;
    if (lattice.arrangement() != Arrangement::lenticular) {
        axes_[1].cell_at_sheet = float(lattice.row_spacing());
        set_slopes(axes_[1], sy, lattice.along());
        for (Axis& axis : axes_)
            lent(axis, most_pixels, most_lenses);
        return;
    }
    lent(axes_[0], most_pixels_across_lines, most_lenses_across_lines);
    // Along the lines, a pixel's rays meet in the slit. height: their width at the sheet.
    const double d = camera.optics.aperture().distance;
    const double by_film = n * d / (n * d + medium.t),
                 height = by_film * pixel_along(part, lattice.along());
    axes_[1].pixel_at_sheet = float(height);
    axes_[1].pixel_slope = float(height / d);
    axes_[1].step_slope = float(by_film * pixel_along(pixel, lattice.along()) / d);
    axes_[1].cell_slope = float(camera.slit_height({0, 0}) / d);
    // In the plane of the eye all rays are at one height. The footprint is given little_height
    // there, so that the rounding of stored samples does not decide which of them count.
    axes_[1].cell_at_sheet = little_height * axes_[0].cell_at_sheet;
    axes_[1].cell_slope += little_height * axes_[0].pixel_slope;
    // If the lines are slanted, the pixel's width widens the footprint along them, or the lens's
    // width if places are measured from the slit's direction (lean_). Takes the lesser widening.
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

BeamFootprint BeamFootprint::of_view(Vec2 pixel, double distance, Vec2 furthest_eye,
                                     double next_eye)
{
    BeamFootprint footprint;
    const auto set = [&](Axis& axis, double width, double furthest) {
        axis.pixel_at_sheet = float(width);
        axis.pixel_slope = axis.step_slope = float(width / distance);
        axis.max_slope_offset = float(furthest / distance);
        axis.max_lens_distance = 1e9f; // no limit
    };
    set(footprint.axes_[0], pixel.x, furthest_eye.x);
    set(footprint.axes_[1], pixel.y, furthest_eye.y);
    footprint.furthest_depth_ = float(furthest_of_distance * distance);
    footprint.divergence_ = float(next_eye / (distance * std::min(pixel.x, pixel.y)));
    return footprint;
}

ReuseNeighbourhood::ReuseNeighbourhood(const Lattice& lattice, const Film& film)
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

/// Adds the pixels behind the lens that is `step` away from the own lens of a pixel, for own lenses
/// in an even (0) or odd (1) `row`.
void ReuseNeighbourhood::add_lens(const Lattice& lattice, const Film& film, int row, LensIndex step)
{
    Vec2 way = lattice.pole({step.i, row + step.j}) - lattice.pole({0, row});
    if (!lines_ && !(length(way) < (most_lenses + 0.5) * lattice.pitch()))
        return;
    const Vec2 a = lattice.across(), b = lattice.along(), pixel = film.pixel_pitch;
    double furthest = most_pixels, furthest_along = most_pixels, fall_across = fall;
    if (lines_) { // the way to the other line along the slit, not the shortest way
        const Vec2 slit = slit_direction(lattice);
        way = (dot(way, a) / dot(slit, a)) * slit;
        furthest = most_pixels_across_lines;
        fall_across = fall_across_lines;
        // Beams of pixels that are further apart along the lines than this do not meet.
        const double rows = std::fabs(lean_of_slit(lattice)) * lattice.pitch() /
                            pixel_along(pixel, b);
        furthest_along = std::min(most_pixels, 0.5 + rows);
    }
    // Direction of a pixel minus that of the pixel that uses it, in pixels along both axes.
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

/// The index of `steps` in steps_[axis], where they are appended if they are new.
int ReuseNeighbourhood::index_of(int axis, const EightSteps& steps)
{
    const auto equal = [](const Eight& a, const Eight& b) {
        return std::equal(a.values, a.values + 8, b.values, [](double x, double y) {
            return std::fabs(x - y) < 1e-4 * (1 + std::fabs(y));
        });
    };
    std::vector<EightSteps>& all = steps_[axis];
    const auto same = std::find_if(all.begin(), all.end(), [&](const EightSteps& other) {
        return equal(steps.lens, other.lens) && equal(steps.pixels, other.pixels);
    });
    const int index = int(same - all.begin());
    if (same == all.end())
        all.push_back(steps);
    return index;
}

/// Computes the nearness of each step along an axis: how close the footprint of a pixel at that
/// step comes to `patch` at the best depth from `nearest` to `furthest`. 1: the two have the same
/// centre there; 0: they overlap at no depth.
template <class Floats>
INTEGRAL_INLINE void ReuseNeighbourhood::find_nearness(int axis, const BeamFootprint& patch,
                                                       float nearest, float furthest,
                                                       Scratch& scratch) const
{
    std::vector<Eight>& nearness = scratch.nearness[axis];
    nearness.resize(steps_[axis].size());
    const BeamFootprint::Axis& widths = patch.axis(axis);
    // On either side of the sheet, the distance of two centres and the footprint's width are linear
    // in the depth. So their ratio is smallest at an end of the range, at the sheet, or where the
    // centres meet.
    const bool crosses_sheet = nearest < 0 && furthest > 0;
    const Floats by_nearest = broadcast<Floats>(0.5f / widths.reach(nearest)),
                 by_furthest = broadcast<Floats>(0.5f / widths.reach(furthest)),
                 by_sheet = broadcast<Floats>(crosses_sheet ? 0.5f / widths.reach(0.0f) : 1e9f),
                 step_slope = broadcast<Floats>(widths.step_slope), one = broadcast<Floats>(1),
                 none = broadcast<Floats>(0);
    for (std::size_t k = 0; k < nearness.size(); ++k) {
        const Floats lens = load<Floats>(steps_[axis][k].lens),
                     slope = step_slope * load<Floats>(steps_[axis][k].pixels),
                     at_nearest = lens + broadcast<Floats>(nearest) * slope,
                     at_furthest = lens + broadcast<Floats>(furthest) * slope,
                     at_ends = min(by_nearest * abs(at_nearest), by_furthest * abs(at_furthest)),
                     apart = min(at_ends, by_sheet * abs(lens));
        // Where the signs differ, the centres meet at a depth in between.
        store(nearness[k], max(one - select(at_nearest * at_furthest < none, none, apart), none));
    }
}

/// Mask of eight consecutive integers from `first` on: bit k is set if first + k is in [0, number).
inline unsigned inside(int first, int number)
{
    const int before = std::clamp(-first, 0, 8), after = std::clamp(first + 8 - number, 0, 8);
    return (0xffu << before) & (0xffu >> after);
}

template <class Floats>
INTEGRAL_INLINE void ReuseNeighbourhood::find_with(int x, int y, LightFieldImage::StoredLens own,
                                                   const BeamFootprint& patch, float nearest,
                                                   float furthest, Scratch& scratch) const
{
    for (int axis = 0; axis < 2; ++axis)
        find_nearness<Floats>(axis, patch, nearest, furthest, scratch);
    const Eight *across = scratch.nearness[0].data(), *along = scratch.nearness[1].data();
    const std::vector<Lenders>& all = lenders_[own[1] & 1];
    if (scratch.found.size() < all.size())
        scratch.found.resize(all.size());
    Found* found = scratch.found.data();
    for (const Lenders& lenders : all) {
        const Floats near = load<Floats>(across[lenders.steps[0]]) *
                            load<Floats>(along[lenders.steps[1]]) * load<Floats>(lenders.nearness);
        unsigned which = bits(near > broadcast<Floats>(least_nearness));
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
void ReuseNeighbourhood::find_with_avx2(int x, int y, LightFieldImage::StoredLens own,
                                        const BeamFootprint& patch, float nearest, float furthest,
                                        Scratch& scratch) const
{
    find_with<EightFloats>(x, y, own, patch, nearest, furthest, scratch);
}
#endif

void ReuseNeighbourhood::find(int x, int y, LightFieldImage::StoredLens own,
                              const BeamFootprint& patch, float nearest, float furthest,
                              Scratch& scratch) const
{
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        return find_with_avx2(x, y, own, patch, nearest, furthest, scratch);
#endif
    find_with<TwiceFourFloats>(x, y, own, patch, nearest, furthest, scratch);
}

} // namespace integral
