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

// Two patches meet if their centres are nearer than this part of the sum of their widths. Where
// they are further apart, less than a thirtieth of one lies in the other.
constexpr float least_part = 0.75f;

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
    : lines_(lattice.arrangement() == Arrangement::lenticular)
{
    const int across = lines_ ? most_lenses_across_lines : most_lenses,
              along = lines_ ? 0 : most_lenses;
    for (int row = 0; row < 2; ++row)
        for (int j = -along; j <= along; ++j)
            for (int i = -across; i <= across; ++i)
                add_pixels(lattice, film, row, {i, j});
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
            lender.steps = {index_of(0, dot(way, a), x),
                            lines_ ? index_of(1, 0, 0) : index_of(1, dot(way, b), y)};
            lenders_[row].push_back(lender);
            rows_ = std::max(rows_, std::abs(lender.y));
        }
}

/// The index of a step along an axis, which is added if it is new.
int LendingPixels::index_of(int axis, double lens, double pixels)
{
    std::vector<Step>& steps = steps_[axis];
    const auto alike = [&](const Step& step) {
        return std::fabs(step.lens - lens) < 1e-6 * (1 + std::fabs(lens)) &&
               std::fabs(step.pixels - pixels) < 1e-4;
    };
    const auto found = std::find_if(steps.begin(), steps.end(), alike);
    if (found != steps.end())
        return int(found - steps.begin());
    steps.push_back({float(lens), float(pixels)});
    return int(steps.size()) - 1;
}

/// Works out for each step along an axis whether the patch of a pixel that is so far away meets a
/// patch at any depth of a range. Its loop, which runs for every pixel, has no branches.
void LendingPixels::find_meeting(int axis, const BeamPatch& patch, float nearest, float furthest,
                                 Scratch& scratch) const
{
    const BeamPatch::Axis& widths = patch.axis(axis);
    // The distance of two centres is linear in the depth, and what it may be is so from 0 on.
    const bool crosses_sheet = nearest < 0 && furthest > 0;
    const float within_nearest = 2 * least_part * widths.reach(nearest),
                within_furthest = 2 * least_part * widths.reach(furthest),
                within_sheet = crosses_sheet ? 2 * least_part * widths.reach(0) : -1;
    for (std::size_t k = 0; k < steps_[axis].size(); ++k) {
        const Step& step = steps_[axis][k];
        const float slope = step.pixels * widths.pixel_slope,
                    at_nearest = step.lens + slope * nearest,
                    at_furthest = step.lens + slope * furthest;
        scratch.may_meet[axis][k] = (std::fabs(at_nearest) <= within_nearest) |
                                    (std::fabs(at_furthest) <= within_furthest) |
                                    (std::fabs(step.lens) <= within_sheet) |
                                    (at_nearest * at_furthest < 0); // the centres meet between
    }
}

} // namespace integral
