// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/least_squares.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// Replaces a by its lower Cholesky factor. Returns false if a is not positive definite.
bool factorise(SquareMatrix& a, double tolerance)
{
    for (std::size_t k = 0; k < a.size; ++k) {
        for (std::size_t j = 0; j <= k; ++j) {
            double sum = a.at(k, j);
            for (std::size_t i = 0; i < j; ++i)
                sum -= a.at(k, i) * a.at(j, i);
            if (j < k)
                a.at(k, j) = sum / a.at(j, j);
            else if (sum > tolerance * std::fabs(a.at(k, k)))
                a.at(k, k) = std::sqrt(sum);
            else
                return false;
        }
    }
    return true;
}

void solve_factorised(const SquareMatrix& factor, std::vector<double>& b)
{
    const std::size_t n = factor.size;
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = 0; i < k; ++i)
            b[k] -= factor.at(k, i) * b[i];
        b[k] /= factor.at(k, k);
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t i = k + 1; i < n; ++i)
            b[k] -= factor.at(i, k) * b[i];
        b[k] /= factor.at(k, k);
    }
}

double weight(const LeastSquaresProblem& problem, std::size_t k)
{
    return problem.weights.empty() ? 1 : problem.weights[k];
}

double sum_of_squares(const LeastSquaresProblem& problem, const std::vector<double>& residuals)
{
    double sum = 0;
    for (std::size_t k = 0; k < residuals.size(); ++k)
        sum += weight(problem, k) * residuals[k] * residuals[k];
    return sum;
}

/// Derivatives by central differences.
void differentiate(const LeastSquaresProblem& problem, LeastSquaresFit& fit)
{
    const std::size_t n = fit.parameters.size(), m = fit.residuals.size();
    fit.jacobian.assign(m * n, 0);
    std::vector<double> at = fit.parameters;
    for (std::size_t j = 0; j < n; ++j) {
        const double step = problem.steps[j], middle = at[j];
        if (step == 0)
            continue;
        at[j] = middle + step;
        const std::vector<double> above = problem.residuals(at);
        at[j] = middle - step;
        const std::vector<double> below = problem.residuals(at);
        at[j] = middle;
        for (std::size_t k = 0; k < m; ++k)
            fit.jacobian[k * n + j] = (above[k] - below[k]) / (2 * step);
    }
}

} // namespace

std::optional<std::vector<double>> solve_positive(SquareMatrix a, std::vector<double> b,
                                                  double tolerance)
{
    if (!factorise(a, tolerance))
        return std::nullopt;
    solve_factorised(a, b);
    return b;
}

std::optional<SquareMatrix> inverse_positive(const SquareMatrix& a)
{
    SquareMatrix factor = a, inverse(a.size);
    if (!factorise(factor, pivot_tolerance))
        return std::nullopt;
    for (std::size_t j = 0; j < a.size; ++j) {
        std::vector<double> column(a.size);
        column[j] = 1;
        solve_factorised(factor, column);
        for (std::size_t k = 0; k < a.size; ++k)
            inverse.at(k, j) = column[k];
    }
    return inverse;
}

LeastSquaresFit least_squares(const LeastSquaresProblem& problem, std::vector<double> start)
{
    constexpr int most_steps = 50;
    const std::size_t n = start.size();
    LeastSquaresFit fit;
    fit.residuals = problem.residuals(start);
    fit.parameters = std::move(start);
    double sum = sum_of_squares(problem, fit.residuals), damping = 1e-3;
    for (int step = 0; step < most_steps && damping < 1e10; ++step) {
        differentiate(problem, fit);
        SquareMatrix normal(n);
        std::vector<double> slope(n);
        for (std::size_t k = 0; k < fit.residuals.size(); ++k) {
            const double w = weight(problem, k);
            for (std::size_t i = 0; i < n; ++i) {
                const double d = w * fit.derivative(k, i);
                slope[i] -= d * fit.residuals[k];
                for (std::size_t j = 0; j <= i; ++j)
                    normal.at(i, j) += d * fit.derivative(k, j);
            }
        }
        for (std::size_t i = 0; i < n; ++i)
            if (normal.at(i, i) == 0)
                normal.at(i, i) = 1; // a fixed parameter, whose slope is 0
        bool better = false;
        double gained = 0;
        for (; !better && damping < 1e10; damping *= 10) {
            SquareMatrix damped = normal;
            for (std::size_t i = 0; i < n; ++i)
                damped.at(i, i) *= 1 + damping;
            const auto change = solve_positive(std::move(damped), slope);
            if (!change)
                continue;
            std::vector<double> there = fit.parameters;
            for (std::size_t i = 0; i < n; ++i)
                there[i] += (*change)[i];
            std::vector<double> residuals = problem.residuals(there);
            const double next = sum_of_squares(problem, residuals);
            if (!(next < sum))
                continue;
            better = true;
            gained = sum - next;
            fit.parameters = std::move(there);
            fit.residuals = std::move(residuals);
            sum = next;
            damping *= 0.01;
        }
        if (!better || gained < 1e-9 * sum)
            break;
    }
    differentiate(problem, fit);
    return fit;
}

} // namespace integral
