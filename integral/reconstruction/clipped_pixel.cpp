// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/clipped_pixel.h"

#include "integral/optics/beam.h"

namespace integral {

namespace {

/// Part of a pixel's width or height that is behind its lens, in pixels from the centre.
struct Span {
    double begin = -0.5, end = 0.5;

    double middle() const { return 0.5 * (begin + end); }
    double length() const { return end - begin; }
};

/// The part of a horizontal (or vertical) line through a pixel that is behind the lens `own`. Sets
/// `lens` to that lens, with its full indices. at(u): pixel coordinates of the point u pixels from
/// the line's middle.
template <class At>
Span span_behind(const IntegralCamera& camera, LightFieldImage::StoredLens own, At at,
                 std::optional<LensIndex>& lens)
{
    RayRun<Vec2> film_points;
    for (int k = 0; k < run_length; ++k)
        film_points[k] = film_from_pixel(camera.film, at((k + 0.5) / run_length - 0.5));
    RayRun<MappedPoint> mapped;
    camera.optics.map_run(run_length, film_points, camera.mapping, mapped);
    const auto is_own = [&](int k) {
        return mapped[k].ray && LightFieldImage::stored(mapped[k].ray->lens) == own;
    };
    int first = run_length / 2, last = first - 1;
    while (first > 0 && is_own(first - 1))
        --first;
    while (last + 1 < run_length && is_own(last + 1))
        ++last;
    if (last < first)
        return {};
    lens = mapped[first].ray->lens;
    return {double(first) / run_length - 0.5, double(last + 1) / run_length - 0.5};
}

} // namespace

std::optional<ClippedPixel> cut_pixel(const IntegralCamera& camera, const LightFieldImage& first,
                                      int x, int y)
{
    const auto own = first.lens(x, y);
    const Vec2 middle{x + 0.5, y + 0.5};
    std::optional<LensIndex> lens;
    Span across, down;
    if (first.lens(x - 1, y) != own || first.lens(x + 1, y) != own)
        across = span_behind(
            camera, *own,
            [&](double u) {
                return middle + Vec2{u, 0};
            },
            lens);
    if (first.lens(x, y - 1) != own || first.lens(x, y + 1) != own)
        down = span_behind(
            camera, *own,
            [&](double v) {
                return middle + Vec2{across.middle(), v};
            },
            lens);
    if (!lens || (across.length() == 1 && down.length() == 1))
        return {};
    const Vec2 part_middle = middle + Vec2{across.middle(), down.middle()};
    const auto ray = camera.optics.ray_through(film_from_pixel(camera.film, part_middle), *lens);
    if (!ray)
        return {};
    return ClippedPixel{light_field_ray(camera.optics.lattice(), pole_beam(*ray)),
                        {across.length(), down.length()}};
}

} // namespace integral
