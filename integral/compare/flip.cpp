// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/flip.h"

#include "integral/base/parallel.h"
#include "integral/compare/flip_loops.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace integral {
namespace {

constexpr int bins = 1 << 16; // of the map's values, for the quartiles

/// The planes that are filtered along the rows, and then down the columns.
enum Plane { plane_y, plane_xy, plane_yz_first, plane_yz_second, smooth, edge, point, planes };

/// A filter whose values are in groups of four, with zeros behind the last. The values of a
/// detector add up to 0. Detectors weigh differences from the centre, so that flat parts give
/// exactly 0: FLIP takes a root of the result, which would magnify rounding errors.
struct Filter {
    explicit Filter(const FlipTaps& taps, bool detects = false)
        : radius(taps.radius), detects(detects), values(taps.values)
    {
        values.resize((values.size() + 3) / 4 * 4);
    }
    int radius;
    bool detects;
    std::vector<float> values;
};

struct Filters {
    explicit Filters(const FlipKernels& k)
        : luminance(k.luminance),
          red_green(k.red_green),
          blue_yellow{Filter(k.blue_yellow[0]), Filter(k.blue_yellow[1])},
          smooth(k.smooth),
          edge(k.edge, true),
          point(k.point, true)
    {
    }
    Filter luminance, red_green, blue_yellow[2], smooth, edge, point;
};

/// Filters one row. `from` points to its first pixel, and has `radius` + 3 more pixels before it
/// and behind the last. `zeros`: one zero for each pixel.
void filter_along(float* to, const float* from, const Filter& filter, const float* zeros, int count)
{
    const float* centre = filter.detects ? from : zeros;
    for (std::size_t k = 0; k < filter.values.size(); k += 4) {
        const float* first = from + k - filter.radius;
        const float* const four[4] = {first, first + 1, first + 2, first + 3};
        (k == 0 ? set_four : add_four)(to, four, centre, filter.values.data() + k, count);
    }
}

} // namespace

struct Flip::State {
    State(int width, int height, const FlipSettings& settings, TakeMap take, WeightsOf weights_of)
        : width(width),
          height(height),
          settings(settings),
          take(std::move(take)),
          weights_of(std::move(weights_of)),
          kernels(flip_kernels(settings.ppd)),
          filters(kernels),
          radius(kernels.radius),
          band(std::min(height, std::max(64, 2 * radius))),
          kept(std::min(height, band + 2 * radius)),
          zeros(std::size_t(width)),
          sums(bins)
    {
        for (auto& light : lights)
            light.resize(std::size_t(kept) * 3 * width);
        for (auto& picture : filtered)
            picture.resize(std::size_t(kept) * planes * width);
        map.resize(std::size_t(band) * width);
    }

    /// A channel of a row of light; the rows in memory form a ring.
    float* light(int picture, int y, int channel)
    {
        return lights[picture].data() + (std::size_t(y % kept) * 3 + channel) * width;
    }

    float* plane(int picture, int y, int which)
    {
        return filtered[picture].data() + (std::size_t(y % kept) * planes + which) * width;
    }

    /// Filters row y of a picture along the row. `factor`: of the exposure; 0: no tone mapping.
    void filter_row(int picture, int y, float factor)
    {
        const int margin = radius + 4, padded = width + 2 * margin;
        std::vector<float> rows(std::size_t(3) * padded), mapped;
        const float* rgb[3] = {light(picture, y, 0), light(picture, y, 1), light(picture, y, 2)};
        if (factor > 0) {
            mapped.resize(std::size_t(3) * width);
            for (int k = 0; k < 3; ++k) {
                float* to = mapped.data() + std::size_t(k) * width;
                tone_map(to, rgb[k], factor, width);
                rgb[k] = to;
            }
        }
        float* row[3];
        for (int k = 0; k < 3; ++k)
            row[k] = rows.data() + std::size_t(k) * padded + margin;
        opponent_from_rgb({row[0], row[1], row[2]}, rgb[0], rgb[1], rgb[2], width);
        for (float* r : row) { // the picture's edge pixels are repeated beyond its edges
            std::fill(r - margin, r, r[0]);
            std::fill(r + width, r + width + margin, r[width - 1]);
        }
        const auto along = [&](Plane to, const float* from, const Filter& filter) {
            filter_along(plane(picture, y, to), from, filter, zeros.data(), width);
        };
        along(plane_y, row[0], filters.luminance);
        along(plane_xy, row[1], filters.red_green);
        along(plane_yz_first, row[2], filters.blue_yellow[0]);
        along(plane_yz_second, row[2], filters.blue_yellow[1]);
        along(smooth, row[0], filters.smooth);
        along(edge, row[0], filters.edge);
        along(point, row[0], filters.point);
    }

    /// Filters a plane down the columns at row y, and stores the result in `to` or adds it.
    void filter_down(float* to, int picture, int y, Plane which, const Filter& filter, bool adds)
    {
        const float* centre = filter.detects ? plane(picture, y, which) : zeros.data();
        for (std::size_t k = 0; k < filter.values.size(); k += 4) {
            const float* four[4];
            for (int i = 0; i < 4; ++i)
                four[i] = plane(picture, std::clamp(y - filter.radius + int(k) + i, 0, height - 1),
                                which);
            (k == 0 && !adds ? set_four : add_four)(to, four, centre, filter.values.data() + k,
                                                    width);
        }
    }

    /// FLIP of row y of the pictures, which have been filtered along the rows.
    void map_row(float* to, int y)
    {
        constexpr int rows = 7;
        std::vector<float> buffer(std::size_t(2) * rows * width);
        FlipRow both[2];
        for (int picture = 0; picture < 2; ++picture) {
            float* row[rows];
            for (int k = 0; k < rows; ++k)
                row[k] = buffer.data() + (std::size_t(picture) * rows + k) * width;
            const auto down = [&](int k, Plane which, const Filter& filter, bool adds = false) {
                filter_down(row[k], picture, y, which, filter, adds);
            };
            down(0, plane_y, filters.luminance);
            down(1, plane_xy, filters.red_green);
            down(2, plane_yz_first, filters.blue_yellow[0]);
            down(2, plane_yz_second, filters.blue_yellow[1], true);
            down(3, edge, filters.smooth);
            down(4, smooth, filters.edge);
            down(5, point, filters.smooth);
            down(6, smooth, filters.point);
            both[picture] = {row[0], row[1], row[2], row[3], row[4], row[5], row[6]};
        }
        flip_of(to, both[0], both[1], width);
    }

    /// Computes the map's next `rows` rows. The rows around them must be in memory.
    void finish_rows(int rows)
    {
        const int first = std::max(0, finished - radius),
                  end = std::min(height, finished + rows + radius);
        const int exposures = settings.exposures ? settings.exposures->count : 1;
        for (int e = 0; e < exposures; ++e) {
            const float factor = settings.exposures ? float(std::exp2(settings.exposures->at(e)))
                                                    : 0;
            for_each_row(2 * (end - first), 0,
                         [&](int k) { filter_row(k % 2, first + k / 2, factor); });
            for_each_row(rows, 0, [&](int k) {
                float* to = map.data() + std::size_t(k) * width;
                if (e == 0)
                    return map_row(to, finished + k);
                std::vector<float> row(std::size_t(width), 0.0f);
                map_row(row.data(), finished + k);
                keep_greater(to, row.data(), width);
            });
        }
        count_rows(rows);
        if (take)
            take(finished, rows, map.data());
        finished += rows;
    }

    /// Adds the map's next rows to the figures, in order, so that the sums do not depend on the
    /// number of threads.
    void count_rows(int rows)
    {
        std::vector<float> weights(std::size_t(width), 1.0f);
        for (int k = 0; k < rows; ++k) {
            if (weights_of)
                weights_of(finished + k, weights.data());
            for (int x = 0; x < width; ++x) {
                const float value = map[std::size_t(k) * width + x];
                const double weighted = double(weights[x]) * value;
                sum += weighted;
                weight += weights[x];
                sums[std::min(bins - 1, int(value * bins))] += weighted;
                if (weights[x] > 0 && value > greatest) {
                    greatest = value;
                    greatest_x = x;
                    greatest_y = finished + k;
                }
            }
        }
    }

    int width, height;
    FlipSettings settings;
    TakeMap take;
    WeightsOf weights_of;
    FlipKernels kernels;
    Filters filters;
    int radius, band, kept;
    std::vector<float> lights[2], filtered[2], map, zeros;
    std::vector<double> sums; ///< of the map's values, in bins by value
    double sum = 0, weight = 0;
    float greatest = 0;
    int greatest_x = 0, greatest_y = 0;
    int taken = 0, finished = 0;
};

Flip::Flip(int width, int height, const FlipSettings& settings, TakeMap take, WeightsOf weights_of)
    : state_(
          std::make_unique<State>(width, height, settings, std::move(take), std::move(weights_of)))
{
}

Flip::~Flip() = default;

void Flip::add(const LightRows& a, const LightRows& b, int rows)
{
    State& s = *state_;
    for (int k = 0; k < rows; ++k) {
        const std::size_t at = std::size_t(k) * s.width;
        const LightRows* from[2] = {&a, &b};
        for (int picture = 0; picture < 2; ++picture) {
            const float* channels[3] = {from[picture]->r + at, from[picture]->g + at,
                                        from[picture]->b + at};
            for (int c = 0; c < 3; ++c)
                std::copy(channels[c], channels[c] + s.width, s.light(picture, s.taken, c));
        }
        ++s.taken;
        const int rows_left = s.height - s.finished;
        if (s.taken == s.height)
            while (s.finished < s.height)
                s.finish_rows(std::min(s.band, s.height - s.finished));
        else if (s.taken - s.finished >= s.band + s.radius && rows_left > s.band)
            s.finish_rows(s.band);
    }
}

FlipFigures Flip::result() const
{
    const State& s = *state_;
    FlipFigures figures;
    figures.settings = s.settings;
    figures.mean = s.weight > 0 ? s.sum / s.weight : std::numeric_limits<double>::quiet_NaN();
    figures.greatest = s.greatest;
    figures.x = s.greatest_x;
    figures.y = s.greatest_y;
    double below = 0;
    int bin = 0;
    for (int quartile = 0; quartile < 3; ++quartile) {
        const double share = (quartile + 1) / 4.0 * s.sum;
        for (; bin < bins - 1 && below + s.sums[std::size_t(bin)] < share; ++bin)
            below += s.sums[std::size_t(bin)];
        const double here = s.sums[std::size_t(bin)];
        figures.quartiles[quartile] = here > 0 ? std::min(figures.greatest,
                                                          (bin + (share - below) / here) / bins)
                                               : 0;
    }
    return figures;
}

} // namespace integral
