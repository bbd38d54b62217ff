// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads meshes from files of any format.
#ifndef INTEGRAL_WIREFRAME_MESH_FILE_H
#define INTEGRAL_WIREFRAME_MESH_FILE_H

#include "integral/wireframe/obj_file.h"

namespace integral {

/// Whether a file's extension is that of a mesh, in a common format.
bool names_mesh(const std::string& path);

/// Reads Wavefront OBJ (.obj, and "-", standard input) by read_obj, and every other extension by
/// Assimp, if the program was built with it. Coordinates are the file's own, with each object
/// placed as the file says. Colours are the vertex's, else the material's, taken as sRGB values
/// (glTF's: as linear light). Throws InputError.
Mesh read_mesh(const std::string& path, const MeshReading& how);

/// Reads a file by Assimp. The library reads dozens of formats and may crash or hang on malformed
/// files. So it runs in a process of its own with limited memory and time, and the worst is an
/// InputError. Throws InputError if built without Assimp.
Mesh read_by_assimp(const std::string& path, const MeshReading& how);

} // namespace integral

#endif
