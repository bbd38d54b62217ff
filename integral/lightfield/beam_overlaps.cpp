// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/beam_overlaps.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace integral {

namespace {

constexpr float furthest_depth = 1e5; // mm; what is further away moves no differently

// Distances of patches, in patches, at which the narrow and the wide overlap end.
constexpr float narrow = 0.4f, wide = 0.8f;

constexpr float least_overlap = 0.02f; // less is not worth the time

int rounded(double x) { return int(std::lround(x)); }

int rounded(float x) { return int(x < 0 ? x - 0.5f : x + 0.5f); }

/// 1 at a distance of 0, 0 from `width` on.
inline float fall(float distance, float width)
{
    const float rest = 1 - distance * (1 / width);
    return rest > 0 ? rest : 0;
}

/// The two overlaps, narrow and wide, of patches that are that far apart at either depth.
inline std::array<float, 2> overlaps(float apart, float apart_at_other)
{
    const float a = std::fabs(apart), b = std::fabs(apart_at_other);
    return {fall(a, narrow) * fall(b, narrow), fall(a, wide) * fall(b, wide)};
}

} // namespace

BeamOverlaps::BeamOverlaps(const IntegralCamera& camera, const FirstSamples& first, int reach)
    : camera_(camera),
      first_(first),
      width_(camera.film.width),
      height_(camera.film.height),
      reach_(reach),
      pixels_across_(
          int(std::ceil(camera.optics.sheet().pitch /
                        std::min(camera.film.pixel_pitch.x, camera.film.pixel_pitch.y)))),
      pixels_beside_(pixels_across_ * 3 / 4 + 2)
{
    const Lattice& lattice = camera.optics.lattice();
    const Vec2 pixel = camera.film.pixel_pitch;
    const bool is_lenticular = lattice.arrangement() == Arrangement::lenticular;
    if (is_lenticular) {
        const Vec2 a = lattice.along(), b = lattice.across();
        Lines lines;
        lines.upright = std::fabs(a.y) >= std::fabs(a.x);
        const double height = pixel.x * std::fabs(a.x) + pixel.y * std::fabs(a.y);
        lines.pixel = pixel.x * std::fabs(b.x) + pixel.y * std::fabs(b.y);
        lines.pace = lines.upright ? pixel.x / a.y : pixel.y / a.x;
        lines.lean = float(lines.upright ? a.x * pixel.x / (a.y * pixel.y)
                                         : a.y * pixel.y / (a.x * pixel.x));
        lines.along = {float(pixel.x * a.x / height), float(-pixel.y * a.y / height)};
        lines.across = {float(pixel.x * b.x / lines.pace), float(-pixel.y * b.y / lines.pace)};
        lines_ = lines;
    }
    for (int row = 0; row < 2; ++row)
        for (int j = is_lenticular ? 0 : -1; j <= (is_lenticular ? 0 : 1); ++j)
            for (int i = -1; i <= 1; ++i) {
                Vec2 step = lattice.pole({i, row + j}) - lattice.pole({0, row});
                if (!(length(step) < 1.5 * lattice.pitch()))
                    continue;
                if (is_lenticular)
                    step = {dot(step, lattice.across()), 0};
                lenses_[row].push_back({i, j, step,
                                        rounded(step.x / (is_lenticular ? lines_->pace : pixel.x)),
                                        rounded(step.y / pixel.y)});
            }
}

/// `move`: how far the patch moves at either depth, relative to mm on the film. `pixel`: the
/// pixel's extent along the axis, `pace`: mm along it for a pixel of the way.
BeamOverlaps::Axis BeamOverlaps::axis(const AtDepths& move, double pixel, double pace) const
{
    Axis axis;
    for (int k = 0; k < depths; ++k) {
        const double patch = camera_.optics.sheet().pitch + std::fabs(move[k]) * pixel;
        axis.by_step[k] = float((1 - move[k]) / patch);
        axis.by_pixel[k] = float(move[k] * pace / patch);
        axis.pixels[k] = std::fabs(axis.by_pixel[k]) < 1e-6f ? 0 : 1 / axis.by_pixel[k];
    }
    return axis;
}

BeamOverlaps::Axes BeamOverlaps::axes(int x, int y) const
{
    const auto [nearest, furthest] = first_.depths_around(x, y);
    const LensSheet& sheet = camera_.optics.sheet();
    const Lattice& lattice = camera_.optics.lattice();
    const auto lens = *first_.lens(x, y);
    const Vec2 pole = lattice.pole({std::int16_t(lens[0]), std::int16_t(lens[1])}),
               pixel = camera_.film.pixel_pitch;
    Vec2 way = pole - film_from_pixel(camera_.film, {x + 0.5, y + 0.5});
    if (lines_)
        way = {dot(way, lattice.across()), 0};
    // The slope outside the sheet is n q/sqrt(1 - (n^2 - 1)q^2), q = way/thickness: its derivative.
    const double n = sheet.ior, m = n * n - 1;
    const Vec2 q = (1 / sheet.thickness) * way;
    const double rest = std::max(0.05, 1 - m * dot(q, q)),
                 steepness = n / sheet.thickness / std::sqrt(rest);
    const auto moves = [&](double q) {
        const double slope = steepness * (1 + m * q * q / rest);
        return AtDepths{float(std::clamp(nearest, -furthest_depth, furthest_depth) * slope),
                        float(std::clamp(furthest, -furthest_depth, furthest_depth) * slope)};
    };
    if (lines_)
        return {axis(moves(q.x), lines_->pixel, lines_->pace)};
    // The ray from the aperture's centre through the pole meets the middle of the lens's pixels.
    const Vec2 middle = way + (sheet.thickness / (n * camera_.optics.aperture().distance)) * pole;
    const auto pixels = [&](double mm, double pixel) {
        return int(std::clamp(mm / pixel, -double(pixels_beside_), double(pixels_beside_)));
    };
    return {axis(moves(q.x), pixel.x, pixel.x), axis(moves(q.y), pixel.y, pixel.y),
            pixels(middle.x, pixel.x), pixels(middle.y, pixel.y)};
}

BeamOverlaps::AtDepths BeamOverlaps::start(const Axis& axis, double step)
{
    return {axis.by_step[0] * float(step), axis.by_step[1] * float(step)};
}

/// The pixels m of the way, at most `reach` away from `middle`, for which patches overlap at
/// both depths.
BeamOverlaps::Range BeamOverlaps::range(const Axis& axis, const AtDepths& start, int middle,
                                        int reach) const
{
    float low = float(middle - reach), high = float(middle + reach);
    for (int k = 0; k < depths; ++k) {
        if (axis.pixels[k] == 0) {
            if (std::fabs(start[k]) >= wide)
                return {0, -1};
            continue;
        }
        const float at = -start[k] * axis.pixels[k], apart = wide * std::fabs(axis.pixels[k]);
        low = low > at - apart ? low : at - apart;
        high = high < at + apart ? high : at + apart;
    }
    const int first = int(low), last = int(high); // to 0: upwards or downwards
    return {first + (float(first) < low), last - (float(last) > high)};
}

void BeamOverlaps::find(int x, int y, Found& found) const
{
    const auto own = *first_.lens(x, y);
    const Axes at = axes(x, y);
    found.number_ = 0;
    for (const Lens& lens : lenses_[own[1] & 1]) {
        const FirstSamples::StoredLens other = {std::uint16_t(own[0] + lens.i),
                                                std::uint16_t(own[1] + lens.j)};
        if (lines_)
            find_behind_line(x, y, at.x, lens, other, found);
        else
            find_behind_lens(x, y, at, lens, other, found);
    }
}

void BeamOverlaps::find_behind_lens(int x, int y, const Axes& axes, const Lens& lens,
                                    FirstSamples::StoredLens other, Found& found) const
{
    // Pixels that are m to the right and n up.
    const AtDepths start_x = start(axes.x, lens.step.x), start_y = start(axes.y, lens.step.y);
    const Range right = range(axes.x, start_x, axes.right + lens.right, pixels_beside_),
                up = range(axes.y, start_y, axes.up + lens.up, pixels_beside_);
    const int m0 = std::max(right.first, -x), m1 = std::min(right.last, width_ - 1 - x),
              n0 = std::max({up.first, -reach_, y - height_ + 1}),
              n1 = std::min({up.last, reach_, y}), columns = m1 - m0 + 1;
    if (columns <= 0 || n0 > n1)
        return;
    found.columns_.resize(columns);
    for (int m = m0; m <= m1; ++m)
        found.columns_[m - m0] = overlaps(start_x[0] + m * axes.x.by_pixel[0],
                                          start_x[1] + m * axes.x.by_pixel[1]);
    const std::size_t room = found.number_ + std::size_t(columns) * (n1 - n0 + 1);
    if (found.overlaps_.size() < room)
        found.overlaps_.resize(room);
    Overlap* next = found.overlaps_.data() + found.number_;
    for (int n = n0; n <= n1; ++n) {
        const auto row = overlaps(start_y[0] + n * axes.y.by_pixel[0],
                                  start_y[1] + n * axes.y.by_pixel[1]);
        if (row[1] < least_overlap)
            continue;
        std::uint32_t pixel = std::uint32_t(y - n) * width_ + (x + m0);
        for (const auto& column : found.columns_) {
            const float overlap = row[1] * column[1];
            if (overlap >= least_overlap && first_.is_behind(pixel, other))
                *next++ = {pixel, row[0] * column[0], overlap};
            ++pixel;
        }
    }
    found.number_ = next - found.overlaps_.data();
}

void BeamOverlaps::find_behind_line(int x, int y, const Axis& axis, const Lens& lens,
                                    FirstSamples::StoredLens other, Found& found) const
{
    // Along the line a pixel's beam overlaps with those of pixels less than its own height away.
    const AtDepths apart = start(axis, lens.step.x);
    const Range way = range(axis, apart, lens.right, pixels_across_);
    for (int m = way.first - 1; m <= way.last + 1; ++m) {
        const int straight = rounded(float(m) * lines_->lean);
        for (int rest = straight - 1; rest <= straight + 1; ++rest) {
            const int right = lines_->upright ? m : rest, down = lines_->upright ? rest : m;
            const float along = std::fabs(right * lines_->along[0] + down * lines_->along[1]);
            if (along >= wide || std::abs(down) > reach_ ||
                !first_.is_behind(x + right, y + down, other))
                continue;
            const float place = right * lines_->across[0] + down * lines_->across[1];
            const auto both = overlaps(apart[0] + place * axis.by_pixel[0],
                                       apart[1] + place * axis.by_pixel[1]);
            const Overlap overlap = {std::uint32_t(y + down) * width_ + (x + right),
                                     fall(along, narrow) * both[0], fall(along, wide) * both[1]};
            if (overlap.wide < least_overlap)
                continue;
            if (found.overlaps_.size() == found.number_)
                found.overlaps_.resize(2 * found.number_ + 16);
            found.overlaps_[found.number_++] = overlap;
        }
    }
}

} // namespace integral
