// SPDX-License-Identifier: AGPL-3.0-or-later
// Reports the drawn mesh and the cost of drawing, as a line and as JSON.
#ifndef INTEGRAL_WIREFRAME_WIREFRAME_REPORT_H
#define INTEGRAL_WIREFRAME_WIREFRAME_REPORT_H

#include "integral/base/json.h"
#include "integral/wireframe/wireframe.h"

#include <string>

namespace integral {

std::string drawing_text(const Mesh& mesh, const WireframeCost& cost, double seconds);
Json drawing_json(const Mesh& mesh, const WireframeCost& cost, double seconds);

} // namespace integral

#endif
