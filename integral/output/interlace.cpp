// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/interlace.h"

#include "integral/output/interlace_rows.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>

namespace integral {
namespace {

constexpr int channels = 3;
constexpr int rows_a_block = 32;

void check_image(const Image& image)
{
    if (image.channels != channels || sample_bits(image) > 16)
        throw std::invalid_argument("views of three channels of 8 or 16 bits are expected");
}

/// Calls work(first, end) for blocks of rows: what is prepared for one row serves the next ones.
void for_each_block(int height, int threads, const std::function<void(int first, int end)>& work)
{
    for_each_row((height + rows_a_block - 1) / rows_a_block, threads, [&](int block) {
        work(block * rows_a_block, std::min(height, (block + 1) * rows_a_block));
    });
}

} // namespace

ViewPictures::ViewPictures(const Image& quilt, ViewGrid views)
    : grid(views),
      width(views.columns > 0 ? quilt.width / views.columns : 0),
      height(views.rows > 0 ? quilt.height / views.rows : 0),
      form(&quilt),
      row_step(std::size_t(quilt.width) * channels)
{
    check_image(quilt);
    if (width < 1 || height < 1)
        throw std::invalid_argument(
            std::to_string(quilt.width) + "x" + std::to_string(quilt.height) + " pixels hold no " +
            std::to_string(grid.columns) + "x" + std::to_string(grid.rows) + " views");
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            images_.push_back(&quilt);
            begin_.push_back(std::size_t(quilt.height - (row + 1) * height) * row_step +
                             std::size_t(column) * width * channels);
        }
}

ViewPictures::ViewPictures(const std::vector<Image>& views, ViewGrid numbers) : grid(numbers)
{
    if (grid.count() < 1 || int(views.size()) != grid.count())
        throw std::invalid_argument("there are " + std::to_string(views.size()) + " views, not " +
                                    std::to_string(grid.count()));
    form = &views[0];
    width = form->width;
    height = form->height;
    row_step = std::size_t(width) * channels;
    for (const Image& view : views) {
        check_image(view);
        if (!same_form(view, *form))
            throw std::invalid_argument("the views differ in size or form");
        images_.push_back(&view);
        begin_.push_back(0);
    }
}

Image panel_image(const ViewPictures& views, int width, int height)
{
    return blank_like(*views.form, width, height);
}

namespace {

/// Rows of all views' pictures, brought close together as interlace_row reads them.
template <class Sample> class KeptRows {
public:
    KeptRows(const ViewPictures& views, bool in_pairs, bool one_at_a_time)
        : views_(views),
          in_pairs_(in_pairs),
          places_(one_at_a_time ? 1 : int(rows_kept)),
          view_step_(spread(std::size_t(views.width) * channels * (in_pairs ? 2 : 1))),
          row_step_(view_step_ * views.grid.count()),
          samples_((one_at_a_time ? 1 : rows_kept) * row_step_ + view_step_ + 8)
    {
        kept_.fill(-1);
    }

    /// Whether interlace_row can count the places in rows of so large views: 31 bits.
    static bool can_hold(const ViewPictures& views)
    {
        return (2.0 * views.width * channels + 128) * (views.grid.count() + 1) * rows_kept <
                   0x7fffff00 &&
               views.width < 32768;
    }

    /// Makes sure that row k of the views is there.
    void keep(int k)
    {
        if (kept_[k % places_] == k)
            return;
        kept_[k % places_] = k;
        const std::size_t count = std::size_t(views_.width) * channels;
        const std::size_t below = k + 1 < views_.height ? views_.row_step : 0;
        for (int view = 0; view < views_.grid.count(); ++view) {
            const Sample* row = views_.first<Sample>(view) + k * views_.row_step;
            Sample* to = samples_.data() + k % places_ * row_step_ + view * view_step_;
            if (in_pairs_)
                pair_rows(to, row, row + below, count);
            else
                std::memcpy(to, row, count * sizeof(Sample));
        }
    }

    /// Rows first to last, which are kept.
    ViewRows<Sample> rows(int first, int last) const
    {
        if (first == last)
            return {samples_.data() + first % places_ * row_step_, std::uint32_t(view_step_), 0};
        return {samples_.data(), std::uint32_t(view_step_), std::uint32_t(row_step_)};
    }

private:
    /// Samples from view to view: they take an odd number of the cache's lines, so that one place
    /// in all views does not fall into a few of the cache's sets.
    static std::size_t spread(std::size_t samples)
    {
        return ((samples * sizeof(Sample) + 63) / 64 | 1) * 64 / sizeof(Sample);
    }

    const ViewPictures& views_;
    const bool in_pairs_;
    const int places_; ///< row k is at place k % places_
    const std::size_t view_step_, row_step_;
    std::vector<Sample> samples_;
    std::array<int, rows_kept> kept_;
};

/// Interlaces one panel image.
template <class Sample> class Interlacer {
public:
    Interlacer(Image& panel, const ViewPictures& views, const PanelMapping& mapping, Blend blend)
        : samples_(std::get<std::vector<Sample>>(panel.samples)),
          views_(views),
          mapping_(mapping),
          blending_{blend.views == Neighbours::linear, blend.pixels == Neighbours::linear,
                    mapping.y.columns == 1},
          views_up_(mapping.up.rows > 0 ? views.grid.rows : 1),
          views_across_(views.grid.count() / views_up_)
    {
        for (int view = 0; view < views.grid.count(); ++view)
            first_.push_back(views.first<Sample>(view));
        if (mapping.x.rows == 1)
            for (int i = 0; i < mapping.width * channels; ++i)
                x_of_all_.push_back(
                    step_among(std::uint32_t(views.width), mapping.x.row(0)[i], blending_.pixels));
    }

    /// Rows [first, end) of the panel.
    void make_rows(int first, int end) const
    {
        std::optional<KeptRows<Sample>> kept;
        if (views_up_ == 1 && KeptRows<Sample>::can_hold(views_))
            kept.emplace(views_, blending_.pixels, mapping_.y.columns == 1);
        for (int y = first; y < end; ++y) {
            const PanelRow row = row_of_panel(y);
            Sample* const samples = samples_.data() + std::size_t(y) * row.count;
            if (!kept || !make_of_kept_rows(samples, row, *kept))
                make_one_by_one(samples, row, y);
        }
    }

private:
    PanelRow row_of_panel(int y) const
    {
        const auto axis = [&](const PhaseTable& table, int parts) {
            return RowAxis{table.row(y), std::uint32_t(parts)};
        };
        return {mapping_.width * channels,
                axis(mapping_.across, views_across_),
                axis(mapping_.x, views_.width),
                axis(mapping_.y, views_.height),
                x_of_all_.empty() ? nullptr : x_of_all_.data(),
                mapping_.has_unseen};
    }

    /// Returns whether it has: not where the panel's row shows more rows of pixels than are kept.
    bool make_of_kept_rows(Sample* samples, const PanelRow& row, KeptRows<Sample>& kept) const
    {
        const PhaseRow& phases = row.y.phases;
        const Range range = range_of(phases.high, phases.is_one ? 1 : row.count);
        const auto pixel_row = [&](std::uint16_t high) {
            const PhaseRow one{&high, phases.low, phases.shift, true};
            return int(index_of(step_among(row.y.parts, one[0], blending_.pixels)));
        };
        const int first = pixel_row(range.least), last = pixel_row(range.greatest);
        if (last - first >= int(rows_kept))
            return false;
        for (int k = first; k <= last; ++k)
            kept.keep(k);
        interlace_row(samples, row, kept.rows(first, last), blending_);
        return true;
    }

    /// Straight from the views' pictures: for round lenses, and what cannot be made of kept rows.
    void make_one_by_one(Sample* samples, const PanelRow& row, int y) const
    {
        for (int i = 0; i < row.count; ++i) {
            const std::uint32_t phase = row.across.phases[i];
            if (row.has_unseen && phase == PanelMapping::unseen) {
                samples[i] = 0;
                continue;
            }
            const Step up = views_up_ == 1 ? 0
                                           : step_among(std::uint32_t(views_up_),
                                                        mapping_.up.row(y)[i], blending_.views);
            samples[i] = sample(step_among(row.across.parts, phase, blending_.views), up,
                                step_among(row.x.parts, row.x.phases[i], blending_.pixels),
                                step_among(row.y.parts, row.y.phases[i], blending_.pixels),
                                i % channels);
        }
    }

    Sample sample(Step across, Step up, Step x, Step y, int channel) const
    {
        const std::size_t place = index_of(y) * views_.row_step + index_of(x) * channels + channel;
        const std::size_t right = weight_of(x) ? channels : 0, // no farther than the picture
            below = weight_of(y) ? views_.row_step : 0;
        const auto pixel = [&](int view) {
            const Sample* at = first_[std::size_t(view)] + place;
            return blend_pixels(at[0], at[below], at[right], at[below + right], x, y,
                                blending_.rounds_rows);
        };
        const auto line = [&](std::uint32_t row) { // 2^24 times the value
            const int view = int(row) * views_across_ + int(index_of(across));
            return blend(pixel(view), pixel(view + (weight_of(across) ? 1 : 0)), across);
        };
        const std::uint32_t row = index_of(up);
        const std::uint64_t sum = blend(line(row), line(row + (weight_of(up) ? 1 : 0)), up);
        return Sample((sum + (std::uint64_t(1) << 31)) >> 32);
    }

    std::vector<Sample>& samples_;
    const ViewPictures& views_;
    const PanelMapping& mapping_;
    const Blending blending_;
    const int views_up_, views_across_;
    std::vector<const Sample*> first_; ///< of each view
    std::vector<Step> x_of_all_; ///< across a view's picture, where all rows have the same; else
                                 ///< empty
};

template <class Sample>
void interlace_as(Image& panel, const ViewPictures& views, const PanelMapping& mapping, Blend blend,
                  int threads)
{
    const Interlacer<Sample> interlacer(panel, views, mapping, blend);
    for_each_block(panel.height, threads,
                   [&](int first, int end) { interlacer.make_rows(first, end); });
}

} // namespace

void interlace(Image& panel, const ViewPictures& views, const PanelMapping& mapping, Blend blend,
               int threads)
{
    if (panel.width != mapping.width || panel.height != mapping.height ||
        panel.channels != channels || panel.samples.index() != views.form->samples.index())
        throw std::invalid_argument(
            "the panel's image is not of the views' form and the panel's size");
    (sample_bits(panel) == 8 ? interlace_as<std::uint8_t>
                             : interlace_as<std::uint16_t>)(panel, views, mapping, blend, threads);
}

} // namespace integral
