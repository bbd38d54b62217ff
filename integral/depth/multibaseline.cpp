// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/multibaseline.h"

#include "integral/depth/reflections.h"
#include "integral/depth/surface_fill.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int rows_of_a_block = 32;

double farthest_shift(const ViewSet& views)
{
    double farthest = 0;
    for (const DepthView& view : views.others)
        farthest = std::max({farthest, std::fabs(view.shift.x), std::fabs(view.shift.y)});
    return farthest;
}

/// Stretches the filter vertically for pixels wider than high, as behind lenticular sheets.
EdgeFilterSettings stretched(EdgeFilterSettings filter, const ViewSet& views)
{
    constexpr double most = 4;
    const double wide = length(views.places.right) / length(views.places.down);
    filter.down = int(std::lround(filter.down * std::clamp(wide, 1.0, most)));
    return filter;
}

constexpr double rough_step = 0.08;

/// Sorted disparities of the confident pixels with texture, from some of the rows.
std::vector<float> sure_disparities(const ViewSet& views, const VoteSettings& settings,
                                    double widest, int threads)
{
    constexpr int rows_apart = 12, rows_at_once = 2, least_pieces = 40;
    constexpr float least_confidence = 0.12f, least_change = 0.006f;
    const Votes votes(views, settings);
    const Search search(views, votes, {3, 1, 0.06}, Labels({-widest, widest}, rough_step));
    DepthMap map = blank_map(views);
    const int pieces = std::max(
        {1, views.height / rows_apart, std::min(least_pieces, views.height / rows_at_once)});
    for_each_row(pieces, threads, [&](int piece) {
        const int first = piece * views.height / pieces,
                  last = std::min(views.height, first + rows_at_once);
        search.rows(first, last, map);
    });
    const auto change = [&](std::size_t i) { // difference of colour between a pixel and the next
        float sum = 0;
        for (const auto& channel : views.colours)
            sum += std::fabs(channel[i + 1] - channel[i]);
        return sum;
    };
    std::vector<float> sure; // where there is texture and the next pixel agrees
    for (std::size_t i = 0; i + 1 < map.confidence.size(); ++i)
        if (map.confidence[i] > least_confidence && map.confidence[i + 1] > least_confidence &&
            change(i) > least_change &&
            std::fabs(map.disparity[i] - map.disparity[i + 1]) < 0.25 * rough_step)
            sure.push_back(map.disparity[i]);
    std::sort(sure.begin(), sure.end());
    return sure;
}

/// Range of all sorted values but two thousandths at each end, with a margin. False matches lie
/// anywhere in [-widest, widest], so the ends are cut where values are sparse.
DisparityRange range_of(const std::vector<float>& sure, double widest)
{
    constexpr double bin = 0.25, sparse = 0.15; // of the mean number of values in a bin
    const double few = sparse * double(sure.size()) * bin / (2 * widest);
    const auto part = [&](double fraction) {
        return double(sure[std::size_t(fraction * double(sure.size() - 1))]);
    };
    const auto is_sparse = [&](double from) {
        const auto first = std::lower_bound(sure.begin(), sure.end(), float(from));
        return double(std::lower_bound(first, sure.end(), float(from + bin)) - first) < few;
    };
    double least = part(0.002), greatest = part(0.998);
    while (least + bin < greatest && is_sparse(least))
        least += bin;
    while (least < greatest - bin && is_sparse(greatest - bin))
        greatest -= bin;
    const double margin = 2 * rough_step + 0.1 * (greatest - least);
    return {least - margin, greatest + margin};
}

/// The range with a quarter of its length more at each end, for parts without visible texture.
DisparityRange with_room(DisparityRange range)
{
    const double room = 0.25 * (range.greatest - range.least);
    return {range.least - room, range.greatest + room};
}

} // namespace

DisparityRange find_range(const ViewSet& views, const VoteSettings& settings, int threads)
{
    constexpr double usual = 4, widest = 16;
    constexpr std::size_t least_number = 20, many = 200;
    VoteSettings rough = settings; // a coarse step needs more tolerance
    rough.tolerance = std::max(settings.tolerance, 0.5 * rough_step * farthest_shift(views));
    rough.cross = true; // other views would add time, and false matches if views have few pixels
    const auto sure = sure_disparities(views, rough, usual, threads);
    if (sure.size() >= least_number) {
        const DisparityRange found = range_of(sure, usual);
        if (found.least > -usual && found.greatest < usual)
            return found;
    }
    // The scene extends beyond the usual range, or few pixels are confident. Distant parts may lack
    // visible texture, so the far end is at infinity.
    const auto wide = sure_disparities(views, rough, widest, threads);
    if (!views.scale && wide.size() >= many) { // where infinity is, is not known
        const DisparityRange room = with_room(range_of(wide, widest));
        if (room.least > -widest && room.greatest < widest)
            return room;
    }
    const double nearest = wide.size() >= least_number ? range_of(wide, widest).greatest : usual;
    return {-std::min(widest, views.scale ? views.scale->ratio : widest), std::max(usual, nearest)};
}

std::optional<DepthMap> multibaseline(const ViewSet& views, const MultibaselineSettings& settings,
                                      int threads, const Progress& progress)
{
    const DisparityRange range = settings.range ? *settings.range
                                                : find_range(views, settings.votes, threads);
    constexpr int most_labels = 200; // more cost time, and hardly any view resolves them
    const double farthest = std::max(1.0, farthest_shift(views)),
                 step = std::max(settings.step / farthest,
                                 (range.greatest - range.least) / most_labels);
    VoteSettings of_votes = settings.votes; // a coarse step needs more tolerance
    of_votes.tolerance = std::max(of_votes.tolerance, 0.5 * step * farthest);
    const Votes votes(views, of_votes);
    const Search search(views, votes, stretched(settings.filter, views), Labels(range, step));
    DepthMap map = blank_map(views);
    map.range = range;
    if (!search.all_rows(threads, map, progress))
        return std::nullopt;
    if (settings.reach > 0) {
        flatten_reflections(views, step, threads, map);
        fill_surfaces(views, settings.reach, threads, map.disparity, map.confidence);
    }
    const EdgeFilterSettings median = stretched(settings.median, views);
    std::vector<float> smooth(map.disparity.size());
    const int blocks = (views.height + rows_of_a_block - 1) / rows_of_a_block;
    for_each_row(blocks, threads, [&](int k) {
        const int first = k * rows_of_a_block;
        weighted_median(views, map.disparity, map.confidence, median, first,
                        std::min(views.height, first + rows_of_a_block), smooth);
    });
    map.disparity = std::move(smooth);
    return map;
}

} // namespace integral
