// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/photo_camera.h"

#include "integral/analysis/least_squares.h"

#include <cmath>

namespace integral {
namespace {

Vec3 unit(Vec3 v) { return (1 / length(v)) * v; }

/// The homography's nine numbers, the last one 1, that takes page points to photo points. Both are
/// of the order of 1.
std::array<double, 9> homography(const std::array<Vec2, 4>& page, const std::array<Vec2, 4>& photo)
{
    SquareMatrix normal(8);
    std::vector<double> right(8);
    for (int k = 0; k < 4; ++k) {
        const Vec2 p = page[k], q = photo[k];
        const std::array<double, 8> rows[] = {{p.x, p.y, 1, 0, 0, 0, -q.x * p.x, -q.x * p.y},
                                              {0, 0, 0, p.x, p.y, 1, -q.y * p.x, -q.y * p.y}};
        const double values[] = {q.x, q.y};
        for (int r = 0; r < 2; ++r)
            for (int i = 0; i < 8; ++i) {
                right[i] += rows[r][i] * values[r];
                for (int j = 0; j < 8; ++j)
                    normal.at(i, j) += rows[r][i] * rows[r][j];
            }
    }
    std::array<double, 9> h{};
    h[8] = 1;
    if (const auto solved = solve_positive(normal, right))
        std::copy(solved->begin(), solved->end(), h.begin());
    return h;
}

/// The camera of a focal length whose axes are nearest to a homography's (in focal lengths from the
/// principal point).
PhotoCamera camera_of(const std::array<double, 9>& h, double focal, Vec2 middle)
{
    const Vec3 a{h[0] / focal, h[3] / focal, h[6]}, b{h[1] / focal, h[4] / focal, h[7]},
        t{h[2] / focal, h[5] / focal, h[8]};
    const double scale = 2 / (length(a) + length(b));
    const Vec3 sum = unit(unit(a) + unit(b)), apart = unit(unit(a) - unit(b));
    const Vec3 x = std::sqrt(0.5) * (sum + apart), y = std::sqrt(0.5) * (sum - apart),
               z = cross(x, y), to_page = scale * t;
    PhotoCamera camera;
    camera.right = {x.x, y.x, z.x};
    camera.down = {x.y, y.y, z.y};
    camera.forward = {x.z, y.z, z.z};
    camera.place = {-dot(x, to_page), -dot(y, to_page), -dot(z, to_page)};
    camera.focal = focal;
    camera.middle = middle;
    return camera;
}

/// Factor by which distortion moves a point away from the principal point, without r^2 t.
double swell(const PhotoCamera& camera, Vec2 at)
{
    const double r2 = dot(at, at);
    return 1 + r2 * (camera.k1 + camera.k2 * r2) + 2 * dot(camera.tangential, at);
}

} // namespace

Vec2 photo_from_page(const PhotoCamera& camera, Vec3 point)
{
    const Vec3 from = point - camera.place;
    const double depth = dot(camera.forward, from);
    const Vec2 at{dot(camera.right, from) / depth, dot(camera.down, from) / depth};
    return camera.middle +
           camera.focal * (swell(camera, at) * at + dot(at, at) * camera.tangential);
}

Vec3 direction_from_photo(const PhotoCamera& camera, Vec2 pixel)
{
    const Vec2 seen = (1 / camera.focal) * (pixel - camera.middle);
    Vec2 at = seen;
    for (int k = 0; k < 20; ++k) {
        const Vec2 next = (1 / swell(camera, at)) * (seen - dot(at, at) * camera.tangential);
        const double moved = length(next - at);
        at = next;
        if (moved < 1e-12)
            break;
    }
    return unit(at.x * camera.right + at.y * camera.down + camera.forward);
}

PhotoCamera turned(PhotoCamera camera, Vec3 by)
{
    const double angle = length(by);
    if (angle == 0)
        return camera;
    const Vec3 axis = (1 / angle) * by;
    const double c = std::cos(angle), s = std::sin(angle);
    for (Vec3* v : {&camera.right, &camera.down, &camera.forward})
        *v = c * *v + s * cross(axis, *v) + ((1 - c) * dot(axis, *v)) * axis;
    return camera;
}

PhotoCamera camera_from_four(const std::array<Vec2, 4>& page, const std::array<Vec2, 4>& photo,
                             Vec2 size)
{
    constexpr double usual = 0.72; // focal length of a phone's camera, widths of the photo
    const double width = std::max(size.x, size.y);
    const Vec2 middle = 0.5 * size;
    double scale = 1e-30;
    for (const Vec2 point : page)
        scale = std::max(scale, length(point));
    std::array<Vec2, 4> from, to;
    for (int k = 0; k < 4; ++k) {
        from[k] = (1 / scale) * page[k];
        to[k] = (1 / width) * (photo[k] - middle);
    }
    const auto h = homography(from, to);
    PhotoCamera best;
    double least = 1e300;
    for (double focal = 0.4; focal < 4; focal *= 1.04) {
        PhotoCamera camera = camera_of(h, focal, middle);
        camera.focal *= width;
        camera.place = scale * camera.place;
        const double unusual = std::log(focal / usual);
        double error = 0.01 * unusual * unusual;
        for (int k = 0; k < 4; ++k) {
            const Vec2 off = photo_from_page(camera, {page[k].x, page[k].y, 0}) - photo[k];
            error += dot(off, off) / (width * width) * 1e4;
        }
        if (camera.place.z > 0 && error < least) {
            least = error;
            best = camera;
        }
    }
    return best;
}

} // namespace integral
