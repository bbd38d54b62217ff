// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws what one lens images of a mesh.
#ifndef INTEGRAL_WIREFRAME_LENS_DRAWING_H
#define INTEGRAL_WIREFRAME_LENS_DRAWING_H

#include "integral/wireframe/lens_raster.h"
#include "integral/wireframe/lens_rays.h"
#include "integral/wireframe/wireframe.h"

#include <optional>
#include <vector>

namespace integral {

/// Where on the film the rays of one lens put a mesh's vertices, in continuous pixel coordinates;
/// each is worked out when it is first asked for. Used for one lens after another.
class VertexFilm {
public:
    /// `shift`: of a colour's subpixels from their pixels' centres, in pixels, +y down.
    VertexFilm(const WireframeRequest& request, const Mesh& mesh, Vec2 shift)
        : request_(request), mesh_(mesh), shift_(shift)
    {
    }
    const Mesh& mesh() const { return mesh_; }
    /// Forgets all places.
    void begin(LensIndex lens, const std::vector<LensPoint>& rays);
    /// The places of a vertex, one for each ray; nullptr where a ray has none.
    const Vec2* of(std::uint32_t vertex);
    /// The same of any scene point, kept until the next call.
    const Vec2* of_point(Vec3 point);
    double projections() const { return projections_; }

private:
    bool project(Vec3 point, Vec2* pixel) const;

    const WireframeRequest& request_;
    const Mesh& mesh_;
    Vec2 shift_;
    LensIndex lens_;
    const std::vector<LensPoint>* rays_ = nullptr;
    std::vector<Vec2> pixel_;
    std::vector<std::uint32_t> state_; ///< of each vertex: 2 generation_ + whether it has film
                                       ///< points
    std::uint32_t generation_ = 0;
    std::array<Vec2, 5> single_;
    double projections_ = 0;
};

/// One sharp picture of a lens, of the mesh whose vertices are given.
class LensDrawing {
public:
    LensDrawing(const WireframeRequest& request, LensIndex lens, Vec2 shift,
                const SharpPicture& picture, VertexFilm& vertices, LensRaster& raster);

    void draw(const MeshPoint& point);
    void draw(const MeshLine& line);
    void draw(const MeshTriangle& triangle);

private:
    struct End {
        Vec3 point;
        Colour colour;
    };
    struct Span {
        double first = 0, last = 1; ///< of a line, parts of its length
        bool is_empty() const { return !(first < last); }
    };
    FilmCorner corner_at(const Vec2* pixel, double depth, Colour colour) const;
    std::optional<FilmCorner> corner(const Vec2* pixel, double depth, Colour colour) const;
    std::optional<FilmCorner> corner(const End& end) const;
    bool is_near(double z) const { return std::fabs(z) <= near_; }
    bool is_in_front_of_eye(double z) const { return z > foremost_; }
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
    void see_faces();

    const WireframeRequest& request_;
    const Mesh& mesh_;
    LensIndex lens_;
    Vec2 shift_, pole_;
    const SharpPicture& picture_;
    VertexFilm& vertices_;
    LensRaster& raster_;
    double foremost_; ///< z in front of which nothing is seen, mm
    double near_;     ///< |z| up to which what is next to a lens covers it, mm; 0: never
    double behind_;   ///< z beyond which a point is behind the lens and its curved surface, mm
    double aperture_margin_;                     ///< mm
    std::vector<std::optional<BeamRay>> sights_; ///< of the raster's pixels, once faces need them
};

} // namespace integral

#endif
