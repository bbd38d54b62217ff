// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/disparity_search.h"

#include <algorithm>
#include <cmath>

namespace integral {

Labels::Labels(DisparityRange range, double wanted_step)
    : first(range.least),
      count(std::max(3, int(std::ceil((range.greatest - range.least) / wanted_step)) + 1)),
      step((range.greatest - range.least) / (count - 1))
{
}

namespace {

constexpr int rows_of_a_block = 32;

/// The best label of each pixel so far, its mean vote, and the mean votes of its two neighbours.
class Winners {
public:
    explicit Winners(std::size_t pixels)
        : label_(pixels, 0),
          best_(pixels, -1),
          before_(pixels, 0),
          after_(pixels, 0),
          last_(pixels, 0),
          sum_(pixels, 0)
    {
    }
    /// Adds the mean votes of the next label.
    void add(int label, const float* mean)
    {
        for (std::size_t i = 0; i < best_.size(); ++i) {
            if (label_[i] == label - 1)
                after_[i] = mean[i];
            if (mean[i] > best_[i]) {
                best_[i] = mean[i];
                label_[i] = label;
                before_[i] = after_[i] = last_[i];
            }
            last_[i] = mean[i];
            sum_[i] += mean[i];
        }
    }
    /// Fractional label at the top of the parabola through the three means; whole at the ends.
    double label(std::size_t i, int count) const
    {
        if (label_[i] == 0 || label_[i] == count - 1)
            return label_[i];
        const double bend = 2 * best_[i] - before_[i] - after_[i];
        return bend > 0 ? label_[i] + 0.5 * (after_[i] - before_[i]) / bend : label_[i];
    }
    float confidence(std::size_t i, int count) const
    {
        return std::clamp(best_[i] - sum_[i] / float(count), 0.0f, 1.0f);
    }

private:
    std::vector<int> label_;
    std::vector<float> best_, before_, after_, last_, sum_;
};

} // namespace

DepthMap blank_map(const ViewSet& views)
{
    DepthMap map;
    map.width = views.width;
    map.height = views.height;
    map.disparity.resize(views.pixels());
    map.confidence.resize(views.pixels());
    return map;
}

Search::Search(const ViewSet& views, const Votes& votes, const EdgeFilterSettings& filter,
               const Labels& labels)
    : views_(views), votes_(votes), filter_(filter), labels_(labels)
{
}

void Search::rows(int first, int last, DepthMap& map) const
{
    const int top = std::max(0, first - filter_.down),
              bottom = std::min(views_.height, last + filter_.down), rows = bottom - top;
    const std::size_t width = std::size_t(views_.width), count = width * (last - first);
    const EdgeFilter filter(views_, top, rows, filter_);
    std::vector<float> mean(width * rows), other(mean.size());
    Winners winners(count);
    for (int label = 0; label < labels_.count; ++label) {
        votes_.count(labels_.at(label), top, rows, mean.data());
        filter.apply(mean.data(), other.data());
        winners.add(label, mean.data() + width * (first - top));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = width * first + i;
        const bool lit = views_.is_lit(at);
        map.disparity[at] = lit ? float(labels_.at(winners.label(i, labels_.count))) : NAN;
        map.confidence[at] = lit ? winners.confidence(i, labels_.count) : 0;
    }
}

bool Search::all_rows(int threads, DepthMap& map, const Progress& progress) const
{
    const int blocks = (views_.height + rows_of_a_block - 1) / rows_of_a_block;
    return for_each_row(
        blocks, threads,
        [&](int k) {
            const int first = k * rows_of_a_block;
            rows(first, std::min(views_.height, first + rows_of_a_block), map);
        },
        progress);
}

} // namespace integral
