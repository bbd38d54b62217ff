// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws faces behind one lens: each pixel that may see a triangle tests it along its own ray.
#include "integral/wireframe/lens_drawing.h"

#include <algorithm>

namespace integral {
namespace {

/// z at which a ray meets a triangle; nothing if it misses.
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

/// Range of the film offsets t s/sqrt(n^2 + m (s^2 + o^2)) for s in `slope` and o in `other`.
LensDrawing::Interval LensDrawing::film_offsets(const Medium& medium, Interval slope,
                                                Interval other)
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

/// Sets the rays of the raster's pixels.
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

/// Pixels that may see the triangle. Seen through the pole, a triangle on one side of the sheet is
/// a triangle of slopes s; its corners are imaged at the vertices' film points. Between the
/// corners, the film points t s/sqrt(n^2 + m s^2) deviate from a straight triangle by at most a
/// sixth of their greatest second derivative, 2.3 t sqrt(m)/n^2, times the square of the triangle's
/// extent in slopes.
PixelBox LensDrawing::box_of(const MeshTriangle& triangle) const
{
    const SheetOptics& optics = request_.optics;
    if (optics.sheet().arrangement == Arrangement::lenticular ||
        refracts_at_surface(optics.model()))
        return box_by_slopes(triangle);
    Interval across, down, slope_x, slope_y, z;
    for (const std::uint32_t vertex : triangle.vertex) {
        const Vec3 s = mesh_.vertices[vertex];
        const Vec2* pixel = vertices_.of(vertex);
        if (!pixel || !limits_.is_seen(s.z))
            return raster_.box();
        across.add(pixel->x);
        down.add(pixel->y);
        const double nearness = 1 / s.z;
        slope_x.add((s.x - pole_.x) * nearness);
        slope_y.add((s.y - pole_.y) * nearness);
        z.add(s.z);
    }
    if (z.least <= 0 && z.most >= 0)
        return box_by_slopes(triangle);
    const Medium& medium = optics.medium();
    const double wide = slope_x.most - slope_x.least, high = slope_y.most - slope_y.least,
                 bulge = 0.4 * medium.t * medium.root_m / (medium.n * medium.n) *
                         (wide * wide + high * high);
    const Vec2 margin{bulge / request_.film.pixel_pitch.x, bulge / request_.film.pixel_pitch.y};
    return centres_within({across.least - margin.x, across.most + margin.x},
                          {down.least - margin.y, down.most + margin.y});
}

/// Does the same as box_of for any lens and triangle, at more cost. The line from a scene point
/// through the pole leaves the lens at P and meets the aperture plane at A; its slope is (P - A)/d.
/// Over a triangle on one side of the sheet, P and A have their extremes at the corners. Where a
/// triangle crosses the sheet, A is only known to be within the aperture.
PixelBox LensDrawing::box_by_slopes(const MeshTriangle& triangle) const
{
    const SheetOptics& optics = request_.optics;
    const double d = optics.aperture().distance;
    Interval px, py, ax, ay;
    double spread = 0;
    int sides = 0;
    const double next_to = 1e-6 * optics.sheet().thickness;
    for (const std::uint32_t vertex : triangle.vertex) {
        const Vec3 s = mesh_.vertices[vertex];
        if (!vertices_.of(vertex) || !limits_.is_seen(s.z))
            return raster_.box();
        sides |= s.z > next_to ? 1 : s.z < -next_to ? 2 : 3;
        const Vec2 p = leaving_point(optics, s, lens_), a = p + (d / s.z) * (p - Vec2{s.x, s.y});
        px.add(p.x);
        py.add(p.y);
        ax.add(a.x);
        ay.add(a.y);
        if (!refracts_at_surface(optics.model()))
            continue;
        if (std::fabs(s.z) < optics.sheet().thickness) // its rays spread too unevenly
            return raster_.box();
        const auto pole = film_point_imaging(optics, s, lens_),
                   seen = film_point_imaging(optics, s, lens_, picture_.through);
        if (!pole || !seen)
            return raster_.box();
        spread = std::max(spread, 2 * length(*seen - *pole));
    }
    if (sides == 3) {
        const Vec2 half{0.5 * optics.aperture().width + aperture_margin_,
                        0.5 * optics.aperture().height + aperture_margin_};
        if (request_.pseudoscopic || refracts_at_surface(optics.model()) ||
            !std::isfinite(half.x + half.y))
            return raster_.box();
        ax = {-half.x, half.x};
        ay = {-half.y, half.y};
    }
    const Interval slope_x{(px.least - ax.most) / d, (px.most - ax.least) / d},
        slope_y{(py.least - ay.most) / d, (py.most - ay.least) / d};
    const Interval x = film_offsets(optics.medium(), slope_x, slope_y),
                   y = film_offsets(optics.medium(), slope_y, slope_x);
    return pixels_within({px.least + x.least - spread, px.most + x.most + spread},
                         {py.least + y.least - spread, py.most + y.most + spread});
}

/// The raster's pixels that show film points of a rectangle.
PixelBox LensDrawing::pixels_within(Interval x, Interval y) const
{
    Interval across, down;
    for (const Vec2 corner : {Vec2{x.least, y.least}, Vec2{x.most, y.least}, Vec2{x.least, y.most},
                              Vec2{x.most, y.most}}) {
        const Vec2 shown = request_.pseudoscopic ? mirrored_in_lens(request_.optics, corner, lens_)
                                                 : corner;
        const Vec2 pixel = pixel_from_film(request_.film, shown) - shift_;
        across.add(pixel.x);
        down.add(pixel.y);
    }
    return centres_within(across, down);
}

/// The raster's pixels whose centres, k + 0.5, lie in a rectangle of pixel coordinates.
PixelBox LensDrawing::centres_within(Interval across, Interval down) const
{
    constexpr double rounding = 1e-6;
    const PixelBox all = raster_.box();
    const auto first = [](double v, int least, int most) {
        return most - int(std::clamp(most - v + 0.5 + rounding, 0.0, double(most - least)));
    };
    const auto end = [](double v, int least, int most) {
        return least + int(std::clamp(v + 0.5 + rounding - least, 0.0, double(most - least)));
    };
    return {first(across.least, all.left, all.right), first(down.least, all.top, all.bottom),
            end(across.most, all.left, all.right), end(down.most, all.top, all.bottom)};
}

void LensDrawing::draw(const MeshTriangle& triangle)
{
    const PixelBox box = box_of(triangle);
    if (box.left < box.right && box.top < box.bottom)
        paint(triangle, box);
}

Colour LensDrawing::shade(const MeshTriangle& triangle, Vec3 corner, Vec3 normal) const
{
    if (request_.faces != FaceStyle::flat)
        return request_.background;
    constexpr double ambient = 0.2;
    const Vec3 to_eye = Vec3{0, 0, -request_.optics.aperture().distance} - corner;
    const double facing = dot(normal, to_eye) < 0 ? -1 : 1;
    const double lit = facing * dot(normal, request_.light) /
                       (length(normal) * length(request_.light));
    const float share = float(ambient + (1 - ambient) * std::max(lit, 0.0));
    return {share * triangle.colour.r, share * triangle.colour.g, share * triangle.colour.b, 1};
}

/// Draws a triangle on the pixels of a box that see it.
void LensDrawing::paint(const MeshTriangle& triangle, const PixelBox& box)
{
    const auto& all = mesh_.vertices;
    const std::array<Vec3, 3> corner{all[triangle.vertex[0]], all[triangle.vertex[1]],
                                     all[triangle.vertex[2]]};
    if (sights_.empty())
        see_faces();
    const float nearest = float(std::min({corner[0].z, corner[1].z, corner[2].z}));
    raster_.for_each_pixel_in(box, [&](std::size_t index, int, int) {
        const auto& ray = sights_[index];
        const bool is_hidden = !raster_.is_seen_at(index, nearest);
        const auto seen = ray && !is_hidden ? depth_on(corner, *ray) : std::nullopt;
        if (!seen || !limits_.is_seen(*seen) || !raster_.is_seen_at(index, float(*seen)))
            return;
        const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
        const double depth = *seen + (request_.faces == FaceStyle::hidden
                                          ? put_back(normal, ray->direction, *seen)
                                          : 0);
        raster_.draw_at(index, float(depth), shade(triangle, corner[0], normal));
    });
}

/// Depth by which a face is moved back so that it does not hide its own edges. An edge's pixels see
/// the face next to the edge, where the face may lie in front.
double LensDrawing::put_back(Vec3 normal, Vec3 direction, double depth) const
{
    constexpr double steepest = 16;
    const Medium& medium = request_.optics.medium();
    const double pixel = std::max(request_.film.pixel_pitch.x, request_.film.pixel_pitch.y) *
                         medium.n / medium.t;
    const double tilt = length(Vec2{normal.x, normal.y}) /
                        std::max(std::fabs(dot(normal, direction)), 1e-9 * length(normal));
    return std::min(tilt, steepest) * pixel * (std::fabs(depth) + medium.t);
}

} // namespace integral
