// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/calibration_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace integral {
namespace {

constexpr std::size_t priors = 11;
constexpr double stretch_error = 0.001; // of a printer's two directions, relative

struct Data {
    const SheetView& start;
    const std::vector<PageCorner>& corners;
    const std::vector<PhasePoint>& phases;
    const SheetPrior& prior;
    Vec2 size;

    std::size_t first_phase() const { return 2 * corners.size(); }
    std::size_t first_prior() const { return first_phase() + phases.size(); }
    std::size_t count() const { return first_prior() + priors; }
};

SheetView view_of(const Data& data, const std::vector<double>& p)
{
    SheetView view = data.start;
    view.camera = changed(data.start.camera, p.data(), data.size.x);
    view.stretch += p[stretch_parameter];
    view.pitch *= std::exp(p[pitch_parameter]);
    view.angle += p[angle_parameter];
    view.phase += p[phase_parameter];
    set_lenses(data.prior, p, view);
    return view;
}

std::vector<double> residuals_of(const Data& data, const std::vector<double>& p)
{
    const SheetView view = view_of(data, p);
    std::vector<double> residuals;
    residuals.reserve(data.count());
    for (const PageCorner& corner : data.corners) {
        const Vec2 off = photo_from_page(view.camera,
                                         {corner.page.x, corner.page.y * (1 + view.stretch), 0}) -
                         corner.photo;
        residuals.push_back(off.x);
        residuals.push_back(off.y);
    }
    for (const PhasePoint& point : data.phases)
        residuals.push_back(band_phase(view, point.band, sight_of(view, point.photo)) -
                            point.phase);
    for (const double prior : unusual(view.camera, data.size))
        residuals.push_back(prior);
    residuals.push_back(view.stretch / stretch_error);
    residuals.push_back(p[thickness_parameter] / data.prior.thickness_error);
    residuals.push_back(p[ior_parameter] / data.prior.ior_error);
    residuals.push_back(p[surface_parameter] / data.prior.surface_error);
    return residuals;
}

/// Standard deviation of a kind of residuals, from their median magnitude.
double deviation_of(std::vector<double> values, double least)
{
    if (values.empty())
        return least;
    for (double& value : values)
        value = std::fabs(value);
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return std::max(least, 1.4826 * values[values.size() / 2]);
}

/// Kinds of residuals: corners, beat phases, coarse phases; 3: priors.
int kind_of(const Data& data, std::size_t k)
{
    if (k < data.first_phase())
        return 0;
    if (k < data.first_prior())
        return data.phases[k - data.first_phase()].band.kind == BandKind::coarse ? 2 : 1;
    return 3;
}

struct Scatter {
    double deviations[3];
    std::vector<double> weights;
};

/// Weights of the residuals: 1/variance, and 0 for those beyond four standard deviations.
Scatter scatter_of(const Data& data, const std::vector<double>& residuals)
{
    constexpr double least[] = {0.01, 0.0005, 0.0002}, farthest = 4;
    std::vector<double> kinds[4];
    for (std::size_t k = 0; k < residuals.size(); ++k)
        kinds[kind_of(data, k)].push_back(residuals[k]);
    Scatter scatter{};
    for (int kind = 0; kind < 3; ++kind)
        scatter.deviations[kind] = deviation_of(kinds[kind], least[kind]);
    scatter.weights.assign(residuals.size(), 1);
    for (std::size_t k = 0; k < data.first_prior(); ++k) {
        const double deviation = scatter.deviations[kind_of(data, k)];
        scatter.weights[k] = std::fabs(residuals[k]) < farthest * deviation
                                 ? 1 / (deviation * deviation)
                                 : 0;
    }
    return scatter;
}

/// Index of the part of the page (grid of `side` x `side`) that a page point lies in.
struct Parts {
    Vec2 low, high;
    int side;

    int operator()(Vec2 at, int kind) const
    {
        const auto index = [&](double value, double from, double to) {
            return std::clamp(int(side * (value - from) / (to - from)), 0, side - 1);
        };
        const int column = index(at.x, low.x, high.x), row = index(at.y, low.y, high.y);
        return kind == 0 ? row * side + column : kind == 1 ? row : column;
    }
};

SquareMatrix covariance_of(const Data& data, const LeastSquaresFit& fit,
                           const std::vector<double>& weights, const SheetView& view)
{
    constexpr int side = 5;
    const std::size_t n = fit_parameters;
    SquareMatrix normal(n), prior(n);
    for (std::size_t k = 0; k < data.count(); ++k)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                const double part = weights[k] * fit.derivative(k, i) * fit.derivative(k, j);
                normal.at(i, j) += part;
                if (k >= data.first_prior())
                    prior.at(i, j) += part;
            }
    const auto inverse = inverse_positive(normal);
    if (!inverse)
        throw std::invalid_argument("the photo does not determine the sheet; photograph the page "
                                    "whole and sharp");
    Parts parts{data.corners.at(0).page, data.corners.at(0).page, side};
    for (const PageCorner& corner : data.corners) {
        parts.low = {std::min(parts.low.x, corner.page.x), std::min(parts.low.y, corner.page.y)};
        parts.high = {std::max(parts.high.x, corner.page.x), std::max(parts.high.y, corner.page.y)};
    }
    SquareMatrix greatest(n);
    for (int kind = 0; kind < 3; ++kind) {
        std::map<int, std::vector<double>> groups;
        for (std::size_t k = 0; k < data.first_prior(); ++k) {
            const Vec2 at = k < data.first_phase()
                                ? data.corners[k / 2].page
                                : sight_of(view, data.phases[k - data.first_phase()].photo).film;
            auto& slope = groups[parts(at, kind)];
            slope.resize(n);
            for (std::size_t i = 0; i < n; ++i)
                slope[i] += weights[k] * fit.derivative(k, i) * fit.residuals[k];
        }
        // The fit has adapted itself to its parts: about so many degrees of freedom are lost.
        const double fitted = kind == 0 ? 9 : 2,
                     correction = double(groups.size()) /
                                  std::max(1.0, double(groups.size()) - fitted);
        SquareMatrix middle = prior;
        for (const auto& [part, slope] : groups)
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j)
                    middle.at(i, j) += correction * slope[i] * slope[j];
        SquareMatrix covariance(n);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                for (std::size_t k = 0; k < n; ++k) {
                    double sum = 0;
                    for (std::size_t l = 0; l < n; ++l)
                        sum += middle.at(k, l) * inverse->at(l, j);
                    covariance.at(i, j) += inverse->at(i, k) * sum;
                }
        for (std::size_t i = 0; i < n; ++i)
            if (covariance.at(i, i) > greatest.at(i, i))
                for (std::size_t j = 0; j < n; ++j)
                    greatest.at(i, j) = greatest.at(j, i) = covariance.at(i, j);
    }
    return greatest;
}

/// The view's effective reach with its deviation, by the derivatives of set_lenses.
Estimate reach_of(const SheetPrior& prior, const std::vector<double>& parameters,
                  const CalibrationFit& fit)
{
    constexpr double step = 1e-5;
    std::array<double, fit_parameters> slope{};
    for (std::size_t k = thickness_parameter; k < fit_parameters; ++k) {
        SheetView above, below;
        std::vector<double> at = parameters;
        at[k] += step;
        set_lenses(prior, at, above);
        at[k] -= 2 * step;
        set_lenses(prior, at, below);
        slope[k] = (effective_reach(above) - effective_reach(below)) / (2 * step);
    }
    double variance = 0;
    for (std::size_t i = thickness_parameter; i < fit_parameters; ++i)
        for (std::size_t j = thickness_parameter; j < fit_parameters; ++j)
            variance += slope[i] * fit.covariance.at(i, j) * slope[j];
    return {effective_reach(fit.view), std::sqrt(std::max(0.0, variance))};
}

double rms(const std::vector<double>& residuals, const Data& data, const Scatter& scatter, int kind)
{
    double sum = 0, number = 0;
    for (std::size_t k = 0; k < data.first_prior(); ++k)
        if (kind_of(data, k) == kind && scatter.weights[k] > 0) {
            sum += residuals[k] * residuals[k];
            ++number;
        }
    return number > 0 ? std::sqrt(sum / number) : 0;
}

} // namespace

void set_lenses(const SheetPrior& prior, const std::vector<double>& parameters, SheetView& view)
{
    view.thickness_share = std::exp(parameters[thickness_parameter]);
    view.thickness = prior.thickness * view.thickness_share;
    view.ior = prior.ior * std::exp(parameters[ior_parameter]);
    view.surface = prior.surface;
    view.surface_share = 1 + parameters[surface_parameter];
}

CalibrationFit fit_calibration(const SheetView& start, const std::vector<PageCorner>& corners,
                               const std::vector<PhasePoint>& phases, const SheetPrior& prior,
                               Vec2 photo_size)
{
    constexpr int rounds = 4;
    constexpr double first_deviations[] = {0.1, 0.02, 0.01};
    const Data data{start, corners, phases, prior, photo_size};
    LeastSquaresProblem problem;
    problem.steps = camera_steps();
    problem.steps.insert(problem.steps.end(), {1e-5, 1e-6, 1e-6, 1e-4, 1e-4, 1e-4, 1e-3});
    problem.residuals = [&](const std::vector<double>& p) { return residuals_of(data, p); };
    problem.weights.assign(data.count(), 1);
    for (std::size_t k = 0; k < data.first_prior(); ++k)
        problem.weights[k] = 1 / std::pow(first_deviations[kind_of(data, k)], 2);
    std::vector<double> at(fit_parameters);
    LeastSquaresFit fit;
    Scatter scatter;
    for (int round = 0; round < rounds; ++round) {
        fit = least_squares(problem, at);
        at = fit.parameters;
        scatter = scatter_of(data, fit.residuals);
        problem.weights = scatter.weights;
    }
    CalibrationFit result;
    result.view = view_of(data, at);
    result.covariance = covariance_of(data, fit, problem.weights, result.view);
    result.reach = reach_of(prior, at, result);
    result.corner_residual = rms(fit.residuals, data, scatter, 0);
    result.phase_residual = rms(fit.residuals, data, scatter, 1);
    result.coarse_residual = rms(fit.residuals, data, scatter, 2);
    return result;
}

} // namespace integral
