// SPDX-License-Identifier: AGPL-3.0-or-later
// Mathematical constants.
#ifndef INTEGRAL_BASE_CONSTANTS_H
#define INTEGRAL_BASE_CONSTANTS_H

namespace integral {

constexpr double pi = 3.14159265358979323846;
constexpr double radians_per_degree = pi / 180;
constexpr double degrees_per_radian = 180 / pi;

} // namespace integral

#endif
