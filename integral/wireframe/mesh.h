// SPDX-License-Identifier: AGPL-3.0-or-later
// Points, lines and faces to draw as a wireframe, and where they stand in the sheet frame.
#ifndef INTEGRAL_WIREFRAME_MESH_H
#define INTEGRAL_WIREFRAME_MESH_H

#include "integral/lightfield/image.h"
#include "integral/optics/collineation.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace integral {

/// Colours are linear light, 0 to 1. Vertices are numbered from 0.
struct MeshPoint {
    std::uint32_t vertex;
    Colour colour;
};
struct MeshLine {
    std::array<std::uint32_t, 2> vertex;
    std::array<Colour, 2> colour; ///< at its ends
};
struct MeshTriangle {
    std::array<std::uint32_t, 3> vertex;
    Colour colour;
};

struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<MeshPoint> points;
    std::vector<MeshLine> lines;
    std::vector<MeshLine> face_edges;    ///< each once, however many faces share it
    std::vector<MeshTriangle> triangles; ///< of the faces
    bool is_cloud = false; ///< the file has vertices alone; its points are all of them
};

/// What files of meshes are asked for.
struct MeshReading {
    Colour plain{1, 1, 1, 1};    ///< linear light; of what has no colour of its own
    bool ignore_colours = false; ///< everything is plain, and no material file is read
    /// Called with each thing that is missing, where the mesh can be drawn without it.
    std::function<void(const std::string&)> warn = [](const std::string&) {};
};

/// Sorts face_edges and leaves out what stands there twice; each edge's first vertex must be the
/// one with the lower number.
void keep_each_edge_once(Mesh& mesh);

/// How a mesh's coordinates become those of the sheet frame: first it is scaled, or fitted, then
/// turned about x, y and z, then moved.
struct MeshPlace {
    Vec3 scale{1, 1, 1}; ///< mm for a unit of the file; negative: mirrored
    double fit = 0;      ///< mm; if > 0, the mesh's middle goes to the sheet's centre, and the
                    ///< largest of its three extents becomes so long; `scale` only mirrors then
    Vec3 turn; ///< degrees, about x, then y, then z, as POV-Ray's `rotate` turns
    Vec3 move; ///< mm
};

constexpr double farthest_vertex = 1e6; ///< mm from the sheet's centre, along each axis

/// Moves the mesh's vertices. Throws std::invalid_argument where `fit` is asked of a mesh that has
/// no extent, and where a vertex is farther than farthest_vertex.
void place(Mesh& mesh, const MeshPlace& place);

/// Moves the vertices to where a viewer sees them (optics.md section 8): the mesh is that of the
/// scene, in the sheet frame. Throws std::invalid_argument where one is not seen at all, and where
/// one is seen farther than farthest_vertex.
void show_in_relief(Mesh& mesh, const Collineation& relief);

} // namespace integral

#endif
