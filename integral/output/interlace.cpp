// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/output/interlace.h"

#include "integral/lightfield/eye_place.h"
#include "integral/output/interlace_rays.h"
#include "integral/output/interlace_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>

namespace integral {
namespace {

constexpr double whole_range = 4294967296.0; // 2^32
constexpr int channels = 3;
constexpr int rows_a_block = 32;

/// Bytes from view to view where rows of all views lie close together: an odd number of the cache's
/// lines, so that what all of them show at one place does not meet in a few of its sets.
std::size_t spread(std::size_t bytes) { return ((bytes + 63) / 64 | 1) * 64; }

/// A part of a range, modulo 1.
std::uint32_t phase_of(double part)
{
    return std::uint32_t(std::uint64_t(std::llround((part - std::floor(part)) * whole_range)));
}

/// The middle of a pixel in a picture that is `count` of them wide.
std::uint32_t middle_phase(int pixel, int count, bool flip)
{
    return phase_of((flip ? count - pixel - 0.5 : pixel + 0.5) / count);
}

/// The phase of the middle of one of RayMapping's parts.
std::uint32_t phase_of_part(std::uint16_t part) { return part * 65536u + 32768u; }

Step step_of(Neighbours neighbours, std::uint32_t phase, int count)
{
    return neighbours == Neighbours::linear ? linear_step(phase, std::uint32_t(count))
                                            : nearest_step(phase, std::uint32_t(count));
}

void check_image(const Image& image)
{
    if (image.channels != channels || sample_bits(image) > 16)
        throw std::invalid_argument("views of three channels of 8 or 16 bits are expected");
}

/// Work on blocks of rows, so that what is made for one row serves the next.
void for_each_block(int height, int threads, const std::function<void(int first, int end)>& work)
{
    for_each_row((height + rows_a_block - 1) / rows_a_block, threads, [&](int block) {
        work(block * rows_a_block, std::min(height, (block + 1) * rows_a_block));
    });
}

void check_panel(const Image& panel, const ViewPictures& views, int width, int height)
{
    if (panel.width != width || panel.height != height || panel.channels != channels ||
        panel.samples.index() != views.form->samples.index())
        throw std::invalid_argument(
            "the panel's image is not of the views' form and the panel's size");
}

} // namespace

PublishedMapping published_mapping(const LookingGlassCalibration& calibration)
{
    PublishedMapping mapping;
    mapping.width = calibration.width;
    mapping.height = calibration.height;
    mapping.flip_x = calibration.flip_x;
    mapping.flip_y = calibration.flip_y;
    const int kinds = int(mapping.of_columns.size());
    for (int kind = 0; kind < kinds; ++kind)
        for (int column = 0; column < mapping.width; ++column)
            for (int channel = 0; channel < channels; ++channel)
                mapping.of_columns[kind].push_back(
                    phase_of(view_of_subpixel(calibration, column, kind, channel)));
    for (int row = 0; row < mapping.height; ++row)
        mapping.of_rows.push_back(phase_of(view_of_subpixel(calibration, 0, row, 0) -
                                           view_of_subpixel(calibration, 0, row % kinds, 0)));
    return mapping;
}

std::optional<RayMapping> ray_mapping(const FrameMetadata& geometry, EyeGrid eyes, int threads,
                                      const Progress& progress)
{
    const Film& film = geometry.film;
    const SheetOptics optics(geometry.sheet, geometry.aperture);
    RayMapping mapping;
    mapping.width = film.width;
    mapping.height = film.height;
    mapping.round_lenses = geometry.sheet.arrangement != Arrangement::lenticular;
    const std::size_t count = std::size_t(film.width) * film.height * channels;
    mapping.across.resize(count);
    mapping.x.resize(count);
    mapping.y.resize(count);
    mapping.y_of_rows.resize(film.height);
    if (mapping.round_lenses)
        mapping.up.resize(count);
    const auto part = [](double at) {
        return std::uint16_t(
            std::clamp(std::floor(at * RayMapping::parts), 0.0, double(RayMapping::last)));
    };
    const auto row = [&](int y) {
        std::uint16_t least = RayMapping::last, greatest = 0;
        for (int x = 0; x < film.width; ++x)
            for (int channel = 0; channel < channels; ++channel) {
                const std::size_t i = (std::size_t(y) * film.width + x) * channels + channel;
                const auto seen = eye_place(
                    optics, eyes,
                    film_from_pixel(film, subpixel_centre(film.subpixels, x, y, channel)));
                mapping.across[i] = seen ? part(seen->eye.x) : std::uint16_t(RayMapping::empty);
                if (!seen)
                    continue;
                const Vec2 at = pixel_from_film(film, seen->place);
                mapping.x[i] = part(at.x / film.width);
                mapping.y[i] = part(at.y / film.height);
                least = std::min(least, mapping.y[i]);
                greatest = std::max(greatest, mapping.y[i]);
                if (mapping.round_lenses)
                    mapping.up[i] = part(seen->eye.y);
            }
        mapping.y_of_rows[y] = {std::min(least, greatest), greatest};
    };
    if (!for_each_row(film.height, threads, row, progress))
        return std::nullopt;
    return mapping;
}

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

template <class Sample>
void interlace_as(Image& panel, const ViewPictures& views, const PublishedMapping& mapping,
                  Blend blend, int threads, bool portable)
{
    const int count = views.grid.count(), samples = panel.width * channels;
    const std::size_t view_samples = std::size_t(views.width) * channels,
                      view_step = spread(view_samples * sizeof(Sample)) / sizeof(Sample);
    std::vector<std::uint32_t> places(samples), weights(samples);
    for (int i = 0; i < samples; ++i) {
        const Step step = step_of(
            blend.pixels, middle_phase(i / channels, panel.width, mapping.flip_x), views.width);
        places[i] = step.index * channels + i % channels;
        weights[i] = step.weight << 16 | (256 - step.weight);
    }
    std::vector<Sample>& image = std::get<std::vector<Sample>>(panel.samples);
    for_each_block(panel.height, threads, [&](int first, int end) {
        // A row of each view, one after the other: what a row of the panel is made of lies close
        // together. Weights of 0 may read one view farther.
        std::vector<Sample> rows((count + 1) * view_step + 2 * channels);
        Step made{0, 0};
        bool any = false;
        for (int y = first; y < end; ++y) {
            const Step step = step_of(blend.pixels, middle_phase(y, panel.height, mapping.flip_y),
                                      views.height);
            if (!any || step.index != made.index || step.weight != made.weight)
                for (int view = 0; view < count; ++view) {
                    const Sample* above = views.first<Sample>(view) + step.index * views.row_step;
                    Sample* row = rows.data() + view * view_step;
                    if (step.weight == 0)
                        std::memcpy(row, above, view_samples * sizeof(Sample));
                    else
                        (portable ? blend_rows_portably<Sample>
                                  : blend_rows<Sample>)(row, above, above + views.row_step,
                                                        view_samples, step.weight);
                }
            any = true;
            made = step;
            const InterlacedRow<Sample> row{
                image.data() + std::size_t(y) * samples,
                samples,
                mapping.of_columns[y % mapping.of_columns.size()].data(),
                mapping.of_rows[y],
                rows.data(),
                std::uint32_t(view_step),
                std::uint32_t(count),
                places.data(),
                weights.data()};
            (portable ? interlace_row_portably<Sample>
                      : interlace_row<Sample>)(row, blend.views == Neighbours::linear,
                                               blend.pixels == Neighbours::linear);
        }
    });
}

/// The rows of the views that rows of a panel show through lenticular lenses, close together.
class RayLines {
public:
    RayLines(const ViewPictures& views, const RayMapping& mapping, Blend blend)
        : views_(views),
          mapping_(mapping),
          blend_(blend),
          line_step_(std::size_t(views.grid.count()) * view_bytes()),
          lines_(lines_kept * line_step_ + view_bytes() + 8)
    {
        made_.fill(-1);
    }

    /// The first samples of the panel's row y, as many as are returned.
    int make(std::uint8_t* samples, int y)
    {
        const auto index = [&](std::uint16_t part) {
            return int(step_of(blend_.pixels, phase_of_part(part), views_.height).index);
        };
        const int first = index(mapping_.y_of_rows[y][0]), last = index(mapping_.y_of_rows[y][1]);
        if (last - first >= int(lines_kept))
            return 0;
        for (int k = first; k <= last; ++k)
            keep(k);
        const int count = mapping_.width * channels;
        const std::size_t i = std::size_t(y) * count;
        return interlace_ray_row(
            {samples, count, &mapping_.across[i], &mapping_.x[i], &mapping_.y[i],
             std::uint32_t(views_.grid.count()), std::uint32_t(views_.width),
             std::uint32_t(views_.height), std::uint32_t(first), std::uint32_t(last), lines_.data(),
             view_bytes(), line_step_},
            blend_.views == Neighbours::linear, blend_.pixels == Neighbours::linear);
    }

private:
    std::size_t view_bytes() const
    {
        return spread(std::size_t(views_.width) * channels *
                      (blend_.pixels == Neighbours::linear ? 2 : 1));
    }

    void keep(int k)
    {
        if (made_[k % lines_kept] == k)
            return;
        made_[k % lines_kept] = k;
        const std::size_t below = k + 1 < views_.height ? views_.row_step : 0;
        for (int view = 0; view < views_.grid.count(); ++view) {
            const std::uint8_t* row = views_.first<std::uint8_t>(view) + k * views_.row_step;
            std::uint8_t* to = lines_.data() + k % lines_kept * line_step_ + view * view_bytes();
            if (blend_.pixels == Neighbours::linear)
                make_ray_line(to, row, row + below, std::size_t(views_.width) * channels);
            else
                std::memcpy(to, row, std::size_t(views_.width) * channels);
        }
    }

    const ViewPictures& views_;
    const RayMapping& mapping_;
    const Blend blend_;
    const std::size_t line_step_;
    std::vector<std::uint8_t> lines_;
    std::array<int, lines_kept> made_;
};

template <class Sample>
void interlace_as(Image& panel, const ViewPictures& views, const RayMapping& mapping, Blend blend,
                  int threads, bool portable)
{
    const ViewGrid grid = mapping.round_lenses ? views.grid : ViewGrid{views.grid.count(), 1};
    std::vector<const Sample*> begin;
    for (int view = 0; view < grid.count(); ++view)
        begin.push_back(views.first<Sample>(view));
    std::vector<Sample>& image = std::get<std::vector<Sample>>(panel.samples);
    const std::size_t samples = std::size_t(panel.width) * channels;
    const auto make = [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            if (mapping.across[i] == RayMapping::empty) {
                image[i] = 0;
                continue;
            }
            const Step x = step_of(blend.pixels, phase_of_part(mapping.x[i]), views.width),
                       y = step_of(blend.pixels, phase_of_part(mapping.y[i]), views.height);
            const std::size_t place = y.index * views.row_step + x.index * channels + i % channels;
            const std::size_t right = x.weight ? channels : 0,
                              below = y.weight ? views.row_step : 0; // no farther than the picture
            const auto pixel = [&](const Sample* view) {             // 2^16 times the value
                const Sample* at = view + place;
                return (at[0] * (256 - x.weight) + at[right] * x.weight) *
                           std::uint64_t(256 - y.weight) +
                       (at[below] * (256 - x.weight) + at[below + right] * x.weight) *
                           std::uint64_t(y.weight);
            };
            const Step across = step_of(blend.views, phase_of_part(mapping.across[i]),
                                        grid.columns);
            const std::uint32_t next = across.weight ? 1 : 0;
            const auto line = [&](std::uint32_t row) { // 2^24 times the value
                const Sample* const* view = begin.data() + row * grid.columns + across.index;
                const std::uint64_t left = pixel(view[0]);
                return next ? left * (256 - across.weight) + pixel(view[1]) * across.weight
                            : left * 256;
            };
            const Step up = mapping.round_lenses
                                ? step_of(blend.views, phase_of_part(mapping.up[i]), grid.rows)
                                : Step{0, 0};
            std::uint64_t sum = line(up.index) * (256 - up.weight);
            if (up.weight)
                sum += line(up.index + 1) * up.weight;
            image[i] = Sample((sum + (std::uint64_t(1) << 31)) >> 32);
        }
    };
    for_each_block(panel.height, threads, [&](int first, int end) {
        if constexpr (sizeof(Sample) == 1)
            if (!portable && !mapping.round_lenses &&
                has_ray_loop(grid.count(), views.width, views.height,
                             spread(std::size_t(views.width) * channels * 2))) {
                RayLines lines(views, mapping, blend);
                for (int y = first; y < end; ++y)
                    make(y * samples + lines.make(image.data() + y * samples, y),
                         (y + 1) * samples);
                return;
            }
        make(first * samples, end * samples);
    });
}

} // namespace

void interlace(Image& panel, const ViewPictures& views, const PublishedMapping& mapping,
               Blend blend, int threads, bool portable)
{
    check_panel(panel, views, mapping.width, mapping.height);
    sample_bits(panel) == 8
        ? interlace_as<std::uint8_t>(panel, views, mapping, blend, threads, portable)
        : interlace_as<std::uint16_t>(panel, views, mapping, blend, threads, portable);
}

void interlace(Image& panel, const ViewPictures& views, const RayMapping& mapping, Blend blend,
               int threads, bool portable)
{
    check_panel(panel, views, mapping.width, mapping.height);
    sample_bits(panel) == 8
        ? interlace_as<std::uint8_t>(panel, views, mapping, blend, threads, portable)
        : interlace_as<std::uint16_t>(panel, views, mapping, blend, threads, portable);
}

} // namespace integral
