// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace integral {

namespace {

// Distances of patches at which their weight ends, in widths of a patch: of the two candidates for
// the first estimate; the last step uses the wide one. A smaller overlap is not worth the time.
constexpr float narrow = 0.4f, wide = 0.8f, least_overlap = 0.02f;

// The expected squared error, divided by what the variance of the samples says, where nothing else
// is known, and the number of pixels as which that counts. Found by trying on sample scenes of
// POV-Ray's.
constexpr float usual_excess = 3, weight_of_usual = 8;

constexpr double furthest_depth = 1e5; // mm; what is further away moves no differently

float fall(float distance, float width) { return std::max(0.0f, 1 - distance / width); }

/// The overlap of two patches whose centres are start + m*pace patches apart at either depth, as
/// long as they are less than `width` apart; 1 for the same patch.
inline float overlap(const std::array<float, 2>& start, const std::array<float, 2>& pace, float m,
                     float width)
{
    return fall(std::fabs(start[0] + m * pace[0]), width) *
           fall(std::fabs(start[1] + m * pace[1]), width);
}

/// About exp(-x) for x >= 0; 0 from 8 on.
float fall_off(float x)
{
    float power = std::max(0.0f, 1 - x / 8);
    power *= power;
    power *= power;
    return power * power;
}

float squared_difference(const StoredColour& a, const StoredColour& b)
{
    float sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const float difference = float(int(a[k]) - int(b[k]));
        sum += difference * difference;
    }
    return sum * float(1 / (colour_levels * colour_levels));
}

/// A weighted mean of colours.
struct Sum {
    std::array<float, 4> colour{};
    float weights = 0;
    void add(const StoredColour& other, float weight)
    {
        weights += weight;
        for (std::size_t k = 0; k < colour.size(); ++k)
            colour[k] += weight * other[k];
    }
    StoredColour mean() const
    {
        StoredColour mean;
        for (std::size_t k = 0; k < mean.size(); ++k)
            mean[k] = std::uint16_t(colour[k] / weights + 0.5f);
        return mean;
    }
};

} // namespace

int rows_compared(const LensSheet& sheet, const Film& film)
{
    return std::max(rows_looked_at(sheet, film), Reconstruction::risk_reach);
}

int rows_reconstructed_from(const LensSheet& sheet, const Film& film)
{
    return 2 * rows_compared(sheet, film) + Reconstruction::risk_reach;
}

int rows_antialiased_from(const LensSheet& sheet, const Film& film, int block_side)
{
    const int blocks = (rows_reconstructed_from(sheet, film) + block_side - 1) / block_side;
    return blocks * block_side + rows_looked_at(sheet, film);
}

bool Reconstruction::possible(const Film& film) { return film.subpixels.order == Subpixels::none; }

std::size_t Reconstruction::bytes(const Film& film)
{
    return bytes_a_pixel * film.width * film.height;
}

Reconstruction::Reconstruction(const IntegralCamera& camera, const FirstSamples& first,
                               double least_error, std::shared_ptr<void> memory)
    : camera_(camera),
      first_(first),
      width_(camera.film.width),
      height_(camera.film.height),
      reach_(rows_compared(camera.optics.sheet(), camera.film)),
      pixels_across_(
          int(std::ceil(camera.optics.sheet().pitch /
                        std::min(camera.film.pixel_pitch.x, camera.film.pixel_pitch.y)))),
      least_variance_(float(3 * least_error * least_error)),
      memory_(memory ? std::move(memory) : zeroed_memory(bytes(camera.film))),
      pixels_(static_cast<Pixel*>(memory_.get()))
{
    const Lattice& lattice = camera.optics.lattice();
    const bool lines = lattice.arrangement() == Arrangement::lenticular;
    for (int row = 0; row < 2; ++row)
        for (int j = lines ? 0 : -1; j <= (lines ? 0 : 1); ++j)
            for (int i = -1; i <= 1; ++i) {
                const Vec2 step = lattice.pole({i, row + j}) - lattice.pole({0, row});
                if (length(step) < 1.5 * lattice.pitch())
                    lenses_[row].push_back({i, j, step});
            }
}

void Reconstruction::set(int x, int y, const ComparedColour& mean, double variance,
                         double of_halves)
{
    Pixel& pixel = pixels_[index(x, y)];
    pixel.mean = stored_colour(mean);
    const bool clamped = *std::max_element(pixel.mean.begin(), pixel.mean.end()) == 65535;
    pixel.variance = clamped || !(variance >= 0) ? -1 : float(variance);
    pixel.of_halves = float(of_halves);
}

/// Calls visit(x, y) for the pixels behind the same lens at most `reach` pixels away, itself
/// included.
template <class Visit>
void Reconstruction::for_each_around(int x, int y, int reach, Visit visit) const
{
    const auto lens = *first_.lens(x, y);
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i)
            if (first_.is_behind(x + i, y + j, lens))
                visit(x + i, y + j);
}

/// The mean variance of the pixel and those beside it, times how much more the halves of the
/// samples around differ than their variance lets expect.
float Reconstruction::smooth_variance(int x, int y) const
{
    float near_sum = 0, expected = 0, seen = 0;
    int near_number = 0, number = 0;
    for_each_around(x, y, risk_reach, [&](int i, int j) {
        const Pixel& other = pixels_[index(i, j)];
        const float variance = std::max<float>(0, other.variance), of_halves = other.of_halves;
        if (std::abs(i - x) <= 1 && std::abs(j - y) <= 1) {
            near_sum += variance;
            ++near_number;
        }
        if (of_halves >= 0) {
            expected += variance;
            seen += of_halves;
            ++number;
        }
    });
    const float mean = near_sum / near_number;
    if (!(expected > 0))
        return usual_excess * mean;
    const float weight = weight_of_usual * expected / number;
    return mean * (seen + usual_excess * weight) / (expected + weight);
}

/// The patches of a pixel's beam at the least and the greatest depth that it and its neighbours
/// show.
std::array<Reconstruction::Patch, 2> Reconstruction::patches(int x, int y) const
{
    double nearest = first_.depth(x, y), furthest = nearest;
    first_.for_each_neighbour(x, y, [&](int i, int j) {
        nearest = std::min(nearest, first_.depth(i, j));
        furthest = std::max(furthest, first_.depth(i, j));
    });
    const LensSheet& sheet = camera_.optics.sheet();
    const Lattice& lattice = camera_.optics.lattice();
    const auto lens = *first_.lens(x, y);
    const Vec2 pole = lattice.pole({std::int16_t(lens[0]), std::int16_t(lens[1])});
    Vec2 way = pole - film_from_pixel(camera_.film, {x + 0.5, y + 0.5});
    Vec2 pixel = camera_.film.pixel_pitch;
    const bool lines = lattice.arrangement() == Arrangement::lenticular;
    if (lines) {
        const Vec2 across = lattice.across();
        way = {dot(way, across), 0};
        pixel.x = pixel.x * std::fabs(across.x) + pixel.y * std::fabs(across.y);
    }
    // The slope outside the sheet is n q/sqrt(1 - (n^2 - 1)q^2), q = way/thickness: its derivative.
    const double n = sheet.ior, m = n * n - 1;
    const Vec2 q = (1 / sheet.thickness) * way;
    const double rest = std::max(0.05, 1 - m * dot(q, q));
    const Vec2 slope = (n / sheet.thickness / std::sqrt(rest)) *
                       Vec2{1 + m * q.x * q.x / rest, 1 + m * q.y * q.y / rest};
    std::array<Patch, 2> result;
    for (int k = 0; k < 2; ++k) {
        const double depth = std::clamp(k == 0 ? nearest : furthest, -furthest_depth,
                                        furthest_depth);
        result[k].move = depth * slope;
        result[k].inverse_width = {1 / (sheet.pitch + std::fabs(result[k].move.x) * pixel.x),
                                   1 / (sheet.pitch + std::fabs(result[k].move.y) * pixel.y)};
    }
    return result;
}

/// The range of whole numbers m, at most a lens away from `centre`, for which start + m*pace is
/// less than `width`, at both depths.
std::array<int, 2> Reconstruction::range(const Apart& start, const Apart& pace, float width,
                                         int centre) const
{
    float low = float(centre - pixels_across_), high = float(centre + pixels_across_);
    for (int k = 0; k < 2; ++k) {
        if (std::fabs(pace[k]) < 1e-6f) {
            if (std::fabs(start[k]) >= width)
                return {0, -1};
            continue;
        }
        const float a = (-width - start[k]) / pace[k], b = (width - start[k]) / pace[k];
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
    }
    return {int(std::ceil(low)), int(std::floor(high))};
}

template <std::size_t N, class Visit>
void Reconstruction::for_each_overlap(int x, int y, const std::array<float, N>& widths,
                                      Scratch& scratch, Visit visit) const
{
    const auto own = *first_.lens(x, y);
    const auto at_depths = patches(x, y);
    const auto visit_usable = [&](const Pixel& other, const std::array<float, N>& overlaps) {
        if (other.variance >= 0)
            visit(other, overlaps);
    };
    for (const Lens& lens : lenses_[own[1] & 1]) {
        const FirstSamples::StoredLens other = {std::uint16_t(own[0] + lens.i),
                                                std::uint16_t(own[1] + lens.j)};
        if (camera_.optics.lattice().arrangement() == Arrangement::lenticular)
            visit_line(x, y, at_depths, lens, other, widths, visit_usable);
        else
            visit_lens(x, y, at_depths, lens, other, widths, scratch, visit_usable);
    }
}

template <std::size_t N, class Visit>
void Reconstruction::visit_lens(int x, int y, const std::array<Patch, 2>& at, const Lens& lens,
                                FirstSamples::StoredLens other, const std::array<float, N>& widths,
                                Scratch& scratch, Visit visit) const
{
    // How far apart the patches are, in patches, for a pixel that is (m, -n) pixels away.
    const Vec2 pixel = camera_.film.pixel_pitch;
    Apart start_x, start_y, pace_x, pace_y;
    for (int k = 0; k < 2; ++k) {
        start_x[k] = float(lens.step.x * (1 - at[k].move.x) * at[k].inverse_width.x);
        start_y[k] = float(lens.step.y * (1 - at[k].move.y) * at[k].inverse_width.y);
        pace_x[k] = float(at[k].move.x * pixel.x * at[k].inverse_width.x);
        pace_y[k] = float(at[k].move.y * pixel.y * at[k].inverse_width.y);
    }
    auto across = range(start_x, pace_x, widths[N - 1], int(std::lround(lens.step.x / pixel.x)));
    auto up = range(start_y, pace_y, widths[N - 1], int(std::lround(lens.step.y / pixel.y)));
    across = {std::max(across[0], -x), std::min(across[1], width_ - 1 - x)};
    up = {std::max({up[0], -reach_, y - height_ + 1}), std::min({up[1], reach_, y})};
    scratch.clear();
    for (int m = across[0]; m <= across[1]; ++m)
        for (const float width : widths)
            scratch.push_back(overlap(start_x, pace_x, m, width));
    for (int n = up[0]; n <= up[1]; ++n) {
        std::array<float, N> row, overlaps;
        for (std::size_t k = 0; k < N; ++k)
            row[k] = overlap(start_y, pace_y, n, widths[k]);
        const std::size_t begin = index(x + across[0], y - n);
        for (int m = 0; m <= across[1] - across[0]; ++m) {
            for (std::size_t k = 0; k < N; ++k)
                overlaps[k] = row[k] * scratch[N * m + k];
            if (overlaps[N - 1] >= least_overlap && first_.is_behind(begin + m, other))
                visit(pixels_[begin + m], overlaps);
        }
    }
}

template <std::size_t N, class Visit>
void Reconstruction::visit_line(int x, int y, const std::array<Patch, 2>& at, const Lens& lens,
                                FirstSamples::StoredLens other, const std::array<float, N>& widths,
                                Visit visit) const
{
    // Along the line a pixel's beam overlaps with those of pixels less than its own height away.
    const Lattice& lattice = camera_.optics.lattice();
    const Vec2 pixel = camera_.film.pixel_pitch, a = lattice.along(), b = lattice.across();
    const bool upright = std::fabs(a.y) >= std::fabs(a.x);
    const double height = pixel.x * std::fabs(a.x) + pixel.y * std::fabs(a.y);
    const double step = dot(lens.step, b);
    // While m pixels are gone along the film's axis that crosses the lines: mm across a line, and
    // the pixels gone along the other axis if the way leads straight across.
    const double pace = upright ? pixel.x / a.y : pixel.y / a.x;
    const double lean = upright ? a.x * pixel.x / (a.y * pixel.y) : a.y * pixel.y / (a.x * pixel.x);
    Apart start, paces;
    for (int k = 0; k < 2; ++k) {
        start[k] = float(step * (1 - at[k].move.x) * at[k].inverse_width.x);
        paces[k] = float(at[k].move.x * pace * at[k].inverse_width.x);
    }
    const auto gone = range(start, paces, widths[N - 1], int(std::lround(step / pace)));
    for (int m = gone[0] - 1; m <= gone[1] + 1; ++m)
        for (int k = -1; k <= 1; ++k) {
            const int rest = int(std::lround(m * lean)) + k;
            const int dx = upright ? m : rest, dy = upright ? rest : m; // dy: downwards
            const Vec2 film{dx * pixel.x, -dy * pixel.y};
            const float along = float(std::fabs(dot(film, a)) / height);
            if (along >= widths[N - 1] || std::abs(dy) > reach_ ||
                !first_.is_behind(x + dx, y + dy, other))
                continue;
            const float place = float(dot(film, b) / pace); // pixels, with a fraction
            std::array<float, N> overlaps;
            for (std::size_t w = 0; w < N; ++w)
                overlaps[w] = fall(along, widths[w]) * overlap(start, paces, place, widths[w]);
            if (overlaps[N - 1] >= least_overlap)
                visit(pixels_[index(x + dx, y + dy)], overlaps);
        }
}

Reconstruction::Trial Reconstruction::trial(int x, int y, Scratch& scratch) const
{
    Trial result;
    const Pixel& own = pixels_[index(x, y)];
    const float variance = smooth_variance(x, y);
    if (own.variance < 0 || variance < least_variance_)
        return result;
    result.any = true;
    result.own_risk = variance;
    std::array<Sum, 2> sums;
    for_each_overlap(x, y, std::array<float, 2>{narrow, wide}, scratch,
                     [&](const Pixel& other, const std::array<float, 2>& overlaps) {
                         for (int k = 0; k < 2; ++k)
                             sums[k].add(other.mean, overlaps[k]);
                     });
    for (int k = 0; k < 2; ++k) {
        result.colours[k] = sums[k].mean();
        result.risks[k] = squared_difference(result.colours[k], own.mean) - variance +
                          2 * variance / sums[k].weights; // own overlap is 1
    }
    return result;
}

void Reconstruction::estimate(int left, int top, int right, int bottom)
{
    const int x0 = std::max(0, left - risk_reach), y0 = std::max(0, top - risk_reach),
              x1 = std::min(width_ - 1, right + risk_reach),
              y1 = std::min(height_ - 1, bottom + risk_reach);
    std::vector<Trial> trials(std::size_t(x1 - x0 + 1) * (y1 - y0 + 1));
    const auto trial_at = [&](int x, int y) -> Trial& {
        return trials[std::size_t(y - y0) * (x1 - x0 + 1) + (x - x0)];
    };
    Scratch scratch;
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
            if (first_.lens(x, y))
                trial_at(x, y) = trial(x, y, scratch);
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x) {
            Pixel& pixel = pixels_[index(x, y)];
            pixel.estimate = pixel.mean;
            const Trial& own = trial_at(x, y);
            if (!own.any)
                continue;
            float least = 0;
            std::array<float, 2> risks{};
            for_each_around(x, y, risk_reach, [&](int i, int j) {
                const Trial& other = trial_at(i, j);
                least += other.own_risk;
                for (int k = 0; k < 2; ++k)
                    risks[k] += other.risks[k];
            });
            for (int k = 0; k < 2; ++k)
                if (risks[k] < least) {
                    least = risks[k];
                    pixel.estimate = own.colours[k];
                }
        }
}

std::optional<ComparedColour> Reconstruction::reconstructed(int x, int y, Scratch& scratch) const
{
    const Pixel& own = pixels_[index(x, y)];
    if (!first_.lens(x, y) || own.variance < 0)
        return {};
    const float variance = smooth_variance(x, y);
    if (variance < least_variance_)
        return {};
    Sum sum;
    for_each_overlap(x, y, std::array<float, 1>{wide}, scratch,
                     [&](const Pixel& other, const std::array<float, 1>& overlap) {
                         const float likeness = fall_off(
                             squared_difference(other.estimate, own.estimate) / variance);
                         sum.add(other.mean, overlap[0] * likeness);
                     });
    return colour_of(sum.mean());
}

} // namespace integral
