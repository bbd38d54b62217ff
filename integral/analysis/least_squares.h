// SPDX-License-Identifier: AGPL-3.0-or-later
// Nonlinear least squares with few parameters, by Levenberg and Marquardt's method.
#ifndef INTEGRAL_ANALYSIS_LEAST_SQUARES_H
#define INTEGRAL_ANALYSIS_LEAST_SQUARES_H

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace integral {

/// A square matrix of `size` rows, row by row.
struct SquareMatrix {
    explicit SquareMatrix(std::size_t n) : size(n), values(n * n) {}
    std::size_t size;
    std::vector<double> values;

    double& at(std::size_t row, std::size_t column) { return values[row * size + column]; }
    double at(std::size_t row, std::size_t column) const { return values[row * size + column]; }
};

/// A pivot must be greater than this fraction of its diagonal element.
constexpr double pivot_tolerance = 1e-14;

/// Solves a x = b for a symmetric positive definite a; returns nothing for any other a.
std::optional<std::vector<double>> solve_positive(SquareMatrix a, std::vector<double> b,
                                                  double tolerance = pivot_tolerance);

/// Inverse of a symmetric positive definite matrix; nothing for any other.
std::optional<SquareMatrix> inverse_positive(const SquareMatrix& a);

struct LeastSquaresProblem {
    /// Computes the residuals; their number must not change.
    std::function<std::vector<double>(const std::vector<double>& parameters)> residuals;
    std::vector<double> weights; ///< of the squared residuals; empty: all 1
    /// Steps of the parameters for the derivatives, small against the residuals' curvature; 0: the
    /// parameter is fixed.
    std::vector<double> steps;
};

struct LeastSquaresFit {
    std::vector<double> parameters, residuals;
    std::vector<double> jacobian; ///< a row of derivatives for each residual

    double derivative(std::size_t residual, std::size_t parameter) const
    {
        return jacobian[residual * parameters.size() + parameter];
    }
};

/// The parameters near `start` with the least weighted sum of squares. A fixed parameter's
/// derivatives are 0.
LeastSquaresFit least_squares(const LeastSquaresProblem& problem, std::vector<double> start);

} // namespace integral

#endif
