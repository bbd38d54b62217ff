// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/votes.h"

#include "integral/depth/row_loops.h"

#include <algorithm>
#include <cmath>

namespace integral {

namespace {

/// A shift along one axis: whole pixels, and the weights of the four pixels around the shifted
/// place (the cubic of Catmull and Rom).
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

/// Whether a view belongs to a kind of sum: of all views (0), or of a half of them (1 to 4).
bool is_in_half(const DepthView& view, int kind)
{
    const bool in_half[] = {true, view.shift.x > 0, view.shift.x<0, view.shift.y> 0,
                            view.shift.y < 0};
    return in_half[kind];
}

/// The pixels, out of `size`, for which the shift needs no pixel outside [0, size).
PixelRange range_after(const Shift& shift, int size)
{
    return {std::max(0, shift.before() - shift.whole),
            std::min(size, size - shift.after() - shift.whole)};
}

} // namespace

bool is_in_cross(Vec2 shift) { return std::min(std::fabs(shift.x), std::fabs(shift.y)) < 0.51; }

/// Sums of votes and numbers of votes for one row, over all views, and over the views
/// on each of the four sides of the middle one (is_in_half).
struct Votes::Sums {
    static constexpr int kinds = 5;
    explicit Sums(int width) : between(3 * std::size_t(width))
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
    std::vector<float> votes[kinds], number[kinds], vote;
    std::vector<float> between; ///< a row of each channel, interpolated between rows of the view
};

/// Squared change of the colours at each pixel of the middle view under a shift by a pixel.
/// `share`: weights of shifts across and down.
static std::vector<float> squared_changes(const ViewSet& views, Vec2 share)
{
    const int width = views.width, height = views.height;
    const float all = float(share.x + share.y), across = float(share.x) / all,
                down = float(share.y) / all;
    std::vector<float> change(views.pixels());
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
    return change;
}

Votes::Votes(const ViewSet& views, const VoteSettings& settings)
    : views_(views),
      settings_(settings),
      sharpness_(views.pixels()),
      ones_(std::size_t(views.width), 1)
{
    const int width = views.width, height = views.height;
    Vec2 share{1e-9, 1e-9}; // sums of the views' squared shifts, across and down
    for (const DepthView& view : views.others) {
        if (settings.cross && !is_in_cross(view.shift))
            continue;
        ++views_used_;
        for (int kind = 1; kind < Sums::kinds; ++kind)
            views_in_half_[kind - 1] += is_in_half(view, kind);
        share.x += view.shift.x * view.shift.x;
        share.y += view.shift.y * view.shift.y;
    }
    const std::vector<float> change = squared_changes(views, share);
    const float part = float(settings.tolerance * settings.tolerance),
                noise = float(settings.noise * settings.noise);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float sum = 0; // over 3 x 3 pixels, as the change in the middle of a thin line is 0
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i)
                    sum += change[std::size_t(std::clamp(y + j, 0, height - 1)) * width +
                                  std::clamp(x + i, 0, width - 1)];
            sharpness_[std::size_t(y) * width + x] = 1 / (noise + part * sum / 9);
        }
}

void Votes::vote(const DepthView& view, double disparity, int y, const PixelRange& columns,
                 Sums& sums) const
{
    const int width = views_.width;
    const Shift across(disparity * view.shift.x), down(disparity * view.shift.y);
    const int first = columns.first + across.whole - across.before(),
              last = columns.last + across.whole + across.after();
    RowsToCompare rows{};
    const std::size_t own = std::size_t(y) * width + columns.first;
    for (std::size_t c = 0; c < 3; ++c) {
        const float* row = view.channels[c].data() + std::ptrdiff_t(y + down.whole) * width;
        if (!down.is_whole) {
            float* between = sums.between.data() + c * std::size_t(width);
            mix_rows(between + first, row - width + first, row + first, row + width + first,
                     row + 2 * width + first, down.weight, last - first);
            row = between;
        }
        rows.view[c] = row + columns.first + across.whole;
        rows.middle[c] = views_.middle.channels[c].data() + own;
    }
    rows.sharpness = sharpness_.data() + own;
    float* vote = sums.vote.data() + columns.first;
    if (across.is_whole)
        vote_for(vote, rows, columns.last - columns.first);
    else
        vote_between(vote, rows, across.weight, columns.last - columns.first);
}

void Votes::add_view(const DepthView& view, double disparity, int y, Sums& sums) const
{
    const Vec2 shift = disparity * view.shift;
    const PixelRange rows = range_after(Shift(shift.y), views_.height),
                     columns = range_after(Shift(shift.x), views_.width);
    if (y < rows.first || y >= rows.last || columns.first >= columns.last)
        return;
    vote(view, disparity, y, columns, sums);
    const int count = columns.last - columns.first;
    const float* vote = sums.vote.data() + columns.first;
    const float* lit = nullptr;
    if (!view.lit.empty())
        lit = view.lit.data() + std::ptrdiff_t(y + std::lround(shift.y)) * views_.width +
              std::lround(shift.x) + columns.first;
    for (int kind = 0; kind < (settings_.halves ? Sums::kinds : 1); ++kind) {
        if (!is_in_half(view, kind))
            continue;
        float *votes = sums.votes[kind].data() + columns.first,
              *number = sums.number[kind].data() + columns.first;
        if (lit) {
            add_product(votes, lit, vote, count);
            add(number, lit, count);
        } else {
            add(votes, vote, count);
            add(number, ones_.data(), count);
        }
    }
}

void Votes::finish_row(const Sums& sums, float* mean) const
{
    const float least = 0.15f * float(views_used_);
    for (int x = 0; x < views_.width; ++x)
        mean[x] = sums.votes[0][std::size_t(x)] / std::max(least, sums.number[0][std::size_t(x)]);
    if (!settings_.halves)
        return;
    for (int kind = 1; kind < Sums::kinds; ++kind) {
        // The fewer views a half has, the more easily all of them agree by chance.
        const float trust = std::max(0.0f, 1 - 2.0f / float(std::max(1, views_in_half_[kind - 1])));
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
            if (!settings_.cross || is_in_cross(view.shift))
                add_view(view, disparity, y, sums);
        finish_row(sums, mean);
    }
}

} // namespace integral
