// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/mesh_input.h"

#include "integral/base/file_bytes.h"
#include "integral/io/markup.h"
#include "integral/studio/file_stamp.h"
#include "integral/wireframe/mesh_file.h"
#include "integral/wireframe/mesh_scene.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace integral {
namespace {

constexpr double extent_in_scene = 100; // the mesh's greatest extent

const std::string
    scene_text = R"(// A scene around the mesh of @MESH@, for integral studio. Change what you like.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.12 diffuse 0.75 specular 0.2 roughness 0.03 } }
#include "@INCLUDE@"
#declare Least = min_extent(Model);
#declare Most = max_extent(Model);
#declare Half = (Most - Least)/2;
#declare Shape = image_width/image_height;

camera {
  location <0, 0, Least.z - 250> look_at 0
  right x*Shape
  angle 2*degrees(atan2(1.2*max(Half.x, Half.y*Shape), 250))
}
light_source { <-250, 350, Least.z - 350> rgb 0.85 }
light_source { <300, 80, Least.z - 250> rgb 0.35 shadowless }
object { Model }
plane { y, Least.y - 0.05 pigment { rgb <0.55, 0.53, 0.5> } }
plane { -z, -(Most.z + 40) pigment { rgb <0.6, 0.66, 0.74> } }
)";

std::string include_of_mesh(const std::string& mesh)
{
    return std::filesystem::path(mesh).stem().string() + "-mesh.inc";
}

bool is_there(const std::string& path) { return std::filesystem::exists(path); }

/// The first line of the include file, from which it is known again.
std::string first_line(const std::string& mesh)
{
    return "// The mesh of " + mesh + ", written by integral studio; changes are lost.\n";
}

/// Throws std::invalid_argument unless the file is missing or contains `text`.
void check_own(const std::string& path, const std::string& text, const std::string& advice)
{
    if (is_there(path) && read_file(path).find(text) == std::string::npos)
        throw std::invalid_argument(path + " " + advice);
}

/// Returns the mesh's path. Throws std::invalid_argument if a scene cannot contain it.
const std::string& checked_name(const std::string& mesh)
{
    const auto breaks = [](unsigned char c) { return c < 32 || c == '"' || c == '\\'; };
    if (std::any_of(mesh.begin(), mesh.end(), breaks))
        throw std::invalid_argument("its name has a quotation mark, a backslash or a line's end, "
                                    "which a scene cannot contain; rename it");
    return mesh;
}

} // namespace

std::string scene_of_mesh(const std::string& mesh)
{
    return std::filesystem::path(mesh).stem().string() + ".pov";
}

MeshInput::MeshInput(const std::string& mesh, const Vec3& turn, const MeshReading& reading,
                     const std::vector<std::string>& options)
    : SceneInput(scene_of_mesh(checked_name(mesh)), options),
      mesh_(mesh),
      turn_(turn),
      reading_(reading)
{
    const std::string scene = scene_of_mesh(mesh), include = include_of_mesh(mesh);
    check_own(scene, include,
              "belongs to another scene; rename it, or give it in place of the mesh");
    check_own(include, first_line(mesh), "was not made of this mesh; rename it or the mesh");
    write_model();
}

std::vector<std::string> MeshInput::files() const
{
    std::vector<std::string> files{mesh_};
    try {
        for (const std::string& file : SceneInput::files())
            if (std::filesystem::path(file).filename() != include_of_mesh(mesh_)) // which is
                                                                                  // written here
                files.push_back(file);
    } catch (const InputError&) {
        // The scene is missing; the next probe writes it.
    }
    return files;
}

void MeshInput::forget()
{
    is_written_ = is_written_ && file_stamp(mesh_) == stamp_ && is_there(scene_of_mesh(mesh_)) &&
                  is_there(include_of_mesh(mesh_));
}

/// Writes the include file, and the scene if it is missing. Formats define z towards the viewer,
/// but clouds of integral depth have z into the picture.
void MeshInput::write_model()
{
    stamp_ = file_stamp(mesh_);
    Mesh mesh = read_mesh(mesh_, reading_);
    MeshPlace place;
    place.fit = extent_in_scene;
    place.scale.z = mesh.is_cloud ? 1 : -1;
    place.turn = turn_;
    std::string text = first_line(mesh_);
    try {
        integral::place(mesh, place);
        text += model_text(mesh, "Model");
    } catch (const std::invalid_argument& error) {
        throw InputError(mesh_ + ": " + error.what());
    }
    const std::string include = include_of_mesh(mesh_), scene = scene_of_mesh(mesh_);
    write_file(include, text);
    if (!is_there(scene))
        write_file(scene, filled_template(scene_text, {{"MESH", mesh_}, {"INCLUDE", include}}));
    is_written_ = true;
}

Making MeshInput::probe(const ProbeRequest& request, const ScratchFolder& scratch)
{
    if (!is_written_)
        write_model();
    return SceneInput::probe(request, scratch);
}

} // namespace integral
