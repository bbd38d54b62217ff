// SPDX-License-Identifier: AGPL-3.0-or-later
// Gives the points of a cloud a size, so that they join in a surface where the cloud is dense.
#ifndef INTEGRAL_WIREFRAME_POINT_SQUARES_H
#define INTEGRAL_WIREFRAME_POINT_SQUARES_H

#include "integral/wireframe/mesh.h"

namespace integral {

/// Side (mm) of the squares that represent a cloud's points. A square has twice each point's share
/// of the cloud's area, as seen from the front, so that few gaps are left between randomly placed
/// points. At most `most`; 0 for a mesh without points.
double joining_size(const Mesh& cloud, double most);

/// Adds two triangles in the colour of each point: an upright square that faces the viewer, with
/// the point in its middle. A light at the viewer leaves their colours as they are.
void add_squares(Mesh& cloud, double side);

} // namespace integral

#endif
