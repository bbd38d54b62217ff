// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads meshes from files of any format.
#ifndef INTEGRAL_WIREFRAME_MESH_FILE_H
#define INTEGRAL_WIREFRAME_MESH_FILE_H

#include "integral/wireframe/obj_file.h"

namespace integral {

/// Reads Wavefront OBJ (.obj, and "-", standard input) by read_obj; every other extension by
/// Assimp, if the program was built with it. Coordinates are the file's own, each of its objects
/// placed as its file says; colours are a vertex's, else the material's, taken as sRGB values
/// (glTF's: as linear light). Throws InputError.
Mesh read_mesh(const std::string& path, const MeshReading& how);

/// What Assimp makes of a file. Such libraries read dozens of formats and may crash or run wild on
/// malformed files: it works in a process of its own, whose memory and time are limited, so that
/// the worst is an InputError. Without Assimp: an InputError that says so.
Mesh read_by_assimp(const std::string& path, const MeshReading& how);

} // namespace integral

#endif
