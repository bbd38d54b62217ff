// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/plot_names.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral {
namespace {

struct Direction {
    double x, y;
};
// In order of preference: readers expect a name to the right of its point.
const Direction directions[] = {{1, 0},  {0, -1},  {-1, 0}, {0, 1},
                                {1, -1}, {-1, -1}, {1, 1},  {-1, 1}};
const double gaps[] = {7, 16, 28, 42}; // pixels from the point
constexpr int passes = 5;              // rounds in which each name is moved to its best place

double area_of(const PlotBox& box) { return (box.right - box.left) * (box.bottom - box.top); }

PlotBox placed(const PlotName& name, Direction direction, double gap)
{
    const double slant = direction.x != 0 && direction.y != 0 ? 0.7 : 1;
    const double x = name.x + direction.x * (gap * slant + 0.5 * name.width);
    const double y = name.y + direction.y * (gap * slant + 0.5 * name.height);
    return {x - 0.5 * name.width, y - 0.5 * name.height, x + 0.5 * name.width,
            y + 0.5 * name.height};
}

/// The cost of a place: `preference`, which grows with the distance from the point, plus weighted
/// pixels of area: outside `area` 20 each, over other names 8, over obstacles 4.
double badness(const PlotBox& box, double preference, std::size_t own,
               const std::vector<PlotName>& names, const PlotBox& area,
               const std::vector<PlotBox>& obstacles)
{
    double sum = preference + 20 * (area_of(box) - shared_area(box, area));
    for (std::size_t other = 0; other < names.size(); ++other)
        if (other != own)
            sum += 8 * shared_area(box, names[other].box);
    for (const PlotBox& obstacle : obstacles)
        sum += 4 * shared_area(box, obstacle);
    return sum;
}

} // namespace

double shared_area(const PlotBox& a, const PlotBox& b)
{
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return width > 0 && height > 0 ? width * height : 0;
}

void place_names(std::vector<PlotName>& names, const PlotBox& area,
                 const std::vector<PlotBox>& obstacles)
{
    for (PlotName& name : names)
        name.box = placed(name, directions[0], gaps[0]);
    for (int pass = 0; pass < passes; ++pass)
        for (std::size_t i = 0; i < names.size(); ++i) {
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t ring = 0; ring < std::size(gaps); ++ring)
                for (std::size_t turn = 0; turn < std::size(directions); ++turn) {
                    const PlotBox box = placed(names[i], directions[turn], gaps[ring]);
                    const double bad = badness(box, 60.0 * ring + 2.0 * turn, i, names, area,
                                               obstacles);
                    if (bad < least) {
                        least = bad;
                        names[i].box = box;
                        names[i].far = ring > 0;
                    }
                }
        }
}

} // namespace integral
