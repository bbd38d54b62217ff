// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/interlace.h"

#include "integral/panel/interlace_rows.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
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

/// Calls work(first, end) for blocks of rows, so that data prepared for one row serve the next
/// rows.
void for_each_block(int height, int threads, const std::function<void(int first, int end)>& work)
{
    for_each_row((height + rows_a_block - 1) / rows_a_block, threads, [&](int block) {
        work(block * rows_a_block, std::min(height, (block + 1) * rows_a_block));
    });
}

} // namespace

ViewRaster::ViewRaster(const Image& quilt, ViewGrid views)
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

ViewRaster::ViewRaster(const std::vector<Image>& views, ViewGrid numbers) : grid(numbers)
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

Image panel_image(const ViewRaster& views, int width, int height)
{
    return blank_like(*views.form, width, height);
}

namespace {

/// Caches rows of all views' pictures in the layout that interlace_row reads.
template <class Sample> class RowCache {
public:
    /// `blended`: caches the rounded blend of the two picture rows that a row of the panel shows.
    /// Otherwise `in_pairs`: caches each sample together with the sample below it.
    RowCache(const ViewRaster& views, bool blended, bool in_pairs)
        : views_(views),
          blended_(blended),
          in_pairs_(in_pairs && !blended),
          places_(blended ? 1 : int(rows_kept)),
          view_step_(spread(std::size_t(views.width) * channels * (in_pairs_ ? 2 : 1))),
          row_step_(view_step_ * views.grid.count()),
          samples_(std::size_t(places_) * row_step_ + view_step_ + 8)
    {
    }

    /// Whether the places of samples in cached rows of these views fit interlace_row's 31 bits.
    static bool can_hold(const ViewRaster& views)
    {
        return (2.0 * views.width * channels + 128) * (views.grid.count() + 1) * rows_kept <
                   0x7fffff00 &&
               views.width < 32768;
    }

    /// Makes sure that the views' row for a step is cached.
    void keep(Step y)
    {
        const int k = int(index_of(y)), place = k % places_;
        const Step kept = blended_ ? y : Step(k) << 8;
        if (kept_[place] == kept)
            return;
        kept_[place] = kept;
        const std::size_t count = std::size_t(views_.width) * channels;
        const std::size_t below = k + 1 < views_.height ? views_.row_step : 0;
        for (int view = 0; view < views_.grid.count(); ++view) {
            const Sample* row = views_.first<Sample>(view) + k * views_.row_step;
            Sample* to = samples_.data() + place * row_step_ + view * view_step_;
            if (in_pairs_)
                pair_rows(to, row, row + below, count);
            else if (weight_of(kept) > 0)
                blend_rows(to, row, row + below, count, kept);
            else
                std::memcpy(to, row, count * sizeof(Sample));
        }
    }

    /// Rows first to last, which must be cached.
    ViewRows<Sample> rows(int first, int last) const
    {
        if (first == last)
            return {samples_.data() + first % places_ * row_step_, std::uint32_t(view_step_), 0};
        return {samples_.data(), std::uint32_t(view_step_), std::uint32_t(row_step_)};
    }

private:
    /// Samples from one view's row to the next view's: an odd number of the processor's cache
    /// lines, so that the same place in all views does not fall into a few sets of the processor's
    /// cache.
    static std::size_t spread(std::size_t samples)
    {
        return ((samples * sizeof(Sample) + 63) / 64 | 1) * 64 / sizeof(Sample);
    }

    const ViewRaster& views_;
    const bool blended_, in_pairs_;
    const int places_; ///< number of rows cached; row k is at place k % places_
    const std::size_t view_step_, row_step_;
    std::vector<Sample> samples_;
    std::array<std::optional<Step>, rows_kept> kept_; ///< the step cached at each place
};

/// Pool of objects that blocks of rows borrow, so that memory is allocated and cleared only once
/// per thread.
template <class Kept> class ObjectPool {
public:
    template <class Make> std::unique_ptr<Kept> take(Make make)
    {
        {
            const std::lock_guard lock(mutex_);
            if (!free_.empty()) {
                std::unique_ptr<Kept> kept = std::move(free_.back());
                free_.pop_back();
                return kept;
            }
        }
        return make();
    }

    void give_back(std::unique_ptr<Kept> kept)
    {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(kept));
    }

private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Kept>> free_;
};

/// Interlaces one panel image.
template <class Sample> class Interlacer {
public:
    Interlacer(Image& panel, const ViewRaster& views, const PanelMapping& mapping, Blend blend)
        : samples_(std::get<std::vector<Sample>>(panel.samples)),
          views_(views),
          mapping_(mapping),
          blends_views_(blend.views == Neighbours::linear),
          blends_pixels_(blend.pixels == Neighbours::linear),
          is_separable_(mapping.is_separable()),
          views_up_(mapping.up.rows > 0 ? views.grid.rows : 1),
          views_across_(views.grid.count() / views_up_),
          first_sample_(mapping.left * channels),
          count_(std::max(0, mapping.width - mapping.left - mapping.right) * channels)
    {
        for (int view = 0; view < views.grid.count(); ++view)
            first_.push_back(views.first<Sample>(view));
        if (is_separable_)
            for (int i = 0; i < mapping.width * channels; ++i) {
                const Step x = step_among(std::uint32_t(views.width), mapping.x.row(0)[i],
                                          blends_pixels_);
                x_places_.push_back(index_of(x) * channels + std::uint32_t(i % channels));
                x_weights_.push_back(256 - weight_of(x) + (weight_of(x) << 16));
            }
    }

    /// Makes rows [first, end) of the panel.
    void make_rows(int first, int end)
    {
        std::unique_ptr<RowCache<Sample>> kept;
        if (views_up_ == 1 && RowCache<Sample>::can_hold(views_))
            kept = kept_.take([&] {
                return std::make_unique<RowCache<Sample>>(views_, is_separable_, blends_pixels_);
            });
        const int whole_row = mapping_.width * channels;
        for (int y = first; y < end; ++y) {
            Sample* const begin = samples_.data() + std::size_t(y) * whole_row;
            if (y < mapping_.top || y >= mapping_.height - mapping_.bottom) {
                std::fill_n(begin, whole_row, Sample(0));
                continue;
            }
            Sample* const samples = std::fill_n(begin, first_sample_, Sample(0));
            std::fill(samples + count_, begin + whole_row, Sample(0));
            const PanelRow row = row_of_panel(y);
            if (!kept || !make_of_kept_rows(samples, row, y, *kept))
                make_one_by_one(samples, row, y);
        }
        if (kept)
            kept_.give_back(std::move(kept));
    }

private:
    PanelRow row_of_panel(int y) const
    {
        const auto axis = [&](const PhaseTable& table, int parts) {
            return RowAxis{table.row(y).from(first_sample_), std::uint32_t(parts)};
        };
        return {count_,
                axis(mapping_.across, views_across_),
                axis(mapping_.x, views_.width),
                axis(mapping_.y, views_.height),
                x_places_.data() + (is_separable_ ? first_sample_ : 0),
                x_weights_.data() + (is_separable_ ? first_sample_ : 0),
                mapping_.has_unseen,
                is_separable_};
    }

    /// Makes a row from cached rows; returns false if it shows more picture rows than are cached.
    bool make_of_kept_rows(Sample* samples, const PanelRow& row, int y,
                           RowCache<Sample>& kept) const
    {
        const auto step = [&](std::uint32_t phase) {
            return step_among(row.y.parts, phase, blends_pixels_);
        };
        int first, last;
        if (is_separable_) {
            const Step both = step(row.y.phases[0]);
            first = last = int(index_of(both));
            kept.keep(both);
        } else {
            first = int(index_of(step(phase_of_high(mapping_.y_range[y][0]))));
            last = int(index_of(step(phase_of_high(mapping_.y_range[y][1]))));
            if (last - first >= int(rows_kept))
                return false;
            for (int k = first; k <= last; ++k)
                kept.keep(Step(k) << 8);
        }
        interlace_row(samples, row, kept.rows(first, last), {blends_views_, blends_pixels_});
        return true;
    }

    /// Makes a row directly from the views' pictures: for round lenses, and if cached rows do not
    /// suffice.
    void make_one_by_one(Sample* samples, const PanelRow& row, int y) const
    {
        for (int i = 0; i < row.count; ++i) {
            const std::uint32_t phase = row.across.phases[i];
            if (row.has_unseen && phase == PanelMapping::unseen) {
                samples[i] = 0;
                continue;
            }
            const Step up = views_up_ == 1
                                ? 0
                                : step_among(std::uint32_t(views_up_),
                                             mapping_.up.row(y)[first_sample_ + i], blends_views_);
            samples[i] = sample(step_among(row.across.parts, phase, blends_views_), up,
                                step_among(row.x.parts, row.x.phases[i], blends_pixels_),
                                step_among(row.y.parts, row.y.phases[i], blends_pixels_),
                                i % channels);
        }
    }

    Sample sample(Step across, Step up, Step x, Step y, int channel) const
    {
        const std::size_t place = index_of(y) * views_.row_step + index_of(x) * channels + channel;
        const std::size_t right = weight_of(x) ? channels : 0, // does not leave the picture
            below = weight_of(y) ? views_.row_step : 0;
        const auto pixel = [&](int view) {
            const Sample* at = first_[std::size_t(view)] + place;
            const auto column = [&](std::size_t side) { // 2^8 times the value
                const std::uint64_t sum = blend<std::uint64_t>(at[side], at[side + below],
                                                               weight_of(y));
                return is_separable_ ? (sum + 128) & ~std::uint64_t(255) : sum;
            };
            return blend(column(0), column(right), weight_of(x)); // 2^16 times the value
        };
        const auto line = [&](std::uint32_t row) { // 2^24 times the value
            const int view = int(row) * views_across_ + int(index_of(across));
            return blend(pixel(view), pixel(view + (weight_of(across) ? 1 : 0)), weight_of(across));
        };
        const std::uint32_t row = index_of(up);
        const std::uint64_t sum = blend(line(row), line(row + (weight_of(up) ? 1 : 0)),
                                        weight_of(up));
        return Sample((sum + (std::uint64_t(1) << 31)) >> 32);
    }

    std::vector<Sample>& samples_;
    const ViewRaster& views_;
    const PanelMapping& mapping_;
    const bool blends_views_, blends_pixels_;
    const bool is_separable_; ///< of the mapping
    const int views_up_, views_across_;
    const int first_sample_, count_; ///< the samples of a panel's row that show the picture
    std::vector<const Sample*> first_;                ///< of each view
    std::vector<std::uint32_t> x_places_, x_weights_; ///< as in PanelRow; for separable mappings
    ObjectPool<RowCache<Sample>> kept_;
};

template <class Sample>
void interlace_as(Image& panel, const ViewRaster& views, const PanelMapping& mapping, Blend blend,
                  int threads)
{
    Interlacer<Sample> interlacer(panel, views, mapping, blend);
    for_each_block(panel.height, threads,
                   [&](int first, int end) { interlacer.make_rows(first, end); });
}

} // namespace

void interlace(Image& panel, const ViewRaster& views, const PanelMapping& mapping, Blend blend,
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
