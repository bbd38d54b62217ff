// SPDX-License-Identifier: AGPL-3.0-or-later
// The phases of blocks: light, waveform, lattice.
#include "integral/analysis/band_blocks.h"
#include "integral/analysis/least_squares.h"
#include "integral/base/constants.h"
#include "integral/base/interrupt.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

namespace integral {
namespace {

constexpr double two_pi = 2 * pi;

/// A linear fit of a few coefficients, equation by equation.
template <std::size_t terms> struct LinearFit {
    SquareMatrix normal{terms};
    std::vector<double> right = std::vector<double>(terms);

    void add(const std::array<double, terms>& row, double value, double weight = 1)
    {
        for (std::size_t i = 0; i < terms; ++i) {
            right[i] += weight * row[i] * value;
            for (std::size_t j = 0; j < terms; ++j)
                normal.at(i, j) += weight * row[i] * row[j];
        }
    }
    std::optional<std::vector<double>> solved() const { return solve_positive(normal, right); }
};

std::vector<double> phases_in(const BandBlock& block, const CalibrationLayout& layout,
                              const SheetView& view)
{
    std::vector<double> phases;
    for (const BandCell& cell : block.cells)
        phases.push_back(band_phase(view, layout.bands[cell.band], sight_of(view, cell.photo)));
    return phases;
}

} // namespace

void divide_by_light(std::vector<BandBlock>& blocks, const SheetView& view)
{
    constexpr std::size_t terms = 10;
    const auto row_at = [&](Vec2 photo) {
        const Vec2 p = 0.01 * sight_of(view, photo).film;
        return std::array<double, terms>{1,
                                         p.x,
                                         p.y,
                                         p.x * p.x,
                                         p.x * p.y,
                                         p.y * p.y,
                                         p.x * p.x * p.x,
                                         p.x * p.x * p.y,
                                         p.x * p.y * p.y,
                                         p.y * p.y * p.y};
    };
    LinearFit<terms> fit;
    for (std::size_t k = 0; k < terms; ++k)
        fit.normal.at(k, k) = 1e-6;
    for (const BandBlock& block : blocks) {
        if (block.kind != BandKind::beat)
            continue;
        double sum = 0, weights = 0;
        for (const BandCell& cell : block.cells) {
            sum += cell.weight * cell.light;
            weights += cell.weight;
        }
        fit.add(row_at(block.photo), sum / weights);
    }
    const auto surface = fit.solved();
    if (!surface)
        return;
    for (BandBlock& block : blocks)
        for (BandCell& cell : block.cells) {
            const auto row = row_at(cell.photo);
            double light = 0;
            for (std::size_t k = 0; k < terms; ++k)
                light += row[k] * (*surface)[k];
            cell.light /= std::max(light, 1e-9);
        }
}

std::optional<BlockPhase> phase_of(const BandBlock& block, const CalibrationLayout& layout,
                                   const SheetView& view)
{
    constexpr std::size_t orders = 4, terms = 2 * orders + 1;
    constexpr double least_span = 0.8, smooth = 1e-3;
    const std::vector<double> phases = phases_in(block, layout, view);
    const auto [low, high] = std::minmax_element(phases.begin(), phases.end());
    if (phases.size() < 2 * terms || *high - *low < least_span)
        return std::nullopt;
    const auto row_at = [](double phase) {
        std::array<double, terms> row{1};
        for (std::size_t h = 1; h <= orders; ++h) {
            row[2 * h - 1] = std::cos(two_pi * double(h) * phase);
            row[2 * h] = std::sin(two_pi * double(h) * phase);
        }
        return row;
    };
    LinearFit<terms> fit;
    for (std::size_t k = 3; k < terms; ++k) // what the phases do not determine is small
        fit.normal.at(k, k) = smooth * double(phases.size());
    for (std::size_t k = 0; k < phases.size(); ++k)
        fit.add(row_at(phases[k]), block.cells[k].light, block.cells[k].weight);
    const auto solved = fit.solved();
    if (!solved)
        return std::nullopt;
    BlockPhase found;
    found.mean = (*solved)[0];
    found.amplitude = std::hypot((*solved)[1], (*solved)[2]);
    found.difference = std::atan2(-(*solved)[2], (*solved)[1]) / two_pi;
    for (std::size_t k = 0; k < phases.size(); ++k) {
        const auto row = row_at(phases[k]);
        double off = block.cells[k].light;
        for (std::size_t i = 0; i < terms; ++i)
            off -= row[i] * (*solved)[i];
        found.residual += off * off;
    }
    found.residual = std::sqrt(found.residual / double(phases.size() - terms));
    return found;
}

void find_lattice(const std::vector<BandBlock>& blocks, const CalibrationLayout& layout,
                  SheetView& view)
{
    constexpr double pitch_range = 0.015, turn_range = 5 * radians_per_degree;
    struct Point {
        Vec2 lens; // from the middle, mm along and perpendicular to the view's angle
        std::complex<double> light;
    };
    const Vec2 across{std::cos(view.angle), std::sin(view.angle)};
    std::vector<Point> points;
    double power = 0;
    Vec2 extent{1, 1};
    for (const BandBlock& block : blocks) {
        if (block.kind != BandKind::beat)
            continue;
        double mean = 0;
        for (const BandCell& cell : block.cells)
            mean += cell.light / double(block.cells.size());
        for (const BandCell& cell : block.cells) {
            const Sight sight = sight_of(view, cell.photo);
            const double light = cell.light / std::max(mean, 1e-9) - 1;
            const Vec2 at{dot(across, sight.lens),
                          across.x * sight.lens.y - across.y * sight.lens.x};
            points.push_back(
                {at, light * std::polar(
                                 1.0, -two_pi * band_phase(view, layout.bands[cell.band], sight))});
            power += light * light;
            extent = {std::max(extent.x, std::fabs(at.x)), std::max(extent.y, std::fabs(at.y))};
        }
    }
    // The phase is that of the view minus `change` (cycles per mm) times the place, plus a
    // constant.
    const double step_x = 1 / (8 * extent.x), step_y = 1 / (8 * extent.y);
    const int most_x = int(pitch_range / view.pitch / step_x) + 1,
              most_y = int(std::sin(turn_range) / view.pitch / step_y) + 1;
    std::complex<double> best;
    Vec2 change;
    for (int j = -most_y; j <= most_y; ++j) {
        stop_if_interrupted();
        std::vector<std::complex<double>> sums(2 * most_x + 1);
        for (const Point& point : points) {
            std::complex<double> turned = point.light *
                                          std::polar(1.0,
                                                     two_pi * (j * step_y * point.lens.y -
                                                               most_x * step_x * point.lens.x));
            const std::complex<double> turn = std::polar(1.0, two_pi * step_x * point.lens.x);
            for (std::complex<double>& sum : sums) {
                sum += turned;
                turned *= turn;
            }
        }
        for (int i = 0; i <= 2 * most_x; ++i)
            if (std::abs(sums[i]) > std::abs(best)) {
                best = sums[i];
                change = {(i - most_x) * step_x, j * step_y};
            }
    }
    // Light that one wave makes has the sum sqrt(power * points / 2); noise, about sqrt(power).
    if (points.empty() || !(std::abs(best) > 0.3 * std::sqrt(power * double(points.size()) / 2)))
        throw std::invalid_argument(
            "the bands show no lens sheet of this pitch; lay the sheet on the bands, with its "
            "lenses in the direction of the page's lines, and give the options that the page was "
            "made with");
    const Vec2 along{-across.y, across.x};
    const Vec2 lattice = (1 / view.pitch + change.x) * across + change.y * along; // cycles per mm
    const double offset = view.phase / view.pitch + std::arg(best) / two_pi;
    view.pitch = 1 / length(lattice);
    view.angle = std::atan2(lattice.y, lattice.x);
    view.phase = offset * view.pitch;
}

} // namespace integral
