// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/sheet_calibration.h"

#include "integral/analysis/calibration_fit.h"
#include "integral/analysis/calibration_light.h"
#include "integral/analysis/page_code.h"
#include "integral/base/constants.h"
#include "integral/optics/visual_pitch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

std::vector<PhasePoint> phase_points(const std::vector<BandBlock>& blocks,
                                     const CalibrationLayout& layout, const SheetView& view,
                                     const SheetCover& cover)
{
    constexpr double least_contrast = 0.2; // of coarse lines
    std::vector<PhasePoint> points;
    const auto add = [&](const BandBlock& block, double difference) {
        const CalibrationBand& band = layout.bands[block.cells[0].band];
        points.push_back(
            {band, block.photo, band_phase(view, band, sight_of(view, block.photo)) + difference});
    };
    for (const MeasuredBlock& one : cover.blocks())
        add(*one.first, one.second.difference);
    for (const BandBlock& block : blocks) {
        if (block.kind != BandKind::coarse || !cover.covers(block))
            continue;
        const auto phase = phase_of(block, layout, view);
        if (phase && phase->amplitude > least_contrast * phase->mean)
            add(block, phase->difference);
    }
    return points;
}

Estimate estimate_of(double value, const CalibrationFit& fit, std::size_t parameter, double unit)
{
    return {value, unit * std::sqrt(std::max(0.0, fit.covariance.at(parameter, parameter)))};
}

/// An angle between the lenses and their nominal direction, -90 to 90 degrees.
double turn_from(double angle, double nominal)
{
    double turn = (angle - nominal) / radians_per_degree;
    return turn - 180 * std::round(turn / 180);
}

/// Throws std::invalid_argument if the photo contradicts the page or the sheet that it is read as.
void check_fit(const CalibrationFit& fit, const CalibrationLight& light)
{
    constexpr double max_corner_residual = 1;    // pixels; 0.1 to 0.3 where all is right
    constexpr double max_phase_residual = 0.015; // periods; up to 0.005 where all is right
    constexpr double max_coarse_residual = 0.03; // periods; up to 0.011 where all is right
    constexpr double min_own = 0.5;              // share of light; 0.17 on a false lattice
    if (!(fit.corner_residual < max_corner_residual))
        throw std::invalid_argument("its squares are not where this page has them; give the "
                                    "options that the page was made with, which its heading has");
    if (!(fit.coarse_residual < max_coarse_residual && fit.phase_residual < max_phase_residual))
        throw std::invalid_argument("its bands are not where this page has them; give the "
                                    "options that the page was made with, which its heading has");
    if (light.leak_known && light.own.value < min_own)
        throw std::invalid_argument("its fine lines do not stand behind the lenses as this page's "
                                    "do; turn the sheet along them to less than 5 degrees, and "
                                    "give the page's own options");
}

} // namespace

SheetCalibration calibrate_sheet(const Plane& photo, const CalibrationPage& page, int threads)
{
    constexpr int rounds = 4;
    constexpr std::size_t least_blocks = 8;
    const LensSheet& sheet = page.sheet;
    const CalibrationLayout layout = calibration_layout(page);
    std::array<Vec2, 4> targets;
    for (int k = 0; k < 4; ++k)
        targets[k] = layout.targets[k].middle;
    const PageView seen = find_page(photo, targets, layout.corners);
    check_page_code(photo, seen.camera, layout.code);

    SheetPrior prior;
    prior.thickness = sheet.thickness;
    prior.ior = sheet.ior;
    prior.surface = surface_effect(sheet);
    const Vec2 wave = chart_directions(sheet)[0].wave;
    SheetView view;
    view.camera = seen.camera;
    view.pitch = sheet.pitch;
    view.angle = std::atan2(wave.y, wave.x);
    set_lenses(prior, std::vector<double>(fit_parameters), view);
    const double expected = effective_reach(view), coma = prior.surface.beat[0],
                 surface = prior.surface_error * coma / (1 + coma);
    const auto measure = [&] {
        std::vector<BandBlock> all = measure_blocks(photo, page, layout, view, threads);
        divide_by_light(all, view);
        return all;
    };
    std::vector<BandBlock> blocks = measure();
    find_lattice(blocks, layout, view);

    CalibrationFit fit;
    const Vec2 size{double(photo.width), double(photo.height)};
    for (int round = 0; round < rounds; ++round) {
        if (round == 2) // the film is now known better
            blocks = measure();
        const SheetCover cover(blocks, layout, view);
        if (cover.blocks().size() < least_blocks)
            throw std::invalid_argument("too few bands lie under the sheet; lay the sheet on more "
                                        "of them, flat");
        fit = fit_calibration(view, seen.corners, phase_points(blocks, layout, view, cover), prior,
                              size);
        view = fit.view;
    }

    SheetCalibration found;
    view.phase -= view.pitch * std::round(view.phase / view.pitch);
    found.view = view;
    found.pitch = estimate_of(view.pitch, fit, pitch_parameter, view.pitch);
    found.turn = estimate_of(turn_from(view.angle, std::atan2(wave.y, wave.x)), fit,
                             angle_parameter, 1 / radians_per_degree);
    found.phase = estimate_of(view.phase, fit, phase_parameter, 1);
    found.thickness_over_index = fit.reach;
    found.expected_thickness_over_index = {
        expected, expected * std::hypot(prior.thickness_error, prior.ior_error, surface)};
    found.distance = {view.camera.place.z - view.thickness,
                      std::sqrt(std::max(0.0, fit.covariance.at(5, 5)))};
    found.corners = int(seen.corners.size());
    found.corners_of = int(layout.corners.size());
    const SheetCover cover(blocks, layout, view);
    found.blocks = int(cover.blocks().size());
    found.blocks_of = int(std::count_if(blocks.begin(), blocks.end(), [](const BandBlock& block) {
        return block.kind == BandKind::beat;
    }));
    found.corner_residual = fit.corner_residual;
    found.phase_residual = fit.phase_residual;
    found.light = calibration_light(blocks, layout, view, cover);
    check_fit(fit, found.light);
    return found;
}

} // namespace integral
