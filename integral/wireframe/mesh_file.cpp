// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/mesh_file.h"

#include "integral/base/file_bytes.h"

namespace integral {

Mesh read_mesh(const std::string& path, const MeshReading& how)
{
    return path == "-" || extension_of(path) == "obj" ? read_obj(path, how)
                                                      : read_by_assimp(path, how);
}

} // namespace integral
