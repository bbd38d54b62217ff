// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sampling/lens_profile.h"

#include "integral/base/constants.h"
#include <algorithm>

namespace integral {
namespace {

/// A sheet with an upright lens on the axis. All light stays near the plane y = 0, which contains
/// the slit of a lenticular sheet's aperture. So the result does not depend on `slit_distance`,
/// which must only differ from the scene's distance.
SheetOptics upright_lens(LensSheet sheet, double slit_distance)
{
    sheet.slant = 0;
    sheet.offset = {};
    return SheetOptics(sheet, {slit_distance, 1, 1, ApertureShape::rectangle}, LensModel::full);
}

/// The centres of equal parts of the lens's cell.
std::vector<LensPoint> cell_points(const Lattice& lattice, int points)
{
    const int rows = lattice.arrangement() == Arrangement::lenticular ? 1 : points;
    std::vector<LensPoint> all;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < points; ++i)
            all.push_back(cell_point(lattice, {(i + 0.5) / points, (j + 0.5) / rows}));
    return all;
}

/// The distance between the first and the last film point that lies in enough intervals: in at
/// least `share` times as many as the film point that lies in most. `ends`: the intervals' ends, as
/// described in full_image_width.
double width_at(const std::vector<std::pair<double, int>>& ends, double share)
{
    int lit = 0, most = 0;
    for (const auto& end : ends)
        most = std::max(most, lit += end.second);
    double first = 0, last = 0;
    bool begun = false;
    lit = 0;
    for (const auto& end : ends) {
        const bool before = lit >= share * most;
        lit += end.second;
        const bool after = lit >= share * most;
        if (after && !before && !begun) {
            first = end.first;
            begun = true;
        }
        if (before && !after)
            last = end.first;
    }
    return last - first;
}

double angle(Vec3 direction) { return std::atan2(-direction.x, -direction.z) * degrees_per_radian; }

} // namespace

std::optional<ImageWidth> full_image_width(const LensSheet& sheet, double distance, double width,
                                           int points)
{
    if (!has_surface(sheet))
        return std::nullopt;
    const SheetOptics optics = upright_lens(sheet, 2 * distance);
    // Light through one point of the lens fills the film between that point's images of the slit's
    // edges.
    std::vector<std::pair<double, int>> ends; // film x; +1 where such an interval begins, -1 where
                                              // it ends
    for (const LensPoint& point : cell_points(optics.lattice(), points)) {
        const auto left = film_point_imaging(optics, {0.5 * width, 0, -distance}, {}, point);
        const auto right = film_point_imaging(optics, {-0.5 * width, 0, -distance}, {}, point);
        if (!left || !right)
            continue;
        ends.emplace_back(std::min(left->x, right->x), 1);
        ends.emplace_back(std::max(left->x, right->x), -1);
    }
    if (ends.empty())
        return std::nullopt;
    std::sort(ends.begin(), ends.end());
    return ImageWidth{width_at(ends, 0.5), width_at(ends, 0.1), width_at(ends, 0.9)};
}

std::optional<BeamDirection> full_beam_direction(const LensSheet& sheet, double film, int points)
{
    if (!has_surface(sheet))
        return std::nullopt;
    const SheetOptics optics = upright_lens(sheet, 1e3);
    const auto pole = optics.ray_through({film, 0}, {});
    if (!pole)
        return std::nullopt;
    BeamDirection beam;
    beam.film = film;
    beam.pole = angle(pole->direction);

    const auto cell = cell_points(optics.lattice(), points);
    std::vector<double> errors;
    for (const LensPoint& point : cell)
        if (const auto ray = beam_ray(optics, {film, 0}, {}, point))
            errors.push_back(angle(ray->direction) - beam.pole);
    if (errors.empty())
        return std::nullopt;
    for (const double error : errors)
        beam.mean += error / errors.size();
    double squares = 0;
    for (const double error : errors)
        squares += (error - beam.mean) * (error - beam.mean) / errors.size();
    beam.spread = std::sqrt(squares);
    std::sort(errors.begin(), errors.end());
    beam.lower = errors[errors.size() / 100];
    beam.upper = errors[errors.size() - 1 - errors.size() / 100];
    beam.share = double(errors.size()) / cell.size();
    return beam;
}

} // namespace integral
