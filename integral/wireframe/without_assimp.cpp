// SPDX-License-Identifier: AGPL-3.0-or-later
// Takes the place of assimp_file.cpp in a build without Assimp.
#include "integral/wireframe/mesh_file.h"

#include "integral/base/file_bytes.h"

namespace integral {

Mesh read_by_assimp(const std::string& path, const MeshReading&)
{
    throw InputError(path + ": this program reads Wavefront OBJ (.obj) alone, since it was built "
                            "without Assimp; libassimp-dev (Debian's name) is missing");
}

} // namespace integral
