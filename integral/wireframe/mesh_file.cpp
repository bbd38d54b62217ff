// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/mesh_file.h"

#include "integral/base/file_bytes.h"

namespace integral {

bool names_mesh(const std::string& path)
{
    const std::string extension = extension_of(path);
    for (const char* mesh : {"obj", "ply", "stl", "off", "gltf", "glb", "dae", "3ds", "fbx", "x3d",
                             "3mf", "lwo", "ac", "blend"})
        if (extension == mesh)
            return true;
    return false;
}

Mesh read_mesh(const std::string& path, const MeshReading& how)
{
    return path == "-" || extension_of(path) == "obj" ? read_obj(path, how)
                                                      : read_by_assimp(path, how);
}

} // namespace integral
