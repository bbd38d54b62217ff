// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/lens_drawing.h"

#include "integral/wireframe/lens_bins.h"

#include <algorithm>

namespace integral {
namespace {

constexpr double straight = 2;     // pixels; pieces of a line up to this length are drawn as chords
constexpr double bulge = 0.1;      // pixels by which a longer piece may differ from its chord
constexpr double not_clipped = 20; // pixels; lines up to this length are drawn without clipping
constexpr int most_splits = 12;

/// Narrows a span to where a + part * slope >= 0.
template <class Span> void keep_positive(double a, double slope, Span& span)
{
    if (slope > 0)
        span.first = std::max(span.first, -a / slope);
    else if (slope < 0)
        span.last = std::min(span.last, -a / slope);
    else if (a < 0)
        span.last = -1;
}

Colour between(Colour a, Colour b, double t)
{
    const float u = float(t), v = 1 - u;
    return {v * a.r + u * b.r, v * a.g + u * b.g, v * a.b + u * b.b, 1};
}

} // namespace

LensDrawing::LensDrawing(const WireframeRequest& request, LensIndex lens, Vec2 shift,
                         const SharpPicture& picture, VertexFilm& vertices, LensRaster& raster)
    : request_(request),
      block_(vertices.block()),
      mesh_(block_.mesh),
      lens_(lens),
      shift_(shift),
      pole_(request.optics.lattice().pole(lens)),
      picture_(picture),
      vertices_(vertices),
      raster_(raster),
      limits_(depth_limits(request))
{
    const SheetOptics& optics = request.optics;
    const double distance = optics.aperture().distance, thickness = optics.sheet().thickness;
    // A pixel sees more than the pixel's centre does, and may see just outside the aperture.
    aperture_margin_ = 4 * optics.medium().n * distance / thickness *
                       std::max(request.film.pixel_pitch.x, request.film.pixel_pitch.y);
}

inline FilmCorner LensDrawing::corner_at(const Vec2* pixel, double depth, Colour colour) const
{
    if (picture_.share[0] == 1)
        return {pixel[0], depth, colour};
    Vec2 at;
    for (std::size_t k = 0; k < picture_.share.size(); ++k)
        if (picture_.share[k] != 0)
            at = at + picture_.share[k] * pixel[k];
    return {at, depth, colour};
}

std::optional<FilmCorner> LensDrawing::corner(const Vec2* pixel, double depth, Colour colour) const
{
    if (!pixel)
        return std::nullopt;
    return corner_at(pixel, depth, colour);
}

std::optional<FilmCorner> LensDrawing::corner(const End& end) const
{
    return corner(vertices_.of_point(end.point), end.point.z, end.colour);
}

LensDrawing::End LensDrawing::at(const MeshLine& line, double part) const
{
    const auto& all = mesh_.vertices;
    const Vec3 from = all[line.vertex[0]], to = all[line.vertex[1]];
    return {from + part * (to - from), between(line.colour[0], line.colour[1], part)};
}

/// Covers the lens with a point too near to be focused: all pixels of the lens or, if the lens is
/// lenticular, the row at the point's height.
void LensDrawing::cover(Vec3 point, Colour colour)
{
    const SheetOptics& optics = request_.optics;
    if (optics.lattice().nearest({point.x, point.y}) != lens_)
        return;
    if (optics.sheet().arrangement != Arrangement::lenticular)
        return raster_.fill(point.z, colour);
    const double apart = 1e-6 *
                         limits_.near; // in the plane of the poles, points have no film point
    Vec3 imaged = point;
    if (std::fabs(imaged.z) < apart)
        imaged.z = apart;
    if (const auto film = corner({imaged, colour}))
        raster_.fill_row(int(std::floor(film->pixel.y)), point.z, colour);
}

void LensDrawing::draw(const MeshPoint& point)
{
    const Vec3 at = mesh_.vertices[point.vertex];
    if (!limits_.is_seen(at.z))
        return;
    if (std::fabs(at.z) <= limits_.near)
        return cover(at, point.colour);
    if (const auto film = corner(vertices_.of(point.vertex), at.z, point.colour))
        raster_.draw_point(*film);
}

void LensDrawing::draw(const MeshLine& line)
{
    const auto& all = mesh_.vertices;
    const Vec3 from = all[line.vertex[0]], to = all[line.vertex[1]], way = to - from;
    const double least = std::min(from.z, to.z), most = std::max(from.z, to.z);
    if (limits_.is_far(least, most)) {
        const Vec2* start = vertices_.of(line.vertex[0]);
        const Vec2* end = start ? vertices_.of(line.vertex[1]) : start;
        if (start && end && draw_short(line, start, end))
            return;
    }
    Span seen;
    keep_positive(from.z - limits_.foremost, way.z, seen);
    Span behind = seen, before = seen, beside = seen;
    keep_positive(from.z - limits_.behind, way.z, behind);
    keep_in_aperture(from, way, true, behind);
    draw_far(line, behind);
    keep_positive(-from.z - limits_.before, -way.z, before);
    keep_in_aperture(from, way, false, before);
    draw_far(line, before);
    if (limits_.near == 0)
        return;
    keep_positive(limits_.near - from.z, -way.z, beside);
    keep_positive(limits_.near + from.z, way.z, beside);
    draw_near(line, beside);
}

/// Draws a far line from the film points of its ends if they are near to each other. Returns
/// whether the line was drawn.
bool LensDrawing::draw_short(const MeshLine& line, const Vec2* start, const Vec2* end)
{
    const Vec3 from = mesh_.vertices[line.vertex[0]], to = mesh_.vertices[line.vertex[1]];
    const FilmCorner a = corner_at(start, from.z, line.colour[0]),
                     b = corner_at(end, to.z, line.colour[1]);
    const Vec2 chord = b.pixel - a.pixel;
    const double square = dot(chord, chord);
    if (square > not_clipped * not_clipped)
        return false;
    if (square <= straight * straight)
        raster_.draw_line(a, b);
    else
        draw_curve({from, line.colour[0]}, a, {to, line.colour[1]}, b, 0);
    return true;
}

/// Narrows the span to what the aperture may see through the lens. The line from a scene point S
/// through the pole's coordinate p meets the aperture's plane, z = e, at p + (p - S) (-e)/z, so
/// that |p (z - e) + e S| is at most |z| times the aperture's half extent: a bound that is linear
/// along the line. The extent is taken a little larger, as the pixels set the exact limit.
void LensDrawing::keep_in_aperture(Vec3 from, Vec3 way, bool behind, Span& span) const
{
    const SheetOptics& optics = request_.optics;
    const Aperture& aperture = optics.aperture();
    const double eye = eye_depth(optics, request_.pseudoscopic), d = aperture.distance,
                 cell = cell_circumradius(optics.sheet()), sign = behind ? 1 : -1;
    const auto keep = [&](Vec2 axis, double half) {
        if (!std::isfinite(half))
            return;
        const double wide = half + aperture_margin_ + cell, p = dot(axis, pole_);
        const auto excess = [&](Vec3 s) {
            return p * (s.z - eye) + eye * dot(axis, Vec2{s.x, s.y});
        };
        const double g = excess(from), slope = excess(from + way) - g;
        const double bound = wide * sign * from.z + cell * d, growth = wide * sign * way.z;
        keep_positive(bound - g, growth - slope, span);
        keep_positive(bound + g, growth + slope, span);
    };
    const double x = 0.5 * aperture.width, y = 0.5 * aperture.height;
    if (optics.sheet().arrangement == Arrangement::lenticular) {
        const Vec2 across = optics.lattice().across();
        keep(across, std::fabs(across.x) * x + std::fabs(across.y) * y);
        return;
    }
    keep({1, 0}, x);
    keep({0, 1}, y);
}

void LensDrawing::draw_far(const MeshLine& line, Span span)
{
    if (!span.is_empty())
        draw_piece(at(line, span.first), at(line, span.last), 0);
}

/// Draws a piece whose ends may have no film point, because of total internal reflection.
void LensDrawing::draw_piece(const End& a, const End& b, int splits)
{
    const auto film_a = corner(a), film_b = corner(b);
    if (film_a && film_b)
        return draw_curve(a, *film_a, b, *film_b, splits);
    constexpr int most_searched = 7;
    if (splits == most_searched)
        return;
    const End middle = half_way(a, b);
    draw_piece(a, middle, splits + 1);
    draw_piece(middle, b, splits + 1);
}

LensDrawing::End LensDrawing::half_way(const End& a, const End& b)
{
    return {0.5 * (a.point + b.point), between(a.colour, b.colour, 0.5)};
}

/// Draws a piece in chords, as a lens images a straight line slightly curved.
void LensDrawing::draw_curve(const End& a, const FilmCorner& film_a, const End& b,
                             const FilmCorner& film_b, int splits)
{
    const Vec2 chord = film_b.pixel - film_a.pixel;
    const double long_way = length(chord);
    if (long_way > straight && splits < most_splits) {
        const End middle = half_way(a, b);
        const auto film = corner(middle);
        if (!film)
            return;
        const Vec2 off = film->pixel - film_a.pixel;
        const double beside = std::fabs(chord.x * off.y - chord.y * off.x) / long_way,
                     along = dot(chord, off) / (long_way * long_way);
        // The middle of a line in depth is not the middle of its image. Halves of very different
        // lengths are drawn separately, each with its own depths.
        if (beside > bulge || std::fabs(along - 0.5) > 0.1) {
            draw_curve(a, film_a, middle, *film, splits + 1);
            return draw_curve(middle, *film, b, film_b, splits + 1);
        }
    }
    raster_.draw_line(film_a, film_b);
}

void LensDrawing::draw_near(const MeshLine& line, Span span)
{
    const SheetOptics& optics = request_.optics;
    const End from = at(line, 0), to = at(line, 1);
    const Vec3 way = to.point - from.point;
    const double cell = cell_circumradius(optics.sheet());
    const auto keep = [&](Vec2 axis) {
        const double off = dot(axis, Vec2{from.point.x, from.point.y} - pole_),
                     slope = dot(axis, Vec2{way.x, way.y});
        keep_positive(cell - off, -slope, span);
        keep_positive(cell + off, slope, span);
    };
    keep(optics.lattice().across());
    if (optics.sheet().arrangement != Arrangement::lenticular)
        keep(optics.lattice().along());
    if (span.is_empty())
        return;
    const double pixel = std::min(request_.film.pixel_pitch.x, request_.film.pixel_pitch.y);
    const double long_way = (span.last - span.first) * length(Vec2{way.x, way.y});
    const int steps = int(std::clamp(std::ceil(2 * long_way / pixel), 1.0, 1e6));
    for (int k = 0; k <= steps; ++k) {
        const End end = at(line, span.first + (span.last - span.first) * k / steps);
        cover(end.point, end.colour);
    }
}

} // namespace integral
