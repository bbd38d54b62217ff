// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/ray_trace.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// Counts, in bins of disparity, the rays that one ray meets.
class Meetings {
public:
    explicit Meetings(const RayTraceSettings& settings)
        : range_(settings.range), count_(std::size_t(settings.bins))
    {
    }
    void clear() { std::fill(count_.begin(), count_.end(), 0); }
    void add(double disparity)
    {
        const double bin = (disparity - range_.least) / (range_.greatest - range_.least) *
                           double(count_.size());
        if (bin >= 0 && bin < double(count_.size()))
            ++count_[std::size_t(bin)];
    }
    double disparity(std::size_t bin) const
    {
        return range_.least +
               (double(bin) + 0.5) / double(count_.size()) * (range_.greatest - range_.least);
    }
    std::size_t fullest() const
    {
        std::size_t best = 0;
        for (std::size_t bin = 1; bin < count_.size(); ++bin)
            if (count_[bin] > count_[best] ||
                (count_[bin] == count_[best] &&
                 std::fabs(disparity(bin)) < std::fabs(disparity(best))))
                best = bin;
        return best;
    }
    int count(std::size_t bin) const { return count_[bin]; }

private:
    DisparityRange range_;
    std::vector<int> count_;
};

class RayTracer {
public:
    RayTracer(const ViewSet& views, const RayTraceSettings& settings)
        : views_(views), settings_(settings)
    {
    }

    void row(int y, DepthMap& map) const
    {
        Meetings meetings(settings_);
        for (int x = 0; x < views_.width; ++x) {
            const std::size_t at = std::size_t(y) * views_.width + x;
            map.disparity[at] = NAN;
            if (!views_.is_lit(at))
                continue;
            meetings.clear();
            for (const DepthView& view : views_.others)
                meet(view, x, y, meetings);
            const std::size_t best = meetings.fullest();
            map.disparity[at] = float(meetings.disparity(best));
            map.confidence[at] = std::min(1.0f, float(meetings.count(best)) /
                                                    float(views_.others.size()));
        }
    }

private:
    /// Counts where a pixel's ray meets rays of a view's pixels, which lie on one line in the view:
    /// compares, for each whole pixel along the line's longer side, the pixel nearest to the line.
    void meet(const DepthView& view, int x, int y, Meetings& meetings) const
    {
        const Vec2 shift = view.shift;
        const bool across = std::fabs(shift.x) >= std::fabs(shift.y);
        const double along = across ? shift.x : shift.y;
        const double ends[] = {along * settings_.range.least, along * settings_.range.greatest};
        for (int k = int(std::ceil(std::min(ends[0], ends[1])));
             k <= int(std::floor(std::max(ends[0], ends[1]))); ++k) {
            const double disparity = k / along;
            const int i = across ? x + k : x + int(std::lround(disparity * shift.x)),
                      j = across ? y + int(std::lround(disparity * shift.y)) : y + k;
            if (i >= 0 && j >= 0 && i < views_.width && j < views_.height &&
                is_like(view, std::size_t(j) * views_.width + i, std::size_t(y) * views_.width + x))
                meetings.add(disparity);
        }
    }

    bool is_like(const DepthView& view, std::size_t pixel, std::size_t own) const
    {
        if (!view.lit.empty() && !(view.lit[pixel] > 0))
            return false;
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = view.channels[c][pixel] - views_.middle.channels[c][own];
            sum += d * d;
        }
        return sum < settings_.colour * settings_.colour;
    }

    const ViewSet& views_;
    RayTraceSettings settings_;
};

} // namespace

std::optional<DepthMap> ray_trace(const ViewSet& views, const RayTraceSettings& settings,
                                  int threads, const Progress& progress)
{
    DepthMap map;
    map.width = views.width;
    map.height = views.height;
    map.range = settings.range;
    map.disparity.resize(views.pixels());
    map.confidence.resize(views.pixels());
    const RayTracer tracer(views, settings);
    if (!for_each_row(
            views.height, threads, [&](int y) { tracer.row(y, map); }, progress))
        return std::nullopt;
    return map;
}

} // namespace integral
