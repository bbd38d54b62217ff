// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the text of meshes in POV-Ray's scene language: normals, colours, and what is left out.
#include "integral/wireframe/mesh_scene.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(wireframe_scene)

namespace {

constexpr Colour grey{0.5f, 0.5f, 0.5f, 1};

/// The length of a list in a model's text; -1: there is none.
int length_of(const std::string& text, const std::string& list)
{
    const auto at = text.find(list + " { ");
    return at == std::string::npos ? -1 : std::atoi(text.c_str() + at + list.size() + 3);
}

/// Two squares with an edge in common, each with vertices of its own, at that angle (degrees).
Mesh hinge(double angle)
{
    const double turn = angle * std::acos(-1) / 180;
    Mesh mesh;
    for (const Vec2 far : {Vec2{1, 0}, Vec2{-std::cos(turn), std::sin(turn)}}) {
        const auto first = std::uint32_t(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(),
                             {{0, 0, 0}, {far.x, 0, far.y}, {far.x, 1, far.y}, {0, 1, 0}});
        for (std::uint32_t k : {1u, 2u})
            mesh.triangles.push_back({{first, first + k, first + k + 1}, grey});
    }
    std::swap(mesh.triangles[2].vertex[1], mesh.triangles[2].vertex[2]); // all the same way round
    std::swap(mesh.triangles[3].vertex[1], mesh.triangles[3].vertex[2]);
    return mesh;
}

} // namespace

BOOST_AUTO_TEST_CASE(edges_are_smooth_below_35_degrees)
{
    BOOST_TEST(length_of(model_text(hinge(34), "A"), "normal_vectors") == 3); // one at the edge
    BOOST_TEST(length_of(model_text(hinge(36), "A"), "normal_vectors") == 2); // one a square
}

BOOST_AUTO_TEST_CASE(similar_colours_become_one)
{
    Mesh mesh = hinge(90);
    for (int k = 0; k < 3000; ++k)
        mesh.triangles.push_back({{0, 1, 2}, {k / 3000.0f, 1 - k / 3000.0f, 0.2f, 1}});
    const std::string text = model_text(mesh, "A");
    BOOST_TEST(length_of(text, "texture_list") > 30);
    BOOST_TEST(length_of(text, "texture_list") <= 512);
    BOOST_TEST(length_of(text, "face_indices") == 3004);
}

BOOST_AUTO_TEST_CASE(what_has_no_extent_is_left_out)
{
    Mesh mesh = hinge(90);
    mesh.triangles.push_back({{0, 0, 1}, grey});
    mesh.lines = {{{0, 1}, {grey, grey}}, {{2, 2}, {grey, grey}}};
    mesh.points = {{2, grey}};
    const std::string text = model_text(mesh, "A");
    BOOST_TEST(length_of(text, "face_indices") == 4);
    BOOST_TEST(text.find("cylinder") == text.rfind("cylinder"));
    BOOST_TEST(text.find("sphere { <1,1,0>") != std::string::npos);
    Mesh dot;
    dot.vertices = {{1, 2, 3}};
    dot.points = {{0, grey}};
    BOOST_CHECK_THROW(model_text(dot, "A"), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
