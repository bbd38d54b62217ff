// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/mesh_scene.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"
#include "integral/frame/encoding.h"
#include "integral/wireframe/point_squares.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

namespace integral {
namespace {

constexpr double smooth_below = 35 * pi / 180; // angle between faces
constexpr std::size_t most_neighbours = 256;   // faces around a corner that becomes smooth
constexpr std::size_t most_colours = 512;
constexpr double line_width = 0.004; // radius of lines and lone points, of the greatest extent

std::string text_of(const Vec3& v)
{
    return "<" + with_digits(v.x, 7) + "," + with_digits(v.y, 7) + "," + with_digits(v.z, 7) + ">";
}

std::string pigment_of(const Colour& c)
{
    return "pigment { rgb <" + with_digits(c.r, 4) + "," + with_digits(c.g, 4) + "," +
           with_digits(c.b, 4) + "> }";
}

/// A list of POV-Ray's: its length and its items.
template <class Items, class Text>
std::string list_of(const char* name, const Items& items, Text text)
{
    std::string list = std::string("  ") + name + " { " + std::to_string(items.size());
    for (const auto& item : items)
        list += ",\n    " + text(item);
    return list + "\n  }\n";
}

/// The normal of a triangle, as long as twice its area.
Vec3 normal_of(const Mesh& mesh, const MeshTriangle& face)
{
    const Vec3 first = mesh.vertices[face.vertex[0]];
    return cross(mesh.vertices[face.vertex[1]] - first, mesh.vertices[face.vertex[2]] - first);
}

/// Whether two normals, neither of them 0, differ by less than smooth_below.
bool are_smooth(const Vec3& a, const Vec3& b)
{
    return dot(a, b) > std::cos(smooth_below) * length(a) * length(b);
}

/// For each vertex the number of the first one at its place.
std::vector<std::uint32_t> first_at_place(const std::vector<Vec3>& vertices)
{
    const auto key = [&](std::uint32_t k) {
        return std::array<double, 3>{vertices[k].x, vertices[k].y, vertices[k].z};
    };
    std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::size_t k = 0; k < order.size(); ++k)
        first[order[k]] = k > 0 && key(order[k]) == key(order[k - 1]) ? first[order[k - 1]]
                                                                      : order[k];
    return first;
}

/// Normals, and for each corner of each face the number of its own.
struct Normals {
    std::vector<Vec3> all;
    std::vector<std::array<std::size_t, 3>> of_corners;
};

/// A corner's normal is the sum of those of all smooth neighbours that meet there.
Normals normals_of(const Mesh& mesh, const std::vector<MeshTriangle>& faces)
{
    const std::vector<std::uint32_t> place = first_at_place(mesh.vertices);
    std::vector<std::vector<std::uint32_t>> around(mesh.vertices.size());
    std::vector<Vec3> of_faces;
    for (const MeshTriangle& face : faces) {
        for (const std::uint32_t vertex : face.vertex)
            around[place[vertex]].push_back(std::uint32_t(of_faces.size()));
        of_faces.push_back(normal_of(mesh, face));
    }
    Normals normals;
    std::map<std::array<double, 3>, std::size_t> numbers;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        std::array<std::size_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& neighbours = around[place[faces[k].vertex[i]]];
            Vec3 sum = of_faces[k];
            if (neighbours.size() <= most_neighbours)
                for (const std::uint32_t other : neighbours)
                    if (other != k && are_smooth(of_faces[k], of_faces[other]))
                        sum = sum + of_faces[other];
            sum = (1 / length(sum)) * sum;
            const auto [at, is_new] = numbers.try_emplace({sum.x, sum.y, sum.z},
                                                          normals.all.size());
            if (is_new)
                normals.all.push_back(sum);
            corners[i] = at->second;
        }
        normals.of_corners.push_back(corners);
    }
    return normals;
}

/// The faces' colours, and for each face the number of its own. `steps`: of each channel in sRGB.
struct Palette {
    std::vector<Colour> colours;
    std::vector<std::size_t> of_faces;
};

Palette palette_of(const std::vector<MeshTriangle>& faces, int steps)
{
    const Encoding srgb;
    std::map<std::array<int, 3>, std::size_t> numbers;
    Palette palette;
    const auto rounded = [&](double channel) {
        return int(std::lround(encode(srgb, std::clamp(channel, 0.0, 1.0)) * steps));
    };
    for (const MeshTriangle& face : faces) {
        const std::array<int, 3> key{rounded(face.colour.r), rounded(face.colour.g),
                                     rounded(face.colour.b)};
        const auto [at, is_new] = numbers.try_emplace(key, palette.colours.size());
        if (is_new)
            palette.colours.push_back(face.colour);
        palette.of_faces.push_back(at->second);
    }
    return palette;
}

std::string faces_text(const Mesh& mesh, const std::vector<MeshTriangle>& faces)
{
    Palette palette = palette_of(faces, 255);
    for (int steps = 31; palette.colours.size() > most_colours; steps /= 2)
        palette = palette_of(faces, steps);
    const Normals normals = normals_of(mesh, faces);
    const auto three = [](const auto& n) {
        return "<" + std::to_string(n[0]) + "," + std::to_string(n[1]) + "," +
               std::to_string(n[2]) + ">";
    };
    std::size_t k = 0;
    return "mesh2 {\n" + list_of("vertex_vectors", mesh.vertices, text_of) +
           list_of("normal_vectors", normals.all, text_of) +
           list_of("texture_list", palette.colours,
                   [](const Colour& c) { return "texture { " + pigment_of(c) + " }"; }) +
           list_of("face_indices", faces,
                   [&](const MeshTriangle& face) {
                       return three(face.vertex) + "," + std::to_string(palette.of_faces[k++]);
                   }) +
           list_of("normal_indices", normals.of_corners, three) + "}\n";
}

double greatest_extent(const std::vector<Vec3>& vertices)
{
    double extent = 0;
    for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        const auto [least, most] = std::minmax_element(
            vertices.begin(), vertices.end(),
            [&](const Vec3& a, const Vec3& b) { return a.*axis < b.*axis; });
        if (least != vertices.end())
            extent = std::max(extent, (*most).*axis - (*least).*axis);
    }
    return extent;
}

} // namespace

std::string model_text(const Mesh& mesh, const std::string& name)
{
    std::vector<MeshTriangle> faces; // that have an area
    std::copy_if(mesh.triangles.begin(), mesh.triangles.end(), std::back_inserter(faces),
                 [&](const MeshTriangle& face) { return length(normal_of(mesh, face)) > 0; });
    const double radius = line_width * greatest_extent(mesh.vertices),
                 of_points = mesh.is_cloud ? 0.5 * joining_size(mesh, 10 * radius) : radius;
    std::string text = faces.empty() ? "" : faces_text(mesh, faces);
    for (const MeshLine& line : mesh.lines) {
        const Vec3 from = mesh.vertices[line.vertex[0]], to = mesh.vertices[line.vertex[1]];
        if (length(to - from) > 0)
            text += "cylinder { " + text_of(from) + ", " + text_of(to) + ", " +
                    with_digits(radius, 7) + " " + pigment_of(line.colour[0]) + " }\n";
    }
    for (const MeshPoint& point : mesh.points)
        text += "sphere { " + text_of(mesh.vertices[point.vertex]) + ", " +
                with_digits(of_points > 0 ? of_points : radius, 7) + " " +
                pigment_of(point.colour) + " }\n";
    if (text.empty() || !(radius > 0))
        throw std::invalid_argument("it has no faces, lines or points that can be shown");
    return "#declare " + name + " = union {\n" + text + "}\n";
}

} // namespace integral
