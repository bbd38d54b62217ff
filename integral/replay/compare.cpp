// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <tuple>

namespace integral {
namespace {

/// The encoding in which two pictures are compared.
Encoding common_encoding(const Image& a, const Image& b)
{
    return a.encoding.kind == Encoding::Kind::linear ? b.encoding : a.encoding;
}

/// Reads pixels over black in an encoding.
class Viewed {
public:
    Viewed(const Image& image, Encoding encoding)
        : image_(image), linear_(image), encoding_(encoding),
          as_stored_(same_encoding(image.encoding, encoding))
    {
    }

    Color operator()(int x, int y) const
    {
        const Color stored = stored_pixel(image_, x, y);
        if (as_stored_ && (stored.a == 1 || image_.premultiplied))
            return stored;
        const Color light = linear_(x, y);
        const auto e = [&](float v) { return float(encode(encoding_, v)); };
        return {e(light.r), e(light.g), e(light.b), stored.a};
    }

private:
    const Image& image_;
    LinearReader linear_;
    Encoding encoding_;
    bool as_stored_;
};

void require_same_size(const Image& a, const Image& b)
{
    const auto size = [](const Image& i) {
        return std::to_string(i.width) + "x" + std::to_string(i.height);
    };
    if (a.width != b.width || a.height != b.height)
        throw std::invalid_argument("it has " + size(b) + " pixels, the other has " + size(a) +
                                    "; compare pictures of one size");
}

/// Whether `value` is the new largest; NaN is larger than all.
bool exceeds(double value, double largest)
{
    return !std::isnan(largest) && !(value <= largest);
}

float luma(Color c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }

/// Sums of squared differences, lens by lens.
class MicroImages {
public:
    explicit MicroImages(const FrameMetadata& metadata)
        : film_(metadata.film), lattice_(metadata.sheet)
    {
    }

    void add(int x, int y, double squares, int channels)
    {
        const LensIndex lens = lattice_.nearest(film_from_pixel(film_, {x + 0.5, y + 0.5}));
        Sum& sum = sums_[{lens.j, lens.i}];
        sum.squares += squares;
        sum.count += channels;
    }

    WorstMicroImage worst() const
    {
        WorstMicroImage worst;
        worst.rmse = -1;
        for (const auto& [index, sum] : sums_) {
            const double rmse = std::sqrt(sum.squares / double(sum.count));
            if (exceeds(rmse, worst.rmse)) {
                worst.rmse = rmse;
                worst.lens = {index.second, index.first};
            }
        }
        worst.pole = lattice_.pole(worst.lens);
        return worst;
    }

private:
    struct Sum {
        double squares = 0;
        std::int64_t count = 0;
    };
    Film film_;
    Lattice lattice_;
    std::map<std::pair<std::int64_t, std::int64_t>, Sum> sums_; // by row, then column
};

/// A Gaussian of sigma 1.5 over 11 taps.
std::vector<double> gaussian_taps()
{
    std::vector<double> taps;
    for (int i = -5; i <= 5; ++i)
        taps.push_back(std::exp(-i * i / (2 * 1.5 * 1.5)));
    return taps;
}

/// Weighted mean along a line of `length` values, `step` apart, around `centre`.
template <class Value>
double weighted_mean(const std::vector<double>& taps, int centre, int length, Value value)
{
    double sum = 0, weight = 0;
    for (int i = std::max(0, centre - 5); i <= std::min(length - 1, centre + 5); ++i) {
        const double w = taps[std::size_t(i - centre + 5)];
        sum += w * value(i);
        weight += w;
    }
    return sum / weight;
}

} // namespace

double structural_similarity(const std::vector<float>& a, const std::vector<float>& b, int width,
                             int height)
{
    // Five means over the window (x, y, x^2, y^2, xy), first across each row, then down.
    struct Moments {
        double v[5];
    };
    const auto taps = gaussian_taps();
    const auto centres = [](int length) { // first centre and the one after the last
        return length >= 11 ? std::pair<int, int>(5, length - 5) : std::pair<int, int>(0, length);
    };
    int x0, x1, y0, y1; // no structured bindings: lambdas of C++17 cannot capture them
    std::tie(x0, x1) = centres(width);
    std::tie(y0, y1) = centres(height);
    const std::size_t across = std::size_t(x1 - x0);
    std::vector<Moments> ring(11 * across); // the rows that the current windows reach

    const auto fill_row = [&](int y) {
        const float *ra = a.data() + std::size_t(y) * width, *rb = b.data() + std::size_t(y) * width;
        for (int x = x0; x < x1; ++x) {
            Moments m;
            const auto mean = [&](auto value) { return weighted_mean(taps, x, width, value); };
            m.v[0] = mean([&](int i) { return double(ra[i]); });
            m.v[1] = mean([&](int i) { return double(rb[i]); });
            m.v[2] = mean([&](int i) { return double(ra[i]) * ra[i]; });
            m.v[3] = mean([&](int i) { return double(rb[i]) * rb[i]; });
            m.v[4] = mean([&](int i) { return double(ra[i]) * rb[i]; });
            ring[std::size_t(y % 11) * across + std::size_t(x - x0)] = m;
        }
    };

    constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    double total = 0;
    int filled = 0;
    for (int y = y0; y < y1; ++y) {
        for (; filled < std::min(height, y + 6); ++filled)
            fill_row(filled);
        for (std::size_t x = 0; x < across; ++x) {
            double v[5];
            for (int k = 0; k < 5; ++k)
                v[k] = weighted_mean(taps, y, height, [&](int i) {
                    return ring[std::size_t(i % 11) * across + x].v[k];
                });
            const double variance_a = v[2] - v[0] * v[0], variance_b = v[3] - v[1] * v[1];
            const double covariance = v[4] - v[0] * v[1];
            total += (2 * v[0] * v[1] + c1) * (2 * covariance + c2) /
                     ((v[0] * v[0] + v[1] * v[1] + c1) * (variance_a + variance_b + c2));
        }
    }
    return total / (double(across) * (y1 - y0));
}

Comparison compare(const Frame& a, const Frame& b)
{
    require_same_size(a.image, b.image);
    const int width = a.image.width, height = a.image.height;
    Comparison result;
    result.encoding = common_encoding(a.image, b.image);
    const Viewed seen_a(a.image, result.encoding), seen_b(b.image, result.encoding);
    const bool alpha = a.image.channels == 4 && b.image.channels == 4;
    const int channels = alpha ? 4 : 3;
    std::optional<MicroImages> micro_images;
    if (a.metadata || b.metadata)
        micro_images.emplace(a.metadata ? *a.metadata : *b.metadata);

    std::vector<float> luma_a, luma_b;
    luma_a.reserve(std::size_t(width) * height);
    luma_b.reserve(std::size_t(width) * height);
    double squares = 0;
    std::int64_t close = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Color p = seen_a(x, y), q = seen_b(x, y);
            const double d[4] = {double(p.r) - q.r, double(p.g) - q.g, double(p.b) - q.b,
                                 alpha ? double(p.a) - q.a : 0};
            double pixel_squares = 0, largest = 0;
            for (const double v : d) {
                pixel_squares += v * v;
                if (exceeds(std::fabs(v), largest))
                    largest = std::fabs(v);
            }
            squares += pixel_squares;
            if (exceeds(largest, result.largest_difference))
                result.largest_difference = largest;
            close += largest <= 2.0 / 255 + 1e-6;
            luma_a.push_back(luma(p));
            luma_b.push_back(luma(q));
            if (micro_images)
                micro_images->add(x, y, pixel_squares, channels);
        }
    const double pixels = double(width) * height;
    result.rmse = std::sqrt(squares / (pixels * channels));
    result.psnr = result.rmse == 0 ? std::numeric_limits<double>::infinity()
                                   : 20 * std::log10(1 / result.rmse);
    result.ssim = structural_similarity(luma_a, luma_b, width, height);
    result.within_two = double(close) / pixels;
    if (micro_images)
        result.worst = micro_images->worst();
    return result;
}

Image difference_picture(const Image& a, const Image& b, double gain)
{
    require_same_size(a, b);
    const Encoding encoding = common_encoding(a, b);
    const Viewed seen_a(a, encoding), seen_b(b, encoding);
    Image result = sample_bits(a) == 8 && sample_bits(b) == 8
                       ? make_image<std::uint8_t>(a.width, a.height, 3, encoding)
                       : make_image<std::uint16_t>(a.width, a.height, 3, encoding);
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const Color p = seen_a(x, y), q = seen_b(x, y);
            const auto d = [&](float u, float v) { return float(gain * std::fabs(u - v)); };
            store_pixel(result, x, y, {d(p.r, q.r), d(p.g, q.g), d(p.b, q.b), 1});
        }
    return result;
}

} // namespace integral
