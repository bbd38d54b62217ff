// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads meshes from Wavefront OBJ files.
#ifndef INTEGRAL_WIREFRAME_OBJ_FILE_H
#define INTEGRAL_WIREFRAME_OBJ_FILE_H

#include "integral/wireframe/mesh.h"

#include <string>

namespace integral {

/// Reads v (with or without r g b), p, l, f, usemtl and mtllib (whose Kd are the colours); skips
/// vt, vn, o, g, s and comments. "-" is standard input. Colours in the file are taken as sRGB
/// values, as programs show them. A vertex's colour takes precedence over the material's. Faces are
/// cut into triangles that share their first vertex, which suits convex faces. Without any p, l and
/// f, every vertex is a point: a cloud of points. A missing material or material library gives a
/// warning, and what uses it takes the default colour.
///
/// Throws InputError with the line's number for any other statement, a malformed number, a vertex
/// that does not exist, and a file without vertices.
Mesh read_obj(const std::string& path, const MeshReading& how);

} // namespace integral

#endif
