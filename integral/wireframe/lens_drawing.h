// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws the part of a mesh that one lens images.
#ifndef INTEGRAL_WIREFRAME_LENS_DRAWING_H
#define INTEGRAL_WIREFRAME_LENS_DRAWING_H

#include "integral/wireframe/vertex_film.h"

#include <optional>
#include <vector>

namespace integral {

/// Draws one sharp picture through a lens, from the mesh of the vertices' block.
class LensDrawing {
public:
    LensDrawing(const WireframeRequest& request, LensIndex lens, Vec2 shift,
                const SharpPicture& picture, VertexFilm& vertices, LensRaster& raster);

    /// Draws everything in the block that the lens may image.
    void draw_all();

private:
    void draw(const MeshPoint& point);
    void draw(const MeshLine& line);
    void draw(const MeshTriangle& triangle);
    void draw_far_lines();
    void draw_far_triangles();
    bool may_be_seen(int from, int to, float nearest) const;
    bool draw_short(const MeshLine& line, const Vec2* start, const Vec2* end);

    struct End {
        Vec3 point;
        Colour colour;
    };
    struct Span {
        double first = 0, last = 1; ///< parts of a line's length
        bool is_empty() const { return !(first < last); }
    };
    FilmCorner corner_at(const Vec2* pixel, double depth, Colour colour) const;
    std::optional<FilmCorner> corner(const Vec2* pixel, double depth, Colour colour) const;
    std::optional<FilmCorner> corner(const End& end) const;
    void cover(Vec3 point, Colour colour);
    static End half_way(const End& a, const End& b);
    void draw_far(const MeshLine& line, Span span);
    void draw_piece(const End& a, const End& b, int splits);
    void draw_near(const MeshLine& line, Span span);
    void keep_in_aperture(Vec3 from, Vec3 way, bool behind, Span& span) const;
    void draw_curve(const End& a, const FilmCorner& film_a, const End& b, const FilmCorner& film_b,
                    int splits);
    End at(const MeshLine& line, double part) const;
    struct Interval {
        double least = 1e300, most = -1e300;
        void add(double v)
        {
            least = std::min(least, v);
            most = std::max(most, v);
        }
    };
    static Interval film_offsets(const Medium& medium, Interval slope, Interval other);
    PixelBox box_of(const MeshTriangle& triangle) const;
    PixelBox box_by_slopes(const MeshTriangle& triangle) const;
    PixelBox centres_within(Interval across, Interval down) const;
    PixelBox pixels_within(Interval x, Interval y) const;
    double bulge_by_pixel() const;
    void see_faces();
    void paint(const MeshTriangle& triangle, const PixelBox& box);
    double put_back(Vec3 normal, Vec3 direction, double depth) const;
    Colour shade(const MeshTriangle& triangle, Vec3 corner, Vec3 normal) const;

    const WireframeRequest& request_;
    const BlockMesh& block_;
    const Mesh& mesh_;
    LensIndex lens_;
    Vec2 shift_, pole_;
    const SharpPicture& picture_;
    VertexFilm& vertices_;
    LensRaster& raster_;
    DepthLimits limits_;
    double aperture_margin_;                     ///< mm
    std::vector<std::optional<BeamRay>> sights_; ///< rays of the raster's pixels, set when faces
                                                 ///< first need them
};

} // namespace integral

#endif
