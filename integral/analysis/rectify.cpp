// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/rectify.h"

#include "integral/base/constants.h"
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

constexpr int lobes = 3;

double sinc(double x) { return x == 0 ? 1 : std::sin(pi * x) / (pi * x); }
double lanczos(double x) { return std::fabs(x) < lobes ? sinc(x) * sinc(x / lobes) : 0; }

/// Weights of the pixels around a place along one axis; only pixels inside [0, count).
struct Taps {
    int first = 0;
    std::vector<float> weights;

    void set(double place, double width, int count)
    {
        first = std::max(0, int(std::ceil(place - lobes * width - 0.5)));
        const int last = std::min(count - 1, int(std::floor(place + lobes * width - 0.5)));
        weights.clear();
        for (int k = first; k <= last; ++k)
            weights.push_back(float(lanczos((k + 0.5 - place) / width)));
    }
};

} // namespace

Film film_of_scan(const ScanMap& map, int scan_width, int scan_height, Vec2 pixel_pitch,
                  const Film& like)
{
    Vec2 half{0, 0};
    for (const double x : {0.0, double(scan_width)})
        for (const double y : {0.0, double(scan_height)}) {
            const Vec2 corner = film_from_scan(map, {x, y});
            half = {std::max(half.x, std::fabs(corner.x)), std::max(half.y, std::fabs(corner.y))};
        }
    const auto side = [](double half_mm, double pitch, int parity) {
        const int pixels = int(std::ceil(2 * half_mm / pitch - 1e-6));
        return std::max(1, pixels + ((pixels + parity) & 1));
    };
    Film film = like;
    film.pixel_pitch = pixel_pitch;
    film.bleed = 0; // a print that is cut has none, and one that is not shows it
    film.width = side(half.x, pixel_pitch.x, like.width & 1);
    film.height = side(half.y, pixel_pitch.y, like.height & 1);
    return film;
}

Film film_to_make(const Film& requested, bool of_that_size, const ScanMap& map, const Image& scan)
{
    constexpr int largest_frame_side = 65500; // pixels
    const Film held = film_of_scan(map, scan.width, scan.height, requested.pixel_pitch, requested);
    Film film = requested;
    film.bleed = held.bleed;
    if (!of_that_size) {
        film.width = requested.width > 0 ? std::min(requested.width, held.width) : held.width;
        film.height = requested.height > 0 ? std::min(requested.height, held.height) : held.height;
    }
    if (std::max(film.width, film.height) > largest_frame_side)
        throw std::invalid_argument("a frame of " + std::to_string(film.width) + "x" +
                                    std::to_string(film.height) +
                                    " pixels is too large; fewer --dpi, or --size, would help");
    return film;
}

std::optional<Image> rectified(const Image& scan, const ScanMap& map, const Film& film,
                               const ScanLight& light, int threads, const Progress& progress)
{
    Image frame = make_image<std::uint16_t>(film.width, film.height, 3, Encoding{});
    const LinearReader pixel(scan);
    const double c = std::fabs(std::cos(map.rotation)), s = std::fabs(std::sin(map.rotation));
    // Scan pixels per film pixel, along the scan's axes.
    const double across = std::max(
        1.0, map.scale.x * (c * film.pixel_pitch.x + s * film.pixel_pitch.y) / (c + s));
    const double down = std::max(
        1.0, map.scale.y * (s * film.pixel_pitch.x + c * film.pixel_pitch.y) / (c + s));
    const auto row = [&](int y) {
        Taps columns, rows;
        for (int x = 0; x < film.width; ++x) {
            const Vec2 at = scan_from_film(map, film_from_pixel(film, {x + 0.5, y + 0.5}));
            if (!(at.x >= 0 && at.y >= 0 && at.x < scan.width && at.y < scan.height))
                continue;
            columns.set(at.x, across, scan.width);
            rows.set(at.y, down, scan.height);
            float r = 0, g = 0, b = 0, sum = 0;
            for (std::size_t j = 0; j < rows.weights.size(); ++j)
                for (std::size_t i = 0; i < columns.weights.size(); ++i) {
                    const float weight = rows.weights[j] * columns.weights[i];
                    const Colour value = pixel(columns.first + int(i), rows.first + int(j));
                    r += weight * value.r;
                    g += weight * value.g;
                    b += weight * value.b;
                    sum += weight;
                }
            const Colour gain = light.gain(at);
            store_linear(frame, x, y, {gain.r * r / sum, gain.g * g / sum, gain.b * b / sum, 1});
        }
    };
    if (!for_each_row(film.height, threads, row, progress))
        return std::nullopt;
    return frame;
}

} // namespace integral
