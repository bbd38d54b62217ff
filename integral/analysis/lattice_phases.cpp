// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/lattice_phases.h"

#include "integral/base/parallel.h"
#include "integral/optics/lens_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace integral {
namespace {

constexpr int side = 8; // blocks of the film, across and down
constexpr double step_pixels = 1.5;
constexpr std::size_t most_points = 800; // of a block

/// The two vectors (mm) of a lattice's cell; converts between film places and their multiples.
struct Cell {
    Vec2 first, second;
    bool lenticular;

    explicit Cell(const LensSheet& sheet) : lenticular(sheet.arrangement == Arrangement::lenticular)
    {
        const Lattice lattice(sheet);
        first = lattice.pitch() * lattice.across();
        second = lattice.row_spacing() * lattice.along();
        if (sheet.arrangement == Arrangement::hexagonal)
            second = second + 0.5 * first;
    }
    Vec2 from_film(Vec2 shift) const
    {
        if (lenticular)
            return {dot(shift, first) / dot(first, first), 0};
        const double area = first.x * second.y - first.y * second.x;
        return {(shift.x * second.y - shift.y * second.x) / area,
                (first.x * shift.y - first.y * shift.x) / area};
    }
    Vec2 to_film(Vec2 place) const { return place.x * first + (lenticular ? 0 : place.y) * second; }
};

/// The edge strength in a block of the film, for each shift of the borders within a lattice cell.
struct Block {
    Vec2 centre; ///< mm
    std::vector<Vec2> points;
    std::vector<float> edge; ///< Size::rows rows of Size::columns shifts
};

struct Size {
    int columns = 1, rows = 1;
    int count() const { return columns * rows; }
};

std::vector<Block> blocks_of(const std::vector<Vec2>& points)
{
    Vec2 least = points[0], most = points[0];
    for (const Vec2 p : points) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
    const auto index = [](double at, double from, double to) {
        return std::clamp(int(side * (at - from) / std::max(1e-30, to - from)), 0, side - 1);
    };
    std::vector<Block> blocks(side * side);
    for (const Vec2 p : points)
        blocks[index(p.y, least.y, most.y) * side + index(p.x, least.x, most.x)].points.push_back(
            p);
    std::vector<Block> used;
    for (Block& block : blocks) {
        if (block.points.empty())
            continue;
        Vec2 sum;
        for (const Vec2 p : block.points)
            sum = sum + p;
        block.centre = (1.0 / block.points.size()) * sum;
        used.push_back(std::move(block));
    }
    return used;
}

void measure(const Plane& edges, const ScanMap& base, const Cell& cell, Size size, Block& block)
{
    std::vector<Vec2> pixels;
    const std::size_t count = std::min(most_points, block.points.size());
    for (std::size_t k = 0; k < count; ++k)
        pixels.push_back(scan_from_film(base, block.points[k * block.points.size() / count]));
    const double weight = double(block.points.size()) / count;
    const Vec2 origin = scan_from_film(base, {0, 0});
    for (int j = 0; j < size.rows; ++j)
        for (int i = 0; i < size.columns; ++i) {
            const Vec2 shift = scan_from_film(base, cell.to_film({double(i) / size.columns,
                                                                  double(j) / size.rows})) -
                               origin;
            double sum = 0;
            for (const Vec2 pixel : pixels) {
                const int x = int(std::floor(pixel.x + shift.x)),
                          y = int(std::floor(pixel.y + shift.y));
                if (x >= 0 && y >= 0 && x < edges.width && y < edges.height)
                    sum += edges.at(x, y) - edges.mean;
            }
            block.edge.push_back(float(weight * sum));
        }
}

/// A change of the scales' logarithms and of the rotation.
using Change = std::array<double, 3>;

ScanMap with(const ScanMap& base, const Change& change)
{
    return {base.middle,
            {base.scale.x * std::exp(change[0]), base.scale.y * std::exp(change[1])},
            base.rotation + change[2]};
}

/// Number of steps either way such that a step moves the farthest border by step_pixels at most.
int steps(double range, double farthest_pixels)
{
    return int(std::ceil(range * farthest_pixels / step_pixels));
}

class Search {
public:
    Search(const Plane& edges, const std::vector<Vec2>& points, const LensSheet& sheet,
           const ScanMap& base, int threads)
        : cell_(sheet), base_(base), blocks_(blocks_of(points))
    {
        const auto pixels = [&](Vec2 v) {
            return length(scan_from_film(base, v) - scan_from_film(base, {0, 0}));
        };
        size_.columns = std::max(4, int(std::lround(pixels(cell_.first) / step_pixels)));
        if (!cell_.lenticular)
            size_.rows = std::max(4, int(std::lround(pixels(cell_.second) / step_pixels)));
        for_each_row(int(blocks_.size()), threads,
                     [&](int k) { measure(edges, base, cell_, size_, blocks_[k]); });
        for (const Block& block : blocks_) {
            const Vec2 from_middle = scan_from_film(base, block.centre) - base.middle;
            farthest_ = {std::max(farthest_.x, std::fabs(from_middle.x)),
                         std::max(farthest_.y, std::fabs(from_middle.y))};
            count_ += block.points.size();
        }
    }

    std::vector<ScoredMap> run(const PhaseRange& range, int threads) const
    {
        const int x_steps = steps(range.scale, farthest_.x),
                  y_steps = cell_.lenticular ? 0 : steps(range.scale, farthest_.y),
                  turn_steps = steps(range.turn, std::max(farthest_.x, farthest_.y));
        const auto part = [](int k, int of, double all) { return of ? all * k / of : 0; };
        std::vector<std::vector<ScoredMap>> found(2 * turn_steps + 1);
        for_each_row(int(found.size()), threads, [&](int t) {
            for (int y = -y_steps; y <= y_steps; ++y)
                for (int x = -x_steps; x <= x_steps; ++x) {
                    const double scale_x = part(x, x_steps, range.scale);
                    add_peaks({scale_x, cell_.lenticular ? scale_x : part(y, y_steps, range.scale),
                               part(t - turn_steps, turn_steps, range.turn)},
                              found[t]);
                }
        });
        std::vector<ScoredMap> all;
        for (const auto& row : found)
            all.insert(all.end(), row.begin(), row.end());
        std::sort(all.begin(), all.end(),
                  [](const ScoredMap& a, const ScoredMap& b) { return a.edge > b.edge; });
        return all;
    }

private:
    /// Adds the maps of the two shifts within the cell with the strongest edges, for one change.
    void add_peaks(const Change& change, std::vector<ScoredMap>& found) const
    {
        const ScanMap map = with(base_, change);
        std::vector<float> sums(size_.count(), 0);
        for (const Block& block : blocks_) {
            const Vec2 place = cell_.from_film(
                film_from_scan(base_, scan_from_film(map, block.centre)) - block.centre);
            const auto offset = [](double p, int count) {
                const int k = int(std::lround(p * count)) % count;
                return k < 0 ? k + count : k;
            };
            const int right = offset(place.x, size_.columns), up = offset(place.y, size_.rows);
            for (int j = 0; j < size_.rows; ++j) {
                const float* from = block.edge.data() +
                                    std::size_t((j + up) % size_.rows) * size_.columns;
                float* to = sums.data() + std::size_t(j) * size_.columns;
                const int whole = size_.columns - right;
                for (int i = 0; i < whole; ++i)
                    to[i] += from[i + right];
                for (int i = whole; i < size_.columns; ++i)
                    to[i] += from[i - whole];
            }
        }
        double mean = 0;
        for (const float sum : sums)
            mean += sum;
        mean /= sums.size();
        int best[2] = {-1, -1};
        for (int k = 0; k < size_.count(); ++k)
            if (is_peak(sums, k)) {
                if (best[0] < 0 || sums[k] > sums[best[0]]) {
                    best[1] = best[0];
                    best[0] = k;
                } else if (best[1] < 0 || sums[k] > sums[best[1]]) {
                    best[1] = k;
                }
            }
        for (const int k : best)
            if (k >= 0 && sums[k] > mean) {
                ScanMap moved = map;
                moved.middle = scan_from_film(
                    map, cell_.to_film({nearest(k % size_.columns, size_.columns),
                                        nearest(k / size_.columns, size_.rows)}));
                found.push_back({moved, (sums[k] - mean) / count_});
            }
    }
    /// The shift as a fraction of the cell, from -1/2 to 1/2.
    static double nearest(int k, int count)
    {
        const double place = double(k) / count;
        return place > 0.5 ? place - 1 : place;
    }
    bool is_peak(const std::vector<float>& sums, int k) const
    {
        const int x = k % size_.columns, y = k / size_.columns;
        for (int j = size_.rows > 1 ? -1 : 0; j <= (size_.rows > 1 ? 1 : 0); ++j)
            for (int i = -1; i <= 1; ++i)
                if (sums[(y + j + size_.rows) % size_.rows * size_.columns +
                         (x + i + size_.columns) % size_.columns] > sums[k])
                    return false;
        return true;
    }

    Cell cell_;
    ScanMap base_;
    std::vector<Block> blocks_;
    Size size_;
    Vec2 farthest_;
    std::size_t count_ = 0;
};

} // namespace

double lenses_apart(const LensSheet& sheet, const ScanMap& a, const ScanMap& b, int width,
                    int height)
{
    const Cell cell(sheet);
    double squares = 0;
    for (const double x : {0.0, 0.5, 1.0})
        for (const double y : {0.0, 0.5, 1.0}) {
            const Vec2 pixel{x * width, y * height};
            const Vec2 place = cell.from_film(film_from_scan(b, pixel) - film_from_scan(a, pixel));
            const Vec2 rest{place.x - std::round(place.x), place.y - std::round(place.y)};
            squares += dot(cell.to_film(rest), cell.to_film(rest));
        }
    return std::sqrt(squares / 9) / sheet.pitch;
}

std::vector<ScoredMap> strongest_phases(const Plane& edges, const std::vector<Vec2>& points,
                                        const LensSheet& sheet, const ScanMap& base,
                                        const PhaseRange& range, int count, int threads)
{
    constexpr double least_apart = 0.2;
    if (points.empty())
        return {};
    const Search search(edges, points, sheet, base, threads);
    std::vector<ScoredMap> kept;
    for (const ScoredMap& found : search.run(range, threads)) {
        bool is_new = true;
        for (const ScoredMap& other : kept)
            is_new = is_new && lenses_apart(sheet, other.map, found.map, edges.width,
                                            edges.height) >= least_apart;
        if (is_new)
            kept.push_back(found);
        if (int(kept.size()) == count)
            break;
    }
    return kept;
}

} // namespace integral
