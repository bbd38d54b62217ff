// SPDX-License-Identifier: AGPL-3.0-or-later
// Stores points, lines and faces to draw as a wireframe, and places them in the sheet frame.
#ifndef INTEGRAL_WIREFRAME_MESH_H
#define INTEGRAL_WIREFRAME_MESH_H

#include "integral/frame/image.h"
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
    std::vector<MeshLine> face_edges;    ///< one for each edge, however many faces share it
    std::vector<MeshTriangle> triangles; ///< of the faces
    bool is_cloud = false;               ///< a cloud of points: an .obj without p, l and f, or
                                         ///< another file without lines and faces
};

/// Options for reading mesh files.
struct MeshReading {
    Colour plain{1, 1, 1, 1};    ///< linear light; for things without a colour of their own
    bool ignore_colours = false; ///< everything has the colour `plain`; no material file is read
    /// Called for each missing thing without which the mesh can still be drawn.
    std::function<void(const std::string&)> warn = [](const std::string&) {};
};

/// Sorts face_edges and removes duplicates; the first vertex of each edge must be the one with the
/// lower number.
void keep_each_edge_once(Mesh& mesh);

/// Transform from a mesh's coordinates to the sheet frame: the mesh is scaled or fitted, then
/// turned about x, y and z, then moved.
struct MeshPlace {
    Vec3 scale{1, 1, 1}; ///< mm for a unit of the file; negative: mirrored
    double fit = 0;      ///< mm; if > 0, the mesh's middle goes to the sheet's centre, its largest
                         ///< extent gets this length, and `scale` only mirrors
    Vec3 turn;           ///< degrees, about x, then y, then z, as POV-Ray's `rotate` turns
    Vec3 move;           ///< mm
};

constexpr double farthest_vertex = 1e6; ///< mm from the sheet's centre, along each axis

/// Moves the mesh's vertices. Throws std::invalid_argument if `fit` is given for a mesh without
/// extent, or if a vertex is farther than farthest_vertex.
void place(Mesh& mesh, const MeshPlace& place);

/// Moves the vertices of the scene's mesh, in the sheet frame, to where a viewer sees them
/// (optics.md section 8). Throws std::invalid_argument if a vertex is not seen at all, or is seen
/// farther than farthest_vertex.
void show_in_relief(Mesh& mesh, const Collineation& relief);

} // namespace integral

#endif
