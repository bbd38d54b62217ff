// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/compare.h"

#include "integral/base/parallel.h"
#include "integral/compare/similarity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace integral {
namespace {

/// The encoding in which two pictures are compared: the non-linear one of the two, if there is one.
Encoding common_encoding(const Image& a, const Image& b)
{
    return a.encoding.kind == Encoding::Kind::linear ? b.encoding : a.encoding;
}

/// Reads an image's pixels, laid over black, in a given encoding.
class Viewed {
public:
    /// `with_light`: light() will be called.
    Viewed(const Image& image, Encoding encoding, bool with_light = false)
        : image_(image), encoding_(encoding), as_stored_(same_encoding(image.encoding, encoding))
    {
        if (with_light || !as_stored_ || (image.channels == 4 && !image.premultiplied))
            linear_.emplace(image);
    }

    /// The linear light over black.
    Colour light(int x, int y) const { return (*linear_)(x, y); }

    Colour operator()(int x, int y) const
    {
        const Colour stored = stored_pixel(image_, x, y);
        if (as_stored_ && (stored.a == 1 || image_.premultiplied))
            return stored;
        const Colour light = (*linear_)(x, y);
        const auto e = [&](float v) { return float(encode(encoding_, v)); };
        return {e(light.r), e(light.g), e(light.b), stored.a};
    }

private:
    const Image& image_;
    std::optional<LinearReader> linear_; ///< if stored values are not enough
    Encoding encoding_;
    bool as_stored_;
};

constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();

/// Comparison of two values of a channel.
struct ChannelPair {
    ChannelPair(float a, float b)
        : equal(a == b || (std::isnan(a) && std::isnan(b))),
          finite(std::isfinite(a) && std::isfinite(b)),
          difference(!equal && finite ? std::fabs(double(a) - b) : 0)
    {
    }

    bool equal;
    bool finite;       ///< whether both values are
    double difference; ///< 0 unless both are finite
    bool has_size() const { return equal || finite; }
};

/// The luma of the channels that are finite in both pictures.
float luma(Colour c, const ChannelPair channels[3])
{
    const auto value = [&](int k, float v) { return channels[k].finite ? v : 0.0f; };
    return 0.2126f * value(0, c.r) + 0.7152f * value(1, c.g) + 0.0722f * value(2, c.b);
}

/// Sums of squared differences, lens by lens.
class MicroImages {
public:
    explicit MicroImages(const FrameMetadata& metadata)
        : film_(metadata.film), lattice_(metadata.sheet)
    {
    }

    LensIndex lens_of(int x, int y) const
    {
        return lattice_.nearest(film_from_pixel(film_, {x + 0.5, y + 0.5}));
    }

    void add(LensIndex lens, double squares, double channels)
    {
        if (!last_ || last_->first != std::make_pair(lens.j, lens.i))
            last_ = &*sums_.try_emplace({lens.j, lens.i}).first;
        last_->second.squares += squares;
        last_->second.count += channels;
    }

    std::optional<WorstMicroImage> worst() const
    {
        std::optional<WorstMicroImage> worst;
        for (const auto& [index, sum] : sums_) {
            const double rmse = std::sqrt(sum.squares / sum.count);
            if (sum.count > 0 && (!worst || rmse > worst->rmse))
                worst = {{index.second, index.first}, {}, rmse};
        }
        if (worst)
            worst->pole = lattice_.pole(worst->lens);
        return worst;
    }

private:
    struct Sum {
        double squares = 0, count = 0;
    };
    Film film_;
    Lattice lattice_;
    using Sums = std::map<std::pair<std::int64_t, std::int64_t>, Sum>; // by row, then column
    Sums sums_;
    Sums::value_type* last_ = nullptr; // of the previous pixel, which mostly has the same lens
};

/// The contribution of one row of two pictures to the figures.
struct RowFigures {
    double largest = 0;              ///< the largest difference of any channel
    double pixels = 0;               ///< weight of all pixels
    double close = 0, differing = 0; ///< weight of pixels within 2/255, and beyond the tolerance
    NotFinitePixels not_finite;
};

/// The differences of some rows of two pictures.
struct Differences {
    std::vector<double> squares; ///< for each pixel, the weighted sum over its channels
    std::vector<float> channels; ///< for each pixel, the total weight of the channels in its sum
    std::vector<float> luma_a, luma_b;
    std::vector<float> light_a[3], light_b[3]; ///< R, G, B for FLIP; else empty
    std::vector<LensIndex> lenses;             ///< for each pixel; empty where there is no geometry
    std::vector<RowFigures> rows;
};

} // namespace

struct Comparer::State {
    State(const Frame& a, const Frame& b, const ComparisonSettings& settings)
        : settings(settings),
          width(a.image.width),
          height(a.image.height),
          alpha(a.image.channels == 4 && b.image.channels == 4)
    {
        require_same_size(a.image, b.image);
        result.encoding = common_encoding(a.image, b.image);
        if (a.metadata || b.metadata)
            micro_images.emplace(a.metadata ? *a.metadata : *b.metadata);
        result.channel_tolerance = settings.channel_tolerance;
        if (settings.similarity)
            similarity.emplace(width, height, settings.weights);
        if (settings.flip) {
            Flip::WeightsOf weights_of;
            if (settings.weights)
                weights_of = [weights = settings.weights](int y, float* row) {
                    weights->fill(y, row);
                };
            flip.emplace(width, height, *settings.flip, settings.take_map, weights_of);
        }
    }

    /// Fills row `row` of the differences from row `y` of a and b.
    void take_row(const Viewed& a, const Viewed& b, int y, int row)
    {
        RowFigures figures;
        std::vector<float> weights(std::size_t(width), 1.0f);
        if (settings.weights)
            settings.weights->fill(taken + row, weights.data());
        for (int x = 0; x < width; ++x) {
            const std::size_t at = std::size_t(row) * width + x;
            const float weight = weights[std::size_t(x)];
            const Viewed& second = weight > 0 ? b : a;
            const Colour p = a(x, y), q = second(x, y);
            const ChannelPair pairs[4] = {
                {p.r, q.r}, {p.g, q.g}, {p.b, q.b}, {p.a, alpha ? q.a : p.a}};
            double squares = 0, largest = 0;
            int sized = 0;
            bool all_finite = true;
            for (int k = 0; k < channels(); ++k) {
                squares += pairs[k].difference * pairs[k].difference;
                largest = std::max(largest, pairs[k].difference);
                sized += pairs[k].has_size();
                all_finite &= pairs[k].finite;
            }
            const bool unequal = sized < channels();
            if (unequal && figures.not_finite.unequal++ == 0) {
                figures.not_finite.x = x;
                figures.not_finite.y = taken + row;
            }
            figures.not_finite.equal += !unequal && !all_finite;
            figures.largest = std::max(figures.largest, largest);
            figures.pixels += weight;
            if (!unequal && largest <= 2.0 / 255 + 1e-6)
                figures.close += weight;
            if (unequal || largest > settings.channel_tolerance + 1e-6)
                figures.differing += weight;
            d.squares[at] = weight * squares;
            d.channels[at] = weight * float(sized);
            d.luma_a[at] = luma(p, pairs);
            d.luma_b[at] = luma(q, pairs);
            if (micro_images)
                d.lenses[at] = micro_images->lens_of(x, taken + row);
            if (flip) {
                const Colour light_p = a.light(x, y), light_q = second.light(x, y);
                const float values[3][2] = {
                    {light_p.r, light_q.r}, {light_p.g, light_q.g}, {light_p.b, light_q.b}};
                for (int k = 0; k < 3; ++k) {
                    d.light_a[k][at] = pairs[k].finite ? values[k][0] : 0;
                    d.light_b[k][at] = pairs[k].finite ? values[k][1] : 0;
                }
            }
        }
        d.rows[std::size_t(row)] = figures;
    }

    /// Takes the rows [y, y + rows) of a and b.
    void take(const Viewed& a, const Viewed& b, int y, int rows)
    {
        const std::size_t count = std::size_t(rows) * width;
        d.squares.resize(count);
        d.channels.resize(count);
        d.luma_a.resize(count);
        d.luma_b.resize(count);
        for (int k = 0; k < 3; ++k) {
            d.light_a[k].resize(flip ? count : 0);
            d.light_b[k].resize(flip ? count : 0);
        }
        d.lenses.resize(micro_images ? count : 0);
        d.rows.resize(std::size_t(rows));
        for_each_row(rows, 0, [&](int row) { take_row(a, b, y + row, row); });
        // In order, so that the sums do not depend on the number of threads.
        for (const RowFigures& row : d.rows) {
            result.largest_difference = std::max(result.largest_difference, row.largest);
            pixels += row.pixels;
            close += row.close;
            differing += row.differing;
            NotFinitePixels& all = result.not_finite;
            if (all.unequal == 0) {
                all.x = row.not_finite.x;
                all.y = row.not_finite.y;
            }
            all.equal += row.not_finite.equal;
            all.unequal += row.not_finite.unequal;
        }
        for (std::size_t at = 0; at < count; ++at) {
            squares += d.squares[at];
            sized_channels += d.channels[at];
            if (micro_images)
                micro_images->add(d.lenses[at], d.squares[at], d.channels[at]);
        }
        if (similarity)
            similarity->add(d.luma_a.data(), d.luma_b.data(), rows);
        if (flip)
            flip->add({d.light_a[0].data(), d.light_a[1].data(), d.light_a[2].data()},
                      {d.light_b[0].data(), d.light_b[1].data(), d.light_b[2].data()}, rows);
        taken += rows;
    }

    int channels() const { return alpha ? 4 : 3; }

    ComparisonSettings settings;
    int width, height;
    bool alpha; ///< whether both pictures have alpha
    Comparison result;
    std::optional<MicroImages> micro_images;
    std::optional<Similarity> similarity;
    std::optional<Flip> flip;
    Differences d;
    double squares = 0;
    double sized_channels = 0; ///< total weight of the channels that `squares` is over
    double pixels = 0, close = 0, differing = 0; ///< weights, as in RowFigures
    int taken = 0;
};

Comparer::Comparer(const Frame& a, const Frame& b, const ComparisonSettings& settings)
    : state_(std::make_unique<State>(a, b, settings))
{
}

Comparer::~Comparer() = default;

void Comparer::add(const Image& a, const Image& b)
{
    const bool with_light = state_->flip.has_value();
    const Viewed seen_a(a, state_->result.encoding, with_light),
        seen_b(b, state_->result.encoding, with_light);
    for (int y = 0; y < a.height; y += Similarity::most_rows)
        state_->take(seen_a, seen_b, y, std::min(Similarity::most_rows, a.height - y));
}

Comparison Comparer::result() const
{
    const State& s = *state_;
    Comparison result = s.result;
    result.rmse = std::sqrt(s.squares / s.sized_channels);
    result.psnr = result.rmse == 0 ? std::numeric_limits<double>::infinity()
                                   : 20 * std::log10(1 / result.rmse);
    if (s.similarity)
        result.ssim = s.similarity->mean();
    if (s.flip)
        result.flip = s.flip->result();
    result.within_two = s.close / s.pixels;
    result.differing = s.differing / s.pixels;
    if (s.micro_images)
        result.worst = s.micro_images->worst();
    if (s.sized_channels == 0)
        result.rmse = result.psnr = result.ssim = result.largest_difference = no_figure;
    return result;
}

void require_same_size(const Image& a, const Image& b)
{
    const auto size = [](const Image& i) {
        return std::to_string(i.width) + "x" + std::to_string(i.height);
    };
    if (a.width != b.width || a.height != b.height)
        throw std::invalid_argument("it has " + size(b) + " pixels, the other has " + size(a) +
                                    "; compare pictures of one size");
}

Comparison compare(const Frame& a, const Frame& b, const ComparisonSettings& settings)
{
    Comparer comparer(a, b, settings);
    comparer.add(a.image, b.image);
    return comparer.result();
}

Image difference_form(const Image& a, const Image& b)
{
    const int bits = sample_bits(a) == 8 && sample_bits(b) == 8 ? 8 : 16;
    return form_of(bits, a.width, a.height, 3, common_encoding(a, b));
}

Image difference_picture(const Image& a, const Image& b, double gain, const PixelWeights* weights,
                         int first_row)
{
    require_same_size(a, b);
    const Encoding encoding = common_encoding(a, b);
    const Viewed seen_a(a, encoding), seen_b(b, encoding);
    Image result = blank_like(difference_form(a, b), a.width, a.height);
    for_each_row(a.height, 0, [&](int y) {
        std::vector<float> row(std::size_t(a.width), 1.0f);
        if (weights)
            weights->fill(first_row + y, row.data());
        for (int x = 0; x < a.width; ++x) {
            if (!(row[std::size_t(x)] > 0))
                continue;
            const Colour p = seen_a(x, y), q = seen_b(x, y);
            const auto d = [&](float u, float v) {
                const ChannelPair pair(u, v);
                return pair.has_size() ? float(gain * pair.difference) : 1.0f;
            };
            store_pixel(result, x, y, {d(p.r, q.r), d(p.g, q.g), d(p.b, q.b), 1});
        }
    });
    return result;
}

} // namespace integral
