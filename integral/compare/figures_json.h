// SPDX-License-Identifier: AGPL-3.0-or-later
// A comparison's figures for programs.
#ifndef INTEGRAL_COMPARE_FIGURES_JSON_H
#define INTEGRAL_COMPARE_FIGURES_JSON_H

#include "integral/base/json.h"
#include "integral/compare/compare.h"

namespace integral {

/// A PSNR that is infinite, and a micro-image that is not there, are null.
Json figures_json(const Comparison& comparison);

} // namespace integral

#endif
