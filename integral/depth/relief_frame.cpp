// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/relief_frame.h"

#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"
#include "integral/io/image_file.h"
#include "integral/optics/beam.h"
#include "integral/replay/interpolate.h"
#include "integral/sampling/sample_points.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// The light of film points.
class FilmLight {
public:
    FilmLight(const Relief& relief, const FrameMetadata& geometry, const FittedPicture& picture)
        : relief_(relief),
          film_(geometry.film),
          optics_(geometry.sheet, geometry.aperture),
          picture_(picture)
    {
        const auto parts = [&](double length) { // samples across that length
            return std::clamp(int(std::ceil(length / relief.pixel() - 0.25)), 1, 4);
        };
        across_ = parts(optics_.lattice().pitch());
        lenticular_ = geometry.sheet.arrangement == Arrangement::lenticular;
        pixel_along_ = lenses_lie_across(geometry.sheet) ? Vec2{film_.pixel_pitch.x, 0}
                                                         : Vec2{0, film_.pixel_pitch.y};
        along_ = lenticular_ ? parts(length(pixel_along_)) : across_;
    }

    /// From one line of sight to the next in the image plane, across and down, mm.
    Vec2 spacing() const
    {
        const double pitch = optics_.lattice().pitch() / across_;
        if (!lenticular_)
            return {pitch, pitch};
        const double along = length(pixel_along_) / along_;
        return pixel_along_.x > 0 ? Vec2{along, pitch} : Vec2{pitch, along};
    }

    Colour pixel(int x, int y, ReliefFigures& figures) const
    {
        return each_channel(film_.subpixels, [&](int channel) {
            return at(film_from_pixel(film_, subpixel_centre(film_.subpixels, x, y, channel)),
                      figures);
        });
    }

private:
    Colour at(Vec2 point, ReliefFigures& figures) const
    {
        const auto ray = optics_.map(point, LensMapping::automatic).ray;
        if (!ray)
            return {0, 0, 0, 0};
        MeanSeen mean(across_ * along_, figures);
        for (int k = 0; k < across_ * along_; ++k) {
            const auto line = line_of(
                *ray, {(k % across_ + 0.5) / across_, (k / across_ + 0.5) / along_});
            const Vec2 pixel = pixel_from_film(film_, line.place);
            if (picture_.is_in_bar({pixel.x / film_.width, pixel.y / film_.height}))
                continue;
            mean.add(relief_.along(line));
        }
        return mean.light();
    }

    /// The line along a film point's beam through the place `unit` of its lens's cell (lenticular:
    /// across the lens, and along the lens within the film pixel).
    ReliefLine line_of(const LensRay& ray, Vec2 unit) const
    {
        const Vec2 cell{unit.x, lenticular_ ? 0.5 : unit.y};
        Vec2 place = ray.pole + cell_point(optics_.lattice(), cell).offset;
        if (lenticular_)
            place = place + (unit.y - 0.5) * pixel_along_;
        const double along = -relief_.distance() / ray.direction.z;
        return {place, place + along * Vec2{ray.direction.x, ray.direction.y}};
    }

    const Relief& relief_;
    Film film_;
    SheetOptics optics_;
    FittedPicture picture_; ///< the relief on the film
    bool lenticular_ = false;
    Vec2 pixel_along_; ///< the film's pixel along lenticular lenses
    int across_ = 1, along_ = 1;
};

/// A sample's place in a disc of that radius. The samples of a pixel are spread evenly over the
/// disc; each pixel turns them by another angle.
Vec2 disc_point(double radius, int x, int y, int sample, int samples)
{
    constexpr double golden_angle = 2.39996322972865332, turn = 6.28318530717958647692;
    const double first = turn * 0x1p-32 *
                         double(random_bits(std::uint64_t(x), std::uint64_t(y)) >> 32);
    const double r = radius * std::sqrt((sample + 0.5) / samples), angle = sample * golden_angle;
    return {r * std::cos(first + angle), r * std::sin(first + angle)};
}

} // namespace

void ReliefTally::add(const ReliefFigures& row)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    all_.lines += row.lines;
    all_.holes += row.holes;
}

std::string holes_text(const ReliefFigures& figures)
{
    return with_decimals(100 * figures.holes / std::max(1.0, figures.lines), 2) +
           "% of the lines of sight are invented: they end where no picture has seen anything, and "
           "show what is beside, farther off";
}

ReliefFigures write_relief_frame(const std::string& path, Relief relief,
                                 const FrameMetadata& geometry, const Image& form, Fit fit,
                                 int threads, const Progress& progress)
{
    const Vec2 film = size_of(geometry.film);
    const FittedPicture picture = fitted(relief.size().x / relief.size().y, shape_of(geometry.film),
                                         fit);
    relief.scale_to(film, fit);
    const FilmLight light(relief, geometry, picture);
    relief.thin(light.spacing());
    FrameMetadata metadata = geometry;
    metadata.encoding = form.encoding;
    metadata.quilt.reset();
    Image whole = form_of(form);
    whole.width = geometry.film.width;
    whole.height = geometry.film.height;
    PictureWriter writer = PictureWriter::of_frame(path, whole, metadata);
    const int rows = rows_of_a_band(whole), bands = (whole.height + rows - 1) / rows;
    ReliefTally tally;
    for (int k = 0; k < bands; ++k) {
        const int first = k * rows, count = std::min(rows, whole.height - first);
        Image band = blank_like(whole, whole.width, count);
        const auto row = [&](int y) {
            ReliefFigures figures;
            for (int x = 0; x < whole.width; ++x)
                store_linear(band, x, y, light.pixel(x, first + y, figures));
            tally.add(figures);
        };
        if (!for_each_row(count, threads, row, piece_of(progress, k, bands)))
            throw Interrupted();
        writer.write(band);
    }
    writer.finish();
    return tally.all();
}

RefocusedPicture refocused(const Relief& relief, const Refocus& lens, const Image& form,
                           int threads, const Progress& progress)
{
    constexpr int samples = 64;
    RefocusedPicture picture{blank_like(form, lens.width, lens.height), {}};
    const Film raster{
        lens.width, lens.height, {relief.size().x / lens.width, relief.size().y / lens.height}};
    // Lines from the lens to the point in focus: offset in the image plane / offset on the lens.
    const double sideways = lens.focus / (relief.distance() + lens.focus);
    ReliefTally tally;
    const auto row = [&](int y) {
        ReliefFigures figures;
        for (int x = 0; x < lens.width; ++x) {
            MeanSeen mean(samples, figures);
            for (int k = 0; k < samples; ++k) {
                const Vec2 eye = disc_point(0.5 * lens.pupil, x, y, k, samples);
                const double part = (k + 0.5) / samples;
                const Vec2 inside{x + part, y + std::fmod(0.5 + k * 0.61803398874989, 1.0)};
                const Vec2 place = film_from_pixel(raster, inside) + sideways * eye;
                mean.add(relief.along({place, eye}));
            }
            store_linear(picture.image, x, y, mean.light());
        }
        tally.add(figures);
    };
    if (!for_each_row(lens.height, threads, row, progress))
        throw Interrupted();
    picture.figures = tally.all();
    return picture;
}

} // namespace integral
