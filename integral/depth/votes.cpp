// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/votes.h"

#include <algorithm>
#include <cmath>

namespace integral {

namespace {

/// A shift along one axis: whole pixels, and the weights of the four pixels around the place there
/// (the cubic of Catmull and Rom).
struct Shift {
    explicit Shift(double pixels) : whole(int(std::floor(pixels + 1e-4)))
    {
        const float t = float(pixels - whole);
        is_whole = t < 1e-3f;
        weight[0] = t * (-0.5f + t * (1 - 0.5f * t));
        weight[1] = 1 + t * t * (1.5f * t - 2.5f);
        weight[2] = t * (0.5f + t * (2 - 1.5f * t));
        weight[3] = t * t * 0.5f * (t - 1);
    }
    int before() const { return is_whole ? 0 : 1; } ///< pixels needed before the whole one
    int after() const { return is_whole ? 0 : 2; }
    int whole;
    bool is_whole;
    float weight[4];
};

/// Pixels [first, last) of a row of `size` that have all their neighbours after the shift.
struct Span {
    Span(const Shift& shift, int size)
        : first(std::max(0, shift.before() - shift.whole)),
          last(std::min(size, size - shift.after() - shift.whole))
    {
    }
    int first, last;
};

} // namespace

/// One row's sums, of all views and of four halves of them. Votes and their number.
struct Votes::Sums {
    static constexpr int kinds = 5;
    explicit Sums(int width) : width(width), tall(std::size_t(width) + 4), wide(3 * tall.size())
    {
        for (auto& v : votes)
            v.resize(std::size_t(width));
        for (auto& n : number)
            n.resize(std::size_t(width));
        vote.resize(std::size_t(width));
    }
    void clear()
    {
        for (auto& v : votes)
            std::fill(v.begin(), v.end(), 0.0f);
        for (auto& n : number)
            std::fill(n.begin(), n.end(), 0.0f);
    }
    int width;
    std::vector<float> votes[kinds], number[kinds], vote;
    std::vector<float> tall, wide; ///< a row between rows, and between columns
};

Votes::Votes(const ViewSet& views, const VoteSettings& settings)
    : views_(views), settings_(settings), sharpness_(views.pixels())
{
    const int width = views.width, height = views.height;
    Vec2 share{1e-9, 1e-9}; // of the shifts that are across, and down
    for (const DepthView& view : views.others) {
        share.x += view.shift.x * view.shift.x;
        share.y += view.shift.y * view.shift.y;
    }
    const float all = float(share.x + share.y), across = float(share.x) / all,
                down = float(share.y) / all;
    std::vector<float> change(views.pixels()); // squared, for a pixel's shift
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto at = [&](int i, int j) {
                return std::size_t(std::clamp(j, 0, height - 1)) * width +
                       std::clamp(i, 0, width - 1);
            };
            float sum = 0;
            for (const auto& c : views.middle.channels) {
                const float dx = c[at(x + 1, y)] - c[at(x - 1, y)],
                            dy = c[at(x, y + 1)] - c[at(x, y - 1)];
                sum += 0.25f * (across * dx * dx + down * dy * dy);
            }
            change[at(x, y)] = sum;
        }
    const float part = float(settings.tolerance * settings.tolerance),
                noise = float(settings.noise * settings.noise);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float sum = 0; // around the pixel, as the change at a line's middle is 0
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    sum += change[std::size_t(std::clamp(y + j, 0, height - 1)) * width +
                                  std::clamp(x + i, 0, width - 1)];
            sharpness_[std::size_t(y) * width + x] = 1 / (noise + part * sum / 9);
        }
}

namespace {

/// A row of a channel, shifted by fractions of a pixel: pixels [span.first, span.last) of `to`.
void shift_row(const std::vector<float>& channel, int width, int y, const Shift& across,
               const Shift& down, const Span& span, float* tall, float* to)
{
    const int first = span.first + across.whole - across.before(),
              last = span.last + across.whole + across.after();
    const float* row = channel.data() + std::ptrdiff_t(y + down.whole) * width;
    if (!down.is_whole) {
        const float *a = row - width, *b = row + width, *c = b + width;
        const float w0 = down.weight[0], w1 = down.weight[1], w2 = down.weight[2],
                    w3 = down.weight[3];
        for (int x = first; x < last; ++x)
            tall[x] = w0 * a[x] + w1 * row[x] + w2 * b[x] + w3 * c[x];
        row = tall;
    }
    const float* from = row + across.whole;
    if (across.is_whole) {
        std::copy(from + span.first, from + span.last, to + span.first);
        return;
    }
    const float w0 = across.weight[0], w1 = across.weight[1], w2 = across.weight[2],
                w3 = across.weight[3];
    for (int x = span.first; x < span.last; ++x)
        to[x] = w0 * from[x - 1] + w1 * from[x] + w2 * from[x + 1] + w3 * from[x + 2];
}

} // namespace

void Votes::add_view(const DepthView& view, double disparity, int y, Sums& sums) const
{
    const int width = views_.width;
    const Shift across(disparity * view.shift.x), down(disparity * view.shift.y);
    const Span rows(down, views_.height), span(across, width);
    if (y < rows.first || y >= rows.last || span.first >= span.last)
        return;
    for (std::size_t c = 0; c < 3; ++c)
        shift_row(view.channels[c], width, y, across, down, span, sums.tall.data(),
                  sums.wide.data() + c * sums.tall.size());
    const std::size_t row = std::size_t(y) * width;
    const float *r = sums.wide.data(), *g = r + sums.tall.size(), *b = g + sums.tall.size();
    const float *r0 = views_.middle.channels[0].data() + row,
                *g0 = views_.middle.channels[1].data() + row,
                *b0 = views_.middle.channels[2].data() + row, *sharpness = sharpness_.data() + row;
    float* vote = sums.vote.data();
    for (int x = span.first; x < span.last; ++x) {
        const float dr = r[x] - r0[x], dg = g[x] - g0[x], db = b[x] - b0[x];
        vote[x] = std::max(0.0f, 1 - sharpness[x] * (dr * dr + dg * dg + db * db));
    }
    const float* lit = view.lit.empty()
                           ? nullptr
                           : view.lit.data() +
                                 std::size_t(y + int(std::lround(disparity * view.shift.y))) *
                                     width +
                                 std::lround(disparity * view.shift.x);
    const bool in_half[Sums::kinds] = {true, view.shift.x > 0, view.shift.x<0, view.shift.y> 0,
                                       view.shift.y < 0};
    for (int kind = 0; kind < (settings_.halves ? Sums::kinds : 1); ++kind) {
        if (!in_half[kind])
            continue;
        float *votes = sums.votes[kind].data(), *number = sums.number[kind].data();
        if (lit)
            for (int x = span.first; x < span.last; ++x) {
                votes[x] += lit[x] * vote[x];
                number[x] += lit[x];
            }
        else
            for (int x = span.first; x < span.last; ++x) {
                votes[x] += vote[x];
                number[x] += 1;
            }
    }
}

void Votes::finish_row(const Sums& sums, float* mean) const
{
    // A half has seen less than all views: it takes some more to believe it.
    constexpr float trust = 0.9f;
    const float least = 0.15f * float(views_.others.size());
    for (int x = 0; x < views_.width; ++x)
        mean[x] = sums.votes[0][std::size_t(x)] / std::max(least, sums.number[0][std::size_t(x)]);
    if (!settings_.halves)
        return;
    for (int kind = 1; kind < Sums::kinds; ++kind) {
        const float *votes = sums.votes[kind].data(), *number = sums.number[kind].data();
        for (int x = 0; x < views_.width; ++x)
            mean[x] = std::max(mean[x], trust * votes[x] / std::max(least, number[x]));
    }
}

void Votes::count(double disparity, int first, int rows, float* mean) const
{
    Sums sums(views_.width);
    for (int y = first; y < first + rows; ++y, mean += views_.width) {
        sums.clear();
        for (const DepthView& view : views_.others)
            add_view(view, disparity, y, sums);
        finish_row(sums, mean);
    }
}

} // namespace integral
