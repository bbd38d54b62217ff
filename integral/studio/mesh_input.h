// SPDX-License-Identifier: AGPL-3.0-or-later
// A mesh in the studio: a scene is written around it, which povray-integral renders.
#ifndef INTEGRAL_STUDIO_MESH_INPUT_H
#define INTEGRAL_STUDIO_MESH_INPUT_H

#include "integral/studio/scene_input.h"
#include "integral/wireframe/mesh.h"

namespace integral {

/// Writes the mesh FOLDER/NAME.obj as NAME-mesh.inc, and beside it the scene NAME.pov, with camera,
/// lights, floor and wall, unless that is there. Both are in the working folder. The scene may be
/// changed by its user; the include file is written anew when the mesh changes.
class MeshInput : public SceneInput {
public:
    /// `turn`: degrees, as in MeshPlace. `options` as in SceneInput. Throws InputError,
    /// OutputError, and std::invalid_argument if the mesh cannot be shown or one of the files is
    /// there and was not made here.
    MeshInput(const std::string& mesh, const Vec3& turn, const MeshReading& reading,
              const std::vector<std::string>& options);

    std::vector<std::string> files() const override;
    void forget() override;
    Making probe(const ProbeRequest& request, const ScratchFolder& scratch) override;

private:
    void write_model();

    const std::string mesh_;
    const Vec3 turn_;
    const MeshReading reading_;
    std::string stamp_;       ///< file_stamp of the mesh that has been read
    bool is_written_ = false; ///< the include file shows the mesh as it is
};

/// The name of the scene of a mesh.
std::string scene_of_mesh(const std::string& mesh);

} // namespace integral

#endif
