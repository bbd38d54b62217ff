// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws the many lines and triangles behind one lens that are about as large as its pixels: most
// are finished once the pixels of their corners are known.
#include "integral/wireframe/lens_drawing.h"

namespace integral {
namespace {

Colour middle_of(const std::array<Colour, 2>& c)
{
    return {0.5f * (c[0].r + c[1].r), 0.5f * (c[0].g + c[1].g), 0.5f * (c[0].b + c[1].b), 1};
}

/// Calls visit(number) for each far thing that may be partly in front of the drawing, and for some
/// that are not. apart(thing): difference of its corners' raster indices. Tests many things at
/// once, without branches, before drawing any of these.
template <std::size_t corners, class Apart, class Visit>
void for_each_in_front(const std::vector<FarThing<corners>>& things, const int* place,
                       const LensRaster& raster, Apart apart, Visit visit)
{
    constexpr std::size_t together = 256;
    const float* drawn = raster.depths();
    const int stride = raster.stride();
    std::array<std::uint32_t, together> list;
    for (std::size_t first = 0; first < things.size(); first += together) {
        const std::size_t end = std::min(first + together, things.size());
        std::size_t count = 0;
        for (std::size_t k = first; k < end; ++k) {
            const FarThing<corners>& thing = things[k];
            float farthest = drawn[place[thing.vertex[0]]];
            for (std::size_t c = 1; c < corners; ++c)
                farthest = std::max(farthest, drawn[place[thing.vertex[c]]]);
            // A thing in one place, or in two adjacent places, touches no third place.
            const int steps = apart(thing);
            const bool elsewhere = (steps > 1) & (steps != stride);
            list[count] = std::uint32_t(k);
            count += (thing.nearest < farthest) | elsewhere;
        }
        for (std::size_t k = 0; k < count; ++k)
            visit(list[k]);
    }
}

} // namespace

void LensDrawing::draw_all()
{
    const auto draw_near_ones = [&](const auto& things, const std::vector<LensRange>& ranges) {
        for (std::size_t k = 0; k < things.size(); ++k)
            if (ranges[k].contains(lens_))
                draw(things[k]);
    };
    draw_far_triangles();
    draw_near_ones(mesh_.triangles, block_.ranges[2]);
    draw_far_lines();
    draw_near_ones(mesh_.lines, block_.ranges[1]);
    draw_near_ones(mesh_.points, block_.ranges[0]);
}

void LensDrawing::draw_far_lines()
{
    const auto& lines = block_.far_lines;
    if (!vertices_.is_together()) {
        for (const MeshLine& line : lines)
            draw(line);
        return;
    }
    const int* place = vertices_.places();
    const auto apart = [&](const FarThing<2>& line) {
        return std::abs(place[line.vertex[1]] - place[line.vertex[0]]);
    };
    for_each_in_front(block_.line_fronts, place, raster_, apart, [&](std::size_t k) {
        const FarThing<2>& front = block_.line_fronts[k];
        const auto [a, b] = front.vertex;
        if (place[a] == place[b]) {
            const auto at = std::size_t(place[a]);
            if (raster_.is_seen_at(at, front.nearest))
                raster_.draw_at(at, front.nearest, middle_of(lines[k].colour));
        } else if (may_be_seen(place[a], place[b], front.nearest) &&
                   !draw_short(lines[k], vertices_.of(a), vertices_.of(b)))
            draw(lines[k]);
    });
}

/// Whether a line with ends in two different places, and no part nearer than `nearest`, may be in
/// front of the drawing. False for lines that the lens cannot image.
bool LensDrawing::may_be_seen(int from, int to, float nearest) const
{
    const auto is_seen = [&](int place) { return raster_.is_seen_at(std::size_t(place), nearest); };
    const int nowhere = raster_.nowhere(), stride = raster_.stride(), way = to - from,
              steps = std::abs(way);
    if (from == nowhere || to == nowhere)
        return false;
    if (steps == 1 || steps == stride)
        return is_seen(from) || is_seen(to);
    if (steps != stride - 1 && steps != stride + 1)
        return true;
    // The two places beside the diagonal; on the border, one of them may lie beyond the raster.
    const int down = way > 0 ? stride : -stride;
    const auto is_seen_beside = [&](int place) {
        return place >= 0 && place <= nowhere && is_seen(place);
    };
    return is_seen(from) || is_seen(to) || is_seen_beside(from + down) || is_seen_beside(to - down);
}

/// Bound on the deviation (pixels) of a triangle's film points from a straight triangle, divided by
/// the square of the triangle's extent in pixels. It holds for extents up to most_extent, anywhere
/// in the raster. Derived like the bound in box_of, with the extent in slopes bounded by the
/// extent in pixels: a film point at the distance q from the pole has the slope
/// s = n q / sqrt(t^2 - m q^2), which grows by n t^2 / (t^2 - m q^2)^(3/2) per mm, most at the
/// raster's farthest q.
double LensDrawing::bulge_by_pixel() const
{
    const Medium& medium = request_.optics.medium();
    const Vec2 pitch = request_.film.pixel_pitch;
    const PixelBox& box = raster_.box();
    double farthest = 0;
    for (const double x : {box.left - extent_beside, box.right + extent_beside})
        for (const double y : {box.top - extent_beside, box.bottom + extent_beside}) {
            const Vec2 q = film_from_pixel(request_.film, Vec2{x, y} + shift_) - pole_;
            farthest = std::max(farthest, dot(q, q));
        }
    const double clear = medium.t * medium.t - medium.m * farthest;
    if (!(clear > 0))
        return 1e9;
    const double steepest = medium.n * medium.t * medium.t / (clear * std::sqrt(clear));
    return 0.8 * medium.t * medium.root_m / (medium.n * medium.n) * steepest * steepest *
           std::max(pitch.x, pitch.y) * std::max(pitch.x, pitch.y) / std::min(pitch.x, pitch.y);
}

namespace {

/// The pixels of a raster whose centres, k + 0.5, lie between an extent's coordinates.
PixelBox pixels_centred_within(const FilmExtent& extent, float margin, const PixelBox& raster)
{
    constexpr float apart = extent_beside + 2.5f; // makes the truncated number positive
    constexpr int whole = int(extent_beside) + 2;
    const auto first = [&](int k) { return int(extent[k] - margin + apart) - whole; };
    const auto end = [&](int k) { return int(-extent[k] + margin + apart) - whole; };
    return {raster.left + first(0), raster.top + first(1), raster.left + end(2),
            raster.top + end(3)};
}

/// Distance between the places of a triangle's corners if these are one or two places; 2 if three.
/// With three places, or two that are not adjacent, the triangle may touch other places.
int places_apart(int a, int b, int c)
{
    const int least = std::min({a, b, c}), most = std::max({a, b, c});
    const auto is_end = [&](int place) { return (place == least) | (place == most); };
    return is_end(a) & is_end(b) & is_end(c) ? most - least : 2;
}

} // namespace

void LensDrawing::draw_far_triangles()
{
    const auto& triangles = block_.far_triangles;
    if (triangles.empty())
        return;
    if (!vertices_.is_together()) {
        for (const MeshTriangle& triangle : triangles)
            draw(triangle);
        return;
    }
    const int* place = vertices_.places();
    const FilmExtent* extents = vertices_.extents();
    constexpr float most_extent = 3, rounding = 2e-3f;
    const float bulge = float(bulge_by_pixel());
    const int nowhere = raster_.nowhere();
    const auto apart = [&](const FarThing<3>& triangle) {
        const auto [a, b, c] = triangle.vertex;
        return places_apart(place[a], place[b], place[c]);
    };
    for_each_in_front(block_.triangle_fronts, place, raster_, apart, [&](std::size_t k) {
        const auto [a, b, c] = triangles[k].vertex;
        if (place[a] == nowhere || place[b] == nowhere || place[c] == nowhere)
            return; // the lens cannot image the triangle
        const FilmExtent extent = extent_of_both(extent_of_both(extents[a], extents[b]),
                                                 extents[c]);
        const float wide = -extent[2] - extent[0], high = -extent[3] - extent[1],
                    margin = bulge * (wide * wide + high * high) + rounding;
        if (wide > most_extent || high > most_extent || margin > 1)
            return draw(triangles[k]);
        const PixelBox box = pixels_centred_within(extent, margin, raster_.box());
        if (box.left < box.right && box.top < box.bottom)
            paint(triangles[k], box);
    });
}

} // namespace integral
