// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes meshes in POV-Ray's scene language.
#ifndef INTEGRAL_WIREFRAME_MESH_SCENE_H
#define INTEGRAL_WIREFRAME_MESH_SCENE_H

#include "integral/wireframe/mesh.h"

#include <string>

namespace integral {

/// Declares the object `name`: the mesh's faces as a mesh2, its lines as cylinders and its points
/// as spheres. Faces that meet at less than 35 degrees are smooth. Of more than 512 colours,
/// similar ones become one. Throws std::invalid_argument for a mesh with nothing to show.
std::string model_text(const Mesh& mesh, const std::string& name);

} // namespace integral

#endif
