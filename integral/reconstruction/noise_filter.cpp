// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/noise_filter.h"

#include "integral/base/eight_floats.h"

#include <cmath>
#include <cstddef>
#include <optional>

#include "integral/base/vector_loops.h"

namespace integral {

namespace {

// Fraction of a pixel's noise that its neighbours do not share, times the ratio of the noise to the
// prediction from the samples' variance. Most pixels share most of their samples with their
// neighbours. But behind a lenticular sheet a pixel shares hardly any samples with its neighbours
// along the lines, because these look at another height. Tuned by comparing frames of POV-Ray's
// sample scenes with converged ones.
constexpr float apart_behind_lenses = 0.25f, apart_across_lines = 0.12f, apart_along_lines = 0.8f,
                apart_in_view = 0.15f, apart_from_one = 0.25f;

// Half-width of the window over which squares are averaged, and margin that also includes the
// furthest pixels that are mixed.
constexpr int around = NoiseFilter::reach_around, margin = NoiseFilter::rows;

using Numbers = std::vector<float>;

/// Eight sums, each of five numbers `step` apart; the first numbers of the sums are consecutive.
template <class Floats>
INTEGRAL_INLINE Floats sum_of_five(const float* numbers, std::ptrdiff_t step)
{
    static_assert(around == 2);
    return load<Floats>(numbers) + load<Floats>(numbers + step) + load<Floats>(numbers + 2 * step) +
           load<Floats>(numbers + 3 * step) + load<Floats>(numbers + 4 * step);
}

} // namespace

/// Data of a block's pixels and the pixels at most `margin` away, or of the pixels that correspond
/// to these behind the next lenses: one array per number, row by row. 0 for pixels not behind a
/// lens.
struct NoiseFilter::Pixels {
    std::array<Numbers, 4> colour;
    Numbers any;  ///< 1: the pixel is behind a lens
    Numbers lens; ///< a different number for each nearby lens

    void begin(std::size_t size)
    {
        for (Numbers* numbers : {&colour[0], &colour[1], &colour[2], &colour[3], &any, &lens})
            numbers->assign(size, 0);
    }

    void set(std::size_t at, const FourFloats& encoded, float number_of_lens)
    {
        for (std::size_t k = 0; k < 4; ++k)
            colour[k][at] = encoded[int(k)];
        any[at] = 1;
        lens[at] = number_of_lens;
    }

    /// Compares eight pixels from the index `at` on with eight of `others`: 1 where both pixels of
    /// a pair have the same `lens`, else 0.
    template <class Floats>
    INTEGRAL_INLINE Floats same(std::ptrdiff_t at, const Pixels& others,
                                std::ptrdiff_t others_at) const
    {
        const Floats own = load<Floats>(lens.data() + at),
                     other = load<Floats>(others.lens.data() + others_at),
                     none = broadcast<Floats>(0),
                     both = load<Floats>(any.data() + at) *
                            load<Floats>(others.any.data() + others_at);
        return select(own < other, none, select(own > other, none, both));
    }
};

/// Working memory of one thread. Eight pixels are processed side by side, also beyond the ends of
/// rows; the values written there are not read.
struct NoiseFilter::Scratch {
    PictureBlock block{};
    std::ptrdiff_t width = 0; ///< of the rows in memory
    Pixels own, forth, back;  ///< the block's pixels; those behind the next lenses
    Numbers noise;            ///< as NoiseFilter::Noise returns it
    Numbers expected;         ///< local means of `noise`; 0 for pixels that are left unchanged
    /// Results of compare(): the differences by component, the sum of their squares, and 1 where
    /// the pixels to compare with exist. All are 0 elsewhere.
    std::array<Numbers, 4> difference;
    Numbers squares, any;
    Numbers columns, any_columns; ///< sums over the five rows around a row
    /// Sums over all comparisons: of the weights, and of the weighted differences.
    Numbers weights;
    std::array<Numbers, 4> mixed;

    void begin(const PictureBlock& requested)
    {
        block = requested;
        width = block.right - block.left + 1 + 2 * margin;
        const std::size_t size = std::size_t(width * (block.bottom - block.top + 1 + 2 * margin)) +
                                 8;
        for (Pixels* pixels : {&own, &forth, &back})
            pixels->begin(size);
        for (Numbers* numbers : {&noise, &expected, &squares, &any, &weights})
            numbers->assign(size, 0);
        for (std::size_t k = 0; k < 4; ++k) {
            difference[k].assign(size, 0);
            mixed[k].assign(size, 0);
        }
        columns.resize(std::size_t(width) + 8);
        any_columns.resize(std::size_t(width) + 8);
    }

    std::ptrdiff_t at(int x, int y) const
    {
        return (y - block.top + margin) * width + (x - block.left + margin);
    }

    /// Indices of the first and last pixel of a row of the block, extended by `beyond` pixels to
    /// both sides.
    std::ptrdiff_t first(int y, int beyond) const { return at(block.left - beyond, y); }
    std::ptrdiff_t last(int y, int beyond) const { return at(block.right + beyond, y); }

    /// Sums `numbers` and `where_any` over the five rows around a row of the block, into `columns`
    /// and `any_columns`.
    template <class Floats>
    INTEGRAL_INLINE void sum_columns(const Numbers& numbers, const Numbers& where_any, int y)
    {
        const std::ptrdiff_t begin = first(y, around), above = around * width;
        for (std::ptrdiff_t at = begin; at <= last(y, around); at += 8) {
            store(&columns[std::size_t(at - begin)],
                  sum_of_five<Floats>(numbers.data() + at - above, width));
            store(&any_columns[std::size_t(at - begin)],
                  sum_of_five<Floats>(where_any.data() + at - above, width));
        }
    }

    template <class Floats> INTEGRAL_INLINE void find_expected()
    {
        const Floats none = broadcast<Floats>(0);
        for (int y = block.top; y <= block.bottom; ++y) {
            sum_columns<Floats>(noise, own.any, y);
            const std::ptrdiff_t begin = first(y, 0);
            for (std::ptrdiff_t at = begin; at <= last(y, 0); at += 8) {
                const Floats mean = sum_of_five<Floats>(columns.data() + at - begin, 1) /
                                    sum_of_five<Floats>(any_columns.data() + at - begin, 1);
                store(&expected[std::size_t(at)],
                      select(load<Floats>(noise.data() + at) > none, mean, none));
            }
        }
    }

    /// Computes how each pixel differs from the mean of two others: one in `a` at the offset
    /// `to_a`, one in `b` at the offset `to_b`.
    template <class Floats>
    INTEGRAL_INLINE void compare(const Pixels& a, std::ptrdiff_t to_a, const Pixels& b,
                                 std::ptrdiff_t to_b)
    {
        const Floats half = broadcast<Floats>(0.5f);
        for (int y = block.top - around; y <= block.bottom + around; ++y)
            for (std::ptrdiff_t at = first(y, around); at <= last(y, around); at += 8) {
                const Floats both = own.same<Floats>(at, a, at + to_a) *
                                    own.same<Floats>(at, b, at + to_b);
                Floats sum = broadcast<Floats>(0);
                for (std::size_t k = 0; k < 4; ++k) {
                    const Floats mean = half * (load<Floats>(a.colour[k].data() + at + to_a) +
                                                load<Floats>(b.colour[k].data() + at + to_b)),
                                 by = both * (mean - load<Floats>(own.colour[k].data() + at));
                    store(&difference[k][std::size_t(at)], by);
                    sum = sum + by * by;
                }
                store(&squares[std::size_t(at)], sum);
                store(&any[std::size_t(at)], both);
            }
    }

    /// Mixes each pixel with the mean of two others (see compare()), which may be the same pixel.
    /// `apart`: the fraction of the pixel's noise that this mean does not share.
    template <class Floats>
    INTEGRAL_INLINE void mix_with(const Pixels& a, std::ptrdiff_t to_a, const Pixels& b,
                                  std::ptrdiff_t to_b, float apart)
    {
        compare<Floats>(a, to_a, b, to_b);
        const bool is_one = &a == &b && to_a == to_b;
        const Floats none = broadcast<Floats>(0), two = broadcast<Floats>(2),
                     three = broadcast<Floats>(3);
        for (int y = block.top; y <= block.bottom; ++y) {
            sum_columns<Floats>(squares, any, y);
            const std::ptrdiff_t begin = first(y, 0);
            for (std::ptrdiff_t at = begin; at <= last(y, 0); at += 8) {
                const Floats own_noise = broadcast<Floats>(apart) *
                                         load<Floats>(expected.data() + at) *
                                         sum_of_five<Floats>(any_columns.data() + at - begin, 1),
                             found = max(two * own_noise,
                                         sum_of_five<Floats>(columns.data() + at - begin, 1));
                Floats weight = own_noise / (found - own_noise);
                if (is_one) {
                    const Floats root = three * own_noise / (found + own_noise);
                    weight = root * root;
                }
                weight = select(own_noise * load<Floats>(any.data() + at) > none, weight, none);
                store(&weights[std::size_t(at)], load<Floats>(weights.data() + at) + weight);
                for (std::size_t k = 0; k < 4; ++k)
                    store(&mixed[k][std::size_t(at)],
                          load<Floats>(mixed[k].data() + at) +
                              weight * load<Floats>(difference[k].data() + at));
            }
        }
    }

    /// Mixes each pixel with all its neighbours. `apart`: see NoiseFilter.
    template <class Floats> INTEGRAL_INLINE void mix_with_all(const std::array<float, 3>& apart)
    {
        find_expected<Floats>();
        for (const std::ptrdiff_t step : {std::ptrdiff_t(1), width})
            for (int way = -reach_along; way <= reach_along; ++way)
                if (way != 0)
                    mix_with<Floats>(own, way * step, own, way * step, apart_from_one);
        mix_with<Floats>(own, -1, own, 1, apart[0]);
        mix_with<Floats>(own, -width, own, width, apart[1]);
        mix_with<Floats>(forth, 0, back, 0, apart[2]);
        mix_with<Floats>(forth, 0, forth, 0, apart_from_one);
        mix_with<Floats>(back, 0, back, 0, apart_from_one);
    }

#ifdef INTEGRAL_HAS_AVX2
    INTEGRAL_TARGET_AVX2 void mix_with_all_avx2(const std::array<float, 3>& apart)
    {
        mix_with_all<EightFloats>(apart);
    }
#endif
};

void NoiseFilter::FreeScratch::operator()(Scratch* scratch) const { delete scratch; }

NoiseFilter::ScratchPointer NoiseFilter::make_scratch() { return ScratchPointer(new Scratch); }

NoiseFilter::NoiseFilter(const LightFieldImage& finished) : finished_(finished)
{
    apart_.fill(apart_in_view);
}

NoiseFilter::NoiseFilter(const IntegralCamera& camera, const LightFieldImage& finished)
    : finished_(finished)
{
    const Lattice& lattice = camera.optics.lattice();
    const bool lenticular = lattice.arrangement() == Arrangement::lenticular;
    apart_.fill(lenticular ? apart_across_lines : apart_behind_lenses);
    if (lenticular) {
        const Vec2 along = lattice.along();
        apart_[std::fabs(along.x) > std::fabs(along.y) ? 0 : 1] = apart_along_lines;
    }
}

/// Reads the data of a block's pixels and the pixels around.
void NoiseFilter::read(const PictureBlock& block, const Noise& noise, Scratch& scratch) const
{
    scratch.begin(block);
    std::optional<LightFieldImage::StoredLens> some;
    const auto is_within = [&](int x, int y, int beyond) {
        return x >= block.left - beyond && y >= block.top - beyond && x <= block.right + beyond &&
               y <= block.bottom + beyond;
    };
    for (int y = block.top - margin; y <= block.bottom + margin; ++y)
        for (int x = block.left - margin; x <= block.right + margin; ++x) {
            const auto lens = finished_.lens(x, y);
            if (!lens)
                continue;
            some = some.value_or(*lens);
            // Lenses nearby are fewer than 2048 steps away.
            const float number = float(4096 * std::int16_t((*lens)[0] - (*some)[0]) +
                                       std::int16_t((*lens)[1] - (*some)[1]));
            const std::size_t at = std::size_t(scratch.at(x, y));
            scratch.own.set(at, finished_.colour(x, y), number);
            if (!is_within(x, y, around))
                continue;
            scratch.noise[at] = noise(x, y);
            const auto [forth, back] = finished_.colours_behind_next_lenses(x, y);
            if (forth)
                scratch.forth.set(at, *forth, number);
            if (back)
                scratch.back.set(at, *back, number);
        }
}

void NoiseFilter::filter(const PictureBlock& block, const Noise& noise, Scratch& scratch,
                         std::vector<FourFloats>& changes) const
{
    read(block, noise, scratch);
#ifdef INTEGRAL_HAS_AVX2
    if (has_avx2())
        scratch.mix_with_all_avx2(apart_);
    else
#endif
        scratch.mix_with_all<TwiceFourFloats>(apart_);
    changes.clear();
    for (int y = block.top; y <= block.bottom; ++y)
        for (int x = block.left; x <= block.right; ++x) {
            const std::size_t at = std::size_t(scratch.at(x, y));
            const FourFloats sum = {scratch.mixed[0][at], scratch.mixed[1][at],
                                    scratch.mixed[2][at], scratch.mixed[3][at]};
            changes.push_back(sum / (1 + scratch.weights[at]));
        }
}

} // namespace integral
