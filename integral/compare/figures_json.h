// SPDX-License-Identifier: AGPL-3.0-or-later
// A comparison's figures for programs.
#ifndef INTEGRAL_COMPARE_FIGURES_JSON_H
#define INTEGRAL_COMPARE_FIGURES_JSON_H

#include "integral/base/json.h"
#include "integral/compare/compare.h"

namespace integral {

/// An object of all figures. An infinite PSNR, a missing worst micro-image, and figures that are
/// NaN because no value is finite in both pictures are null.
Json figures_json(const Comparison& comparison);

} // namespace integral

#endif
