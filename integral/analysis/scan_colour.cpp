// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/scan_colour.h"

#include "integral/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

namespace integral {
namespace {

constexpr int grid_side = 64;
constexpr float least_light = 1e-4f; // a darker square gives no estimate of its light
constexpr float burnt_out = 0.98f;

Colour times(Colour a, Colour b) { return {a.r * b.r, a.g * b.g, a.b * b.b, a.a}; }

std::array<double, 6> terms(double x, double y) { return {1, x, y, x * x, x * y, y * y}; }

/// Solves the normal equations of weighted least squares; nothing if they are singular.
std::optional<std::array<double, 6>> solve_surface(double a[6][7])
{
    for (int k = 0; k < 6; ++k) {
        int pivot = k;
        for (int j = k + 1; j < 6; ++j)
            if (std::fabs(a[j][k]) > std::fabs(a[pivot][k]))
                pivot = j;
        std::swap_ranges(a[k], a[k] + 7, a[pivot]);
        if (!(std::fabs(a[k][k]) > 1e-12))
            return std::nullopt;
        for (int j = 0; j < 6; ++j)
            if (j != k) {
                const double f = a[j][k] / a[k][k];
                for (int i = k; i < 7; ++i)
                    a[j][i] -= f * a[k][i];
            }
    }
    std::array<double, 6> c;
    for (int k = 0; k < 6; ++k)
        c[k] = a[k][6] / a[k][k];
    return c;
}

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

/// Logarithm of the light in one square of a scan; x and y from -1 to 1 over the scan.
struct SurfaceSample {
    double x, y, value, weight;
};

std::optional<std::array<double, 6>> fitted_surface(const std::vector<SurfaceSample>& samples)
{
    double a[6][7] = {};
    for (const SurfaceSample& s : samples) {
        const auto t = terms(s.x, s.y);
        for (int k = 0; k < 6; ++k) {
            for (int l = 0; l < 6; ++l)
                a[k][l] += s.weight * t[k] * t[l];
            a[k][6] += s.weight * t[k] * s.value;
        }
    }
    return solve_surface(a);
}

/// Weights the samples by Tukey's biweight of their residuals from the surface.
void weigh_again(std::vector<SurfaceSample>& samples, const std::array<double, 6>& surface)
{
    std::vector<double> residuals, sizes;
    for (const SurfaceSample& s : samples) {
        const auto t = terms(s.x, s.y);
        double value = s.value;
        for (int k = 0; k < 6; ++k)
            value -= surface[k] * t[k];
        residuals.push_back(value);
        sizes.push_back(std::fabs(value));
    }
    const double reach = std::max(1e-3, 4.685 * 1.4826 * median(sizes));
    for (std::size_t k = 0; k < samples.size(); ++k) {
        const double u = residuals[k] / reach;
        samples[k].weight = std::fabs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0;
    }
}

} // namespace

double luminance(Colour c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

LightGrid light_grid(const Image& scan, int threads)
{
    LightGrid grid;
    grid.width = scan.width;
    grid.height = scan.height;
    grid.square = std::max(8, (std::max(scan.width, scan.height) + grid_side - 1) / grid_side);
    grid.columns = (scan.width + grid.square - 1) / grid.square;
    grid.rows = (scan.height + grid.square - 1) / grid.square;
    grid.means.resize(std::size_t(grid.columns) * grid.rows);
    const LinearReader pixel(scan);
    for_each_row(grid.rows, threads, [&](int row) {
        for (int column = 0; column < grid.columns; ++column) {
            double r = 0, g = 0, b = 0, count = 0;
            for (int y = row * grid.square; y < std::min(scan.height, (row + 1) * grid.square); ++y)
                for (int x = column * grid.square;
                     x < std::min(scan.width, (column + 1) * grid.square); ++x) {
                    const Colour c = pixel(x, y);
                    r += c.r;
                    g += c.g;
                    b += c.b;
                    ++count;
                }
            grid.means[std::size_t(row) * grid.columns + column] = {
                float(r / count), float(g / count), float(b / count), 1};
        }
    });
    return grid;
}

void ScanLight::divide_by_flat(const Image& flat, int width, int height, int threads)
{
    if (flat.width != width || flat.height != height)
        throw std::invalid_argument("it has " + std::to_string(flat.width) + "x" +
                                    std::to_string(flat.height) + " pixels, the scan " +
                                    std::to_string(width) + "x" + std::to_string(height) +
                                    "; scan both alike");
    LightGrid grid = light_grid(flat, threads);
    double r = 0, g = 0, b = 0, least = 1e30, most = 0;
    for (const Colour& c : grid.means) {
        if (!(c.r > least_light && c.g > least_light && c.b > least_light))
            throw std::invalid_argument(
                "it is black in places, and says nothing of the light there");
        r += c.r;
        g += c.g;
        b += c.b;
        least = std::min(least, luminance(c));
        most = std::max(most, luminance(c));
    }
    const double count = double(grid.means.size());
    for (Colour& c : grid.means)
        c = {float(c.r * count / r), float(c.g * count / g), float(c.b * count / b), 1};
    unevenness_ = most / least;
    flat_ = std::move(grid);
}

void ScanLight::divide_by_surface(const LightGrid& scan)
{
    constexpr std::size_t least_samples = 24;
    constexpr int rounds = 30;
    width_ = scan.width;
    height_ = scan.height;
    std::vector<SurfaceSample> samples;
    for (int row = 0; row < scan.rows; ++row)
        for (int column = 0; column < scan.columns; ++column) {
            const Vec2 middle{std::min(scan.width - 0.5, (column + 0.5) * scan.square),
                              std::min(scan.height - 0.5, (row + 0.5) * scan.square)};
            const double light = luminance(times(scan.at(column, row), gain(middle)));
            if (light > least_light)
                samples.push_back(
                    {2 * middle.x / width_ - 1, 2 * middle.y / height_ - 1, std::log(light), 1});
        }
    if (samples.size() < least_samples)
        return;
    std::array<double, 6> c{};
    for (int round = 0; round < rounds; ++round) {
        const auto fitted = fitted_surface(samples);
        if (!fitted)
            break;
        c = *fitted;
        weigh_again(samples, c);
    }
    c[0] = 0;
    surface_ = c;
    double sum = 0, least = 1e30, most = -1e30;
    for (const SurfaceSample& s : samples) {
        const double value = surface({(s.x + 1) * 0.5 * width_, (s.y + 1) * 0.5 * height_});
        sum += value;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    (*surface_)[0] = -sum / samples.size();
    unevenness_ *= std::exp(most - least);
}

double ScanLight::surface(Vec2 pixel) const
{
    if (!surface_)
        return 0;
    const auto t = terms(2 * pixel.x / width_ - 1, 2 * pixel.y / height_ - 1);
    double value = 0;
    for (int k = 0; k < 6; ++k)
        value += (*surface_)[k] * t[k];
    return value;
}

void ScanLight::balance_grey(const LightGrid& scan)
{
    double r = 0, g = 0, b = 0;
    for (int row = 0; row < scan.rows; ++row)
        for (int column = 0; column < scan.columns; ++column) {
            const Colour raw = scan.at(column, row);
            if (std::max({raw.r, raw.g, raw.b}) > burnt_out || luminance(raw) < 0.002)
                continue;
            const Colour c = times(raw,
                                   gain({(column + 0.5) * scan.square, (row + 0.5) * scan.square}));
            r += c.r;
            g += c.g;
            b += c.b;
        }
    if (!(r > 0 && g > 0 && b > 0))
        return;
    const Colour sums{float(r), float(g), float(b), 1};
    const double light = luminance(sums);
    gains_ = times(gains_, {float(light / r), float(light / g), float(light / b), 1});
}

void ScanLight::balance_white(const Image& scan, int x, int y, int width, int height)
{
    const LinearReader pixel(scan);
    double r = 0, g = 0, b = 0;
    for (int j = y; j < y + height; ++j)
        for (int i = x; i < x + width; ++i) {
            const Colour c = times(pixel(i, j), gain({i + 0.5, j + 0.5}));
            r += c.r;
            g += c.g;
            b += c.b;
        }
    const double count = double(width) * height;
    if (!(std::min({r, g, b}) > least_light * count))
        throw std::invalid_argument("it is black in a colour, and cannot become white");
    gains_ = times(gains_, {float(count / r), float(count / g), float(count / b), 1});
}

Colour ScanLight::gain(Vec2 pixel) const
{
    Colour all = gains_;
    if (surface_) {
        const float even = float(std::exp(-surface(pixel)));
        all = times(all, {even, even, even, 1});
    }
    if (flat_) { // between the squares' middles
        const double x = std::clamp(pixel.x / flat_->square - 0.5, 0.0, flat_->columns - 1.0);
        const double y = std::clamp(pixel.y / flat_->square - 0.5, 0.0, flat_->rows - 1.0);
        const int left = std::min(int(x), std::max(0, flat_->columns - 2)),
                  top = std::min(int(y), std::max(0, flat_->rows - 2));
        Colour light{0, 0, 0, 1};
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const float weight = float((i ? x - left : 1 - (x - left)) *
                                           (j ? y - top : 1 - (y - top)));
                if (weight == 0)
                    continue;
                const Colour c = flat_->at(left + i, top + j);
                light = {light.r + weight * c.r, light.g + weight * c.g, light.b + weight * c.b, 1};
            }
        all = times(all, {1 / light.r, 1 / light.g, 1 / light.b, 1});
    }
    return all;
}

namespace {

/// The average micro-image: light as a function of the place in the cell.
class AverageMicroImage {
public:
    AverageMicroImage(const Film& film, const SheetOptics& optics, LensMapping mapping)
        : film_(film),
          optics_(optics),
          mapping_(mapping),
          lenticular_(optics.sheet().arrangement == Arrangement::lenticular),
          rows_(lenticular_ ? 1 : bins),
          height_(cell_height(optics.lattice(), lenticular_)),
          shares_(std::size_t(bins) * rows_, 0.0)
    {
    }

    /// Place of a pixel in its micro-image, 0 to 1 each way; nothing if the pixel is dark.
    std::optional<Vec2> place(int x, int y) const
    {
        const Lattice& lattice = optics_.lattice();
        const Vec2 point = film_from_pixel(film_, {x + 0.5, y + 0.5});
        const auto mapped = optics_.map(point, mapping_);
        if (!mapped.ray)
            return std::nullopt;
        const Vec2 pole = mapped.ray->pole;
        const Vec2 middle = pole -
                            offset_from_direction(optics_.medium(),
                                                  {-pole.x, -pole.y, -optics_.aperture().distance});
        const Vec2 off = point - middle;
        const double u = dot(lattice.across(), off) / lattice.pitch() + 0.5,
                     v = dot(lattice.along(), off) / height_ + 0.5;
        return Vec2{std::clamp(u, 0.0, 1.0), lenticular_ ? 0.5 : std::clamp(v, 0.0, 1.0)};
    }

    /// Averages a frame's light. Returns the least light relative to the brightest; nothing if the
    /// frame is black.
    std::optional<double> measure(const LinearReader& pixel, int threads)
    {
        std::vector<double> counts = shares_;
        std::mutex adding;
        for_each_row(film_.height, threads, [&](int y) {
            std::vector<double> row_sums(shares_.size(), 0.0), row_counts = row_sums;
            for (int x = 0; x < film_.width; ++x) {
                const double light = luminance(pixel(x, y));
                const auto at = place(x, y);
                if (!at || !(light > 0)) // outside the scan
                    continue;
                const std::size_t k = std::size_t(bin(at->y, rows_)) * bins + bin(at->x, bins);
                row_sums[k] += light;
                row_counts[k] += 1;
            }
            const std::lock_guard<std::mutex> lock(adding);
            for (std::size_t k = 0; k < shares_.size(); ++k) {
                shares_[k] += row_sums[k];
                counts[k] += row_counts[k];
            }
        });
        double most = 0, least = 1;
        for (std::size_t k = 0; k < shares_.size(); ++k) {
            shares_[k] = counts[k] > 0 ? shares_[k] / counts[k] : 0;
            most = std::max(most, shares_[k]);
        }
        if (!(most > 0))
            return std::nullopt;
        for (std::size_t k = 0; k < shares_.size(); ++k) {
            shares_[k] = counts[k] > 0 ? std::max(least_share, shares_[k] / most) : 1;
            least = std::min(least, shares_[k]);
        }
        return least;
    }

    /// The light at a place relative to the brightest, interpolated; 1/8 to 1.
    double share(Vec2 at) const
    {
        const double u = std::clamp(at.x * bins - 0.5, 0.0, bins - 1.0),
                     v = std::clamp(at.y * rows_ - 0.5, 0.0, rows_ - 1.0);
        const int left = std::min(int(u), bins - 2), top = std::min(int(v), std::max(0, rows_ - 2));
        double share = 0;
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const double weight = (i ? u - left : 1 - (u - left)) *
                                      (j ? v - top : 1 - (v - top));
                if (weight > 0)
                    share += weight * shares_[std::size_t(top + j) * bins + left + i];
            }
        return share;
    }

private:
    static constexpr int bins = 16; ///< across a cell
    static constexpr double least_share = 1.0 / 8;

    static int bin(double at, int count) { return std::min(count - 1, int(at * count)); }
    static double cell_height(const Lattice& lattice, bool lenticular)
    {
        if (lenticular)
            return lattice.pitch();
        return lattice.row_spacing() *
               (lattice.arrangement() == Arrangement::hexagonal ? 4.0 / 3 : 1);
    }

    const Film& film_;
    const SheetOptics& optics_;
    LensMapping mapping_;
    bool lenticular_;
    int rows_;
    double height_; ///< of a cell, mm
    std::vector<double> shares_;
};

} // namespace

double flatten_micro_images(Image& frame, const Film& film, const SheetOptics& optics,
                            LensMapping mapping, int threads)
{
    AverageMicroImage average(film, optics, mapping);
    const LinearReader pixel(frame);
    const auto least = average.measure(pixel, threads);
    if (!least)
        return 1;
    for_each_row(film.height, threads, [&](int y) {
        for (int x = 0; x < film.width; ++x)
            if (const auto at = average.place(x, y)) {
                const float gain = float(1 / average.share(*at));
                store_linear(frame, x, y, times(pixel(x, y), {gain, gain, gain, 1}));
            }
    });
    return *least;
}

} // namespace integral
