// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/page_corners.h"

#include "integral/analysis/least_squares.h"
#include "integral/analysis/page_targets.h"
#include "integral/analysis/photo_plane.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

/// Half the distance in the photo from a page point to one `side` mm away, the least over both
/// directions.
double reach_of(const PhotoCamera& camera, Vec2 page, double side)
{
    const Vec2 at = photo_from_page(camera, {page.x, page.y, 0}),
               right = photo_from_page(camera, {page.x + side, page.y, 0}),
               up = photo_from_page(camera, {page.x, page.y + side, 0});
    return 0.5 * std::min(length(right - at), length(up - at));
}

/// Fits the camera to corners: twice, the second time without those that are far off.
PhotoCamera fitted(const PhotoCamera& start, std::vector<PageCorner>& corners, Vec2 size)
{
    constexpr double prior_pixel = 0.3; // pixels that count like a prior's standard deviation
    PhotoCamera camera = start;
    for (int round = 0; round < 2; ++round) {
        LeastSquaresProblem problem;
        problem.steps = camera_steps();
        problem.residuals = [&](const std::vector<double>& parameters) {
            const PhotoCamera there = changed(camera, parameters.data(), size.x);
            std::vector<double> residuals;
            for (const PageCorner& corner : corners) {
                const Vec2 off = photo_from_page(there, {corner.page.x, corner.page.y, 0}) -
                                 corner.photo;
                residuals.push_back(off.x);
                residuals.push_back(off.y);
            }
            for (const double prior : unusual(there, size))
                residuals.push_back(prior_pixel * prior);
            return residuals;
        };
        const auto fit = least_squares(problem, std::vector<double>(camera_parameters));
        camera = changed(camera, fit.parameters.data(), size.x);
        if (corners.size() < 6)
            break;
        std::vector<double> off;
        for (std::size_t k = 0; k < corners.size(); ++k)
            off.push_back(std::hypot(fit.residuals[2 * k], fit.residuals[2 * k + 1]));
        std::vector<double> sorted = off;
        std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
        const double most = std::max(0.15, 4 * sorted[sorted.size() / 2]);
        std::vector<PageCorner> near;
        for (std::size_t k = 0; k < corners.size(); ++k)
            if (off[k] < most)
                near.push_back(corners[k]);
        corners = near;
    }
    return camera;
}

} // namespace

std::optional<Vec2> corner_near(const Plane& photo, Vec2 start, double reach)
{
    constexpr double accurate = 1e-3;
    Vec2 at = start;
    for (int step = 0; step < 20; ++step) {
        double xx = 0, xy = 0, yy = 0, x = 0, y = 0;
        const int left = int(std::floor(at.x - reach)), right = int(std::ceil(at.x + reach)),
                  top = int(std::floor(at.y - reach)), bottom = int(std::ceil(at.y + reach));
        if (left < 1 || top < 1 || right >= photo.width - 1 || bottom >= photo.height - 1)
            return std::nullopt;
        for (int j = top; j <= bottom; ++j)
            for (int i = left; i <= right; ++i) {
                const Vec2 from{i + 0.5 - at.x, j + 0.5 - at.y};
                const double far = dot(from, from) / (reach * reach);
                if (far >= 1)
                    continue;
                const double gx = 0.5 * (photo.at(i + 1, j) - photo.at(i - 1, j)),
                             gy = 0.5 * (photo.at(i, j + 1) - photo.at(i, j - 1)),
                             weight = (1 - far) * (1 - far), along = gx * from.x + gy * from.y;
                xx += weight * gx * gx;
                xy += weight * gx * gy;
                yy += weight * gy * gy;
                x += weight * gx * along;
                y += weight * gy * along;
            }
        const double det = xx * yy - xy * xy;
        if (!(det > 0.05 * (xx + yy) * (xx + yy) / 4)) // edges of one direction alone
            return std::nullopt;
        const Vec2 moved{(yy * x - xy * y) / det, (xx * y - xy * x) / det};
        at = at + moved;
        if (!(length(at - start) < reach))
            return std::nullopt;
        if (length(moved) < accurate)
            return at;
    }
    return std::nullopt;
}

std::vector<double> camera_steps()
{
    return {1e-5, 1e-5, 1e-5, 1e-2, 1e-2, 1e-2, 1e-5, 1e-5, 1e-5, 1e-4, 1e-4, 1e-5, 1e-5};
}

PhotoCamera changed(const PhotoCamera& camera, const double* parameters, double width)
{
    const double* p = parameters;
    PhotoCamera there = turned(camera, {p[0], p[1], p[2]});
    there.place = there.place + Vec3{p[3], p[4], p[5]};
    there.focal *= std::exp(p[6]);
    there.middle = there.middle + width * Vec2{p[7], p[8]};
    there.k1 += p[9];
    there.k2 += p[10];
    there.tangential = there.tangential + Vec2{p[11], p[12]};
    return there;
}

std::array<double, 7> unusual(const PhotoCamera& camera, Vec2 size)
{
    const double width = std::max(size.x, size.y);
    const Vec2 off = (1 / (0.005 * width)) * (camera.middle - 0.5 * size);
    return {std::log(camera.focal / (0.72 * width)) / 0.4,
            off.x,
            off.y,
            camera.k1 / 0.05,
            camera.k2 / 0.1,
            camera.tangential.x / 0.0005,
            camera.tangential.y / 0.0005};
}

PageView find_page(const Plane& photo, const std::array<Vec2, 4>& targets,
                   const std::vector<Vec2>& corners)
{
    constexpr int rounds = 5;
    constexpr std::size_t least = 6;                      // corners
    constexpr double least_reach = 1.5, most_reach = 200; // pixels
    const Vec2 size{double(photo.width), double(photo.height)};
    const double side = length(corners.at(1) - corners.at(0));
    PageView view;
    view.camera = camera_from_four(targets, find_page_targets(photo), size);
    const double farthest = 0.5 * std::max(length(targets[1] - targets[0]),
                                           length(targets[3] - targets[0]));
    for (int round = 1; round <= rounds; ++round) {
        view.corners.clear();
        for (const Vec2 page : corners) {
            double near = farthest;
            for (const Vec2 target : targets)
                near = std::min(near, length(page - target));
            if (near > farthest * round / (rounds - 1))
                continue;
            const Vec2 start = photo_from_page(view.camera, {page.x, page.y, 0});
            const double reach = 0.8 * reach_of(view.camera, page, side);
            if (!(is_inside(photo, start) && reach > least_reach && reach < most_reach))
                continue;
            if (const auto at = corner_near(photo, start, reach))
                view.corners.push_back({page, *at});
        }
        if (view.corners.size() < least)
            break;
        view.camera = fitted(view.camera, view.corners, size);
    }
    if (view.corners.size() < corners.size() / 2)
        throw std::invalid_argument(
            "less than half of the squares between the rings are visible; photograph the page "
            "without anything on its squares, sharp, and give the options that the page was made "
            "with");
    return view;
}

} // namespace integral
