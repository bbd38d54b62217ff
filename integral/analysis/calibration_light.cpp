// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/calibration_light.h"

#include "integral/analysis/least_squares.h"
#include "integral/base/constants.h"

#include <algorithm>
#include <cmath>

namespace integral {

SheetCover::SheetCover(const std::vector<BandBlock>& blocks, const CalibrationLayout& layout,
                       const SheetView& view)
    : view_(view), upright_(layout.bands.front().upright), groups_(layout.groups)
{
    constexpr double least_share = 0.4, most_residual = 0.4, most_residuals = 2; // of the median's
    std::vector<MeasuredBlock> all;
    std::vector<double> contrasts, residuals;
    for (const BandBlock& block : blocks)
        if (block.kind == BandKind::beat)
            if (const auto phase = phase_of(block, layout, view)) {
                all.push_back({&block, *phase});
                contrasts.push_back(phase->amplitude / std::max(1e-9, phase->mean));
                residuals.push_back(phase->residual / std::max(1e-9, phase->amplitude));
            }
    if (all.empty())
        return;
    const std::size_t ninth = contrasts.size() * 9 / 10;
    std::nth_element(contrasts.begin(), contrasts.begin() + ninth, contrasts.end());
    const double least = least_share * contrasts[ninth];
    std::nth_element(residuals.begin(), residuals.begin() + residuals.size() / 2, residuals.end());
    const double most = std::min(most_residual, most_residuals * residuals[residuals.size() / 2]);
    std::map<int, std::vector<MeasuredBlock>> groups;
    for (const MeasuredBlock& one : all) {
        const BlockPhase& phase = one.second;
        if (phase.amplitude > least * phase.mean && phase.residual < most * phase.amplitude)
            groups[one.first->group].push_back(one);
    }
    // The outermost blocks of a group may lie across the sheet's edge; their middles do not.
    for (const auto& [group, found] : groups)
        if (found.size() > 2) {
            blocks_.insert(blocks_.end(), found.begin() + 1, found.end() - 1);
            const double a = along(found.front().first->photo),
                         b = along(found.back().first->photo);
            ends_[group] = {std::min(a, b), std::max(a, b)};
        }
}

double SheetCover::along(Vec2 photo) const
{
    const Vec2 film = sight_of(view_, photo).film;
    return upright_ ? film.y : film.x;
}

bool SheetCover::has(int group, double at) const
{
    const auto found = ends_.find(group);
    return found != ends_.end() && at > found->second.low && at < found->second.high;
}

bool SheetCover::covers(const BandBlock& block) const
{
    const double at = along(block.photo);
    const bool leak = block.kind == BandKind::leak || block.kind == BandKind::tint;
    // A coarse band lies between its own group and the next one, which may be a leak group.
    const int above = leak ? block.group - 1 : block.group;
    int below = block.group + 1;
    if (!leak && !ends_.count(below) && below + 1 < groups_)
        ++below;
    return has(above, at) && has(below, at);
}

namespace {

/// Mean and its standard deviation, from the scatter of independent values.
Estimate mean_of(const std::vector<double>& values)
{
    Estimate estimate;
    for (const double value : values)
        estimate.value += value / double(values.size());
    double sum = 0;
    for (const double value : values)
        sum += (value - estimate.value) * (value - estimate.value);
    if (values.size() > 1)
        estimate.deviation = std::sqrt(sum / double(values.size() * (values.size() - 1)));
    return estimate;
}

/// Light of narrow lines at a phase.
struct LeakPoint {
    double phase, light; ///< light: 0 black, 1 white
    int part;            ///< of the page
};

constexpr int leak_parts = 8, steps_of_pitch = int(1 / leak_line + 0.5);
using Shares = std::array<double, 3>; ///< own, left, right

/// The shares from a Fourier series through the points, without the points of one part.
std::optional<Shares> shares_without(const std::vector<LeakPoint>& points, int part)
{
    constexpr int orders = 6, terms = 2 * orders + 1;
    constexpr double smooth = 1e-4;
    SquareMatrix normal(terms);
    std::vector<double> right(terms);
    const auto row_at = [](double phase) {
        std::array<double, terms> row{1};
        for (int h = 1; h <= orders; ++h) {
            row[2 * h - 1] = std::cos(2 * pi * h * phase);
            row[2 * h] = std::sin(2 * pi * h * phase);
        }
        return row;
    };
    double number = 0;
    for (const LeakPoint& point : points) {
        if (point.part == part)
            continue;
        ++number;
        const auto row = row_at(point.phase);
        for (int i = 0; i < terms; ++i) {
            right[i] += row[i] * point.light;
            for (int j = 0; j < terms; ++j)
                normal.at(i, j) += row[i] * row[j];
        }
    }
    for (int i = 1; i < terms; ++i) // orders that the phases do not determine are small
        normal.at(i, i) += smooth * number * std::pow((i + 1) / 2, 4) / 16;
    const auto solved = solve_positive(normal, right);
    if (!solved || number < 4 * terms)
        return std::nullopt;
    std::array<double, steps_of_pitch> steps{};
    double sum = 0;
    for (int k = 0; k < steps_of_pitch; ++k) {
        const auto row = row_at(k * leak_line);
        for (int i = 0; i < terms; ++i)
            steps[k] += row[i] * (*solved)[i];
        sum += steps[k];
    }
    if (!(sum > 0))
        return std::nullopt;
    // An eye at phase k/6 sees, of a line at phase 0, the light that leaks by that much. Phase
    // grows with the line's place against the lens.
    return Shares{steps[0] / sum, steps[1] / sum, steps[steps_of_pitch - 1] / sum};
}

void measure_leak(const std::vector<LeakPoint>& points, CalibrationLight& found)
{
    const auto all = shares_without(points, -1);
    if (!all)
        return;
    Estimate* const estimates[] = {&found.own, &found.left, &found.right};
    Shares squares{};
    for (int part = 0; part < leak_parts; ++part) {
        const auto without = shares_without(points, part);
        if (!without)
            return;
        for (int k = 0; k < 3; ++k)
            squares[k] += ((*without)[k] - (*all)[k]) * ((*without)[k] - (*all)[k]);
    }
    for (int k = 0; k < 3; ++k)
        *estimates[k] = {(*all)[k], std::sqrt(squares[k] * (leak_parts - 1) / leak_parts)};
    found.leak_known = true;
}

} // namespace

CalibrationLight calibration_light(const std::vector<BandBlock>& blocks,
                                   const CalibrationLayout& layout, const SheetView& view,
                                   const SheetCover& cover)
{
    CalibrationLight found;
    // Light of the tints, white first.
    std::map<double, std::vector<double>, std::greater<double>> tints;
    for (const BandBlock& block : blocks)
        if (block.kind == BandKind::tint && cover.covers(block))
            tints[layout.bands[block.cells[0].band].light_share].push_back(block.cells[0].light);
    if (tints.size() < 5)
        return found;
    const double white = mean_of(tints[1]).value, black = mean_of(tints[0]).value;
    if (!(white - black > 0.05 * std::fabs(white)))
        return found;
    constexpr double tolerance = 0.06; // of the area, by which fine lines may look lighter
    for (int k = 0; k < 3; ++k) {
        std::vector<double> coverage;
        for (const double light : tints[0.75 - 0.25 * k])
            coverage.push_back((white - light) / (white - black));
        found.coverage[k] = mean_of(coverage);
        if (found.coverage[k].value < 0.25 * (k + 1) - tolerance)
            found.too_light = true;
    }
    found.coverage_known = !found.too_light;
    std::vector<double> contrasts;
    for (const MeasuredBlock& one : cover.blocks())
        contrasts.push_back(one.second.amplitude / (white - black) * pi / 2);
    found.contrast = mean_of(contrasts);
    std::vector<LeakPoint> points;
    for (const BandBlock& block : blocks) {
        if (block.kind != BandKind::leak || !cover.covers(block))
            continue;
        for (const BandCell& cell : block.cells)
            points.push_back({band_phase(view, layout.bands[cell.band], sight_of(view, cell.photo)),
                              (cell.light - black) / (white - black), block.column % leak_parts});
    }
    measure_leak(points, found);
    if (found.too_light && found.own.value >= 0.5)
        found.leak_known = false;
    return found;
}

} // namespace integral
