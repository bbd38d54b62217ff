// SPDX-License-Identifier: AGPL-3.0-or-later
// Faces behind one lens: every pixel that may see a triangle looks at it along its own ray.
#include "integral/wireframe/lens_drawing.h"

#include <algorithm>

namespace integral {
namespace {

struct Interval {
    double least = 1e300, most = -1e300;
    void add(double v)
    {
        least = std::min(least, v);
        most = std::max(most, v);
    }
};

/// Film offsets t s/sqrt(n^2 + m (s^2 + o^2)) for slopes s in `slope`, o in `other`.
Interval film_offsets(const Medium& medium, Interval slope, Interval other)
{
    const double far = std::max(std::fabs(other.least), std::fabs(other.most));
    const double near = other.least <= 0 && other.most >= 0
                            ? 0
                            : std::min(std::fabs(other.least), std::fabs(other.most));
    const auto offset = [&](double s, double o) {
        return medium.t * s / std::sqrt(medium.n * medium.n + medium.m * (s * s + o * o));
    };
    return {offset(slope.least, slope.least < 0 ? near : far),
            offset(slope.most, slope.most > 0 ? near : far)};
}

/// Where a ray meets a triangle's plane inside the triangle: its z. Nothing elsewhere.
std::optional<double> depth_on(const std::array<Vec3, 3>& corner, const BeamRay& ray)
{
    const Vec3 edge1 = corner[1] - corner[0], edge2 = corner[2] - corner[0],
               from = ray.point - corner[0], across = cross(ray.direction, edge2),
               turned = cross(from, edge1);
    const double determinant = dot(edge1, across);
    if (determinant == 0)
        return std::nullopt;
    const double u = dot(from, across) / determinant, v = dot(ray.direction, turned) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1))
        return std::nullopt;
    return ray.point.z + dot(edge2, turned) / determinant * ray.direction.z;
}

} // namespace

/// The ray of each of the raster's pixels.
void LensDrawing::see_faces()
{
    const SheetOptics& optics = request_.optics;
    sights_.resize(raster_.size());
    raster_.for_each_pixel_in(raster_.box(), [&](std::size_t index, int x, int y) {
        Vec2 film = film_from_pixel(request_.film, Vec2{x + 0.5, y + 0.5} + shift_);
        if (request_.pseudoscopic)
            film = mirrored_in_lens(optics, film, lens_);
        sights_[index] = beam_ray(optics, film, lens_, picture_.through);
    });
}

/// Pixels that may see the triangle. The line from a scene point through the pole leaves the lens
/// at P and meets the aperture plane at A, its slope is (P - A)/d, and over a triangle on one side
/// of the sheet P and A have their extremes at the corners. Where a triangle crosses the sheet, A
/// is only known to be within the aperture.
PixelBox LensDrawing::box_of(const MeshTriangle& triangle) const
{
    const SheetOptics& optics = request_.optics;
    const double d = optics.aperture().distance;
    Interval px, py, ax, ay;
    double spread = 0;
    int sides = 0;
    const double next_to = 1e-6 * optics.sheet().thickness;
    for (const std::uint32_t vertex : triangle.vertex) {
        const Vec3 s = request_.mesh.vertices[vertex];
        const Vec2* film = vertices_.of(vertex);
        if (!film || !is_in_front_of_eye(s.z))
            return raster_.box();
        sides |= s.z > next_to ? 1 : s.z < -next_to ? 2 : 3;
        const Vec2 p = leaving_point(optics, s, lens_), a = p + (d / s.z) * (p - Vec2{s.x, s.y});
        px.add(p.x);
        py.add(p.y);
        ax.add(a.x);
        ay.add(a.y);
        if (refracts_at_surface(optics.model()))
            if (const auto pole = film_point_imaging(optics, s, lens_))
                spread = std::max(spread, 2 * length(*film - *pole));
    }
    if (request_.pseudoscopic)
        return raster_.box();
    if (sides == 3) {
        const Vec2 half{0.5 * optics.aperture().width + aperture_margin_,
                        0.5 * optics.aperture().height + aperture_margin_};
        if (refracts_at_surface(optics.model()) || !std::isfinite(half.x + half.y))
            return raster_.box();
        ax = {-half.x, half.x};
        ay = {-half.y, half.y};
    }
    const Interval slope_x{(px.least - ax.most) / d, (px.most - ax.least) / d},
        slope_y{(py.least - ay.most) / d, (py.most - ay.least) / d};
    const Interval x = film_offsets(optics.medium(), slope_x, slope_y),
                   y = film_offsets(optics.medium(), slope_y, slope_x);
    const Film& film = request_.film;
    const Vec2 top_left = pixel_from_film(
                              film, {px.least + x.least - spread, py.most + y.most + spread}) -
                          shift_,
               bottom_right = pixel_from_film(
                                  film, {px.most + x.most + spread, py.least + y.least - spread}) -
                              shift_;
    const PixelBox all = raster_.box();
    const auto within = [](double v, int least, int most) {
        return int(std::clamp(std::floor(v), double(least), double(most)));
    };
    return {within(top_left.x - 1, all.left, all.right),
            within(top_left.y - 1, all.top, all.bottom),
            within(bottom_right.x + 2, all.left, all.right),
            within(bottom_right.y + 2, all.top, all.bottom)};
}

void LensDrawing::draw(const MeshTriangle& triangle)
{
    const auto& all = request_.mesh.vertices;
    const std::array<Vec3, 3> corner{all[triangle.vertex[0]], all[triangle.vertex[1]],
                                     all[triangle.vertex[2]]};
    const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double size = length(normal);
    if (!(size > 0))
        return;
    if (sights_.empty())
        see_faces();
    Colour colour = request_.background;
    if (request_.faces == FaceStyle::flat) {
        constexpr double ambient = 0.2;
        const Vec3 to_eye = Vec3{0, 0, -request_.optics.aperture().distance} - corner[0];
        const double facing = dot(normal, to_eye) < 0 ? -1 : 1;
        const double lit = facing * dot(normal, request_.light) / (size * length(request_.light));
        const float shade = float(ambient + (1 - ambient) * std::max(lit, 0.0));
        colour = {shade * triangle.colour.r, shade * triangle.colour.g, shade * triangle.colour.b,
                  1};
    }
    // An edge's pixels see its faces beside the edge. They are put back by as much as they may lie
    // in front of it there, so that they do not hide it.
    const SheetOptics& optics = request_.optics;
    const double pixel = std::max(request_.film.pixel_pitch.x, request_.film.pixel_pitch.y) *
                         optics.medium().n / optics.medium().t;
    constexpr double steepest = 16;
    raster_.for_each_pixel_in(box_of(triangle), [&](std::size_t index, int, int) {
        const auto& ray = sights_[index];
        const auto depth = ray ? depth_on(corner, *ray) : std::nullopt;
        if (!depth || !is_in_front_of_eye(*depth))
            return;
        double back = 0;
        if (request_.faces == FaceStyle::hidden) {
            const double tilt = length(Vec2{normal.x, normal.y}) /
                                std::max(std::fabs(dot(normal, ray->direction)), 1e-9 * size);
            back = std::min(tilt, steepest) * pixel * (std::fabs(*depth) + optics.medium().t);
        }
        raster_.draw_at(index, *depth + back, colour);
    });
}

} // namespace integral
