// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/replay.h"

#include "integral/optics/lens_surface.h"
#include "integral/replay/fit_part.h"
#include "integral/sampling/lens_profile.h"
#include "integral/sampling/sample_points.h"

#include <algorithm>
#include <cmath>

namespace integral {

Eye centre_eye(const FrameMetadata& metadata)
{
    return {0, 0, viewer_distance(metadata)};
}

namespace {

/// Diameter, mm, of a uniform disc with the root mean square width of the spot on the film from
/// which a curved lens gathers the light of one direction (mean over the lens on the axis).
double aberration_spot(const LensSheet& sheet)
{
    constexpr int points = 64, places = 8;
    const double half = 0.5 * std::max(cell_extent(sheet).x, cell_extent(sheet).y);
    double squares = 0;
    int count = 0;
    for (int k = 0; k < places; ++k)
        if (const auto beam = full_beam_direction(sheet, half * (k + 0.5) / places, points)) {
            squares += beam->spread * beam->spread;
            ++count;
        }
    constexpr double degree = 3.14159265358979323846 / 180;
    // A disc's points have a standard deviation of a quarter of its diameter along any direction.
    return count ? 4 * std::sqrt(squares / count) * degree * sheet.thickness / sheet.ior : 0;
}

} // namespace

void set_as_seen(View& view, const FrameMetadata& metadata)
{
    constexpr double indoor_pupil = 4, printed_dot = 0.04; // mm
    if (view.pupil == 0)
        view.pupil = indoor_pupil;
    if (view.blur == 0)
        view.blur = std::hypot(aberration_spot(metadata.sheet),
                               metadata.film.subpixels == Subpixels::none ? printed_dot : 0);
}

void set_view_size(View& view, const Film& film, int longer)
{
    const Vec2 part = view.part.width > 0 ? Vec2{view.part.width, view.part.height} : size_of(film);
    const double scale = longer / std::max(part.x, part.y);
    view.width = std::max(1, int(std::lround(part.x * scale)));
    view.height = std::max(1, int(std::lround(part.y * scale)));
}

namespace {

/// The light that the eye sees at a point of the sheet: linear, premultiplied.
class SheetSeen {
public:
    SheetSeen(const Frame& frame, const View& view)
        : film_(frame.metadata->film),
          distance_(view.eye.distance),
          film_gap_(view.film_gap),
          gap_parts_(view.film_gap / frame.metadata->sheet.thickness),
          projection_(frame.metadata->projection),
          lenticular_(frame.metadata->sheet.arrangement == Arrangement::lenticular),
          optics_(frame.metadata->sheet, frame.metadata->aperture, view.model),
          surface_(frame.metadata->sheet),
          pixel_(frame.image),
          outside_{0, 0, 0, frame.image.channels == 4 ? 0.0f : 1.0f}
    {
    }

    /// The light at a point of the sheet, from a point `eye` of the pupil's plane. `aside`: offset
    /// from the film point that is seen.
    Colour at(Vec2 point, Vec2 eye, Vec2 aside) const
    {
        const auto film_point = projection_ ? film_point_projected(point, eye)
                                            : film_point_seen(point, eye, distance_);
        if (!film_point)
            return outside_;
        const Vec2 pixel = pixel_from_film(film_, *film_point + aside);
        if (!(pixel.x >= 0 && pixel.x < film_.width && pixel.y >= 0 && pixel.y < film_.height))
            return outside_;
        return film_.subpixels == Subpixels::none ? pixel_(int(pixel.x), int(pixel.y))
                                                  : subpixels_at(pixel);
    }

private:
    /// The film point that is seen at a point of the sheet's image, through the projection lens;
    /// nothing if the line of sight misses that lens.
    std::optional<Vec2> film_point_projected(Vec2 image, Vec2 eye) const
    {
        const Vec2 slope = (1 / distance_) * (image - eye);
        const ProjectedFrom from = projected_from(*projection_,
                                                  {{image.x, image.y, 0}, {slope.x, slope.y, 1}});
        // The aperture is the projection lens's. For a lenticular sheet it is a slit instead, and
        // the lens is large enough.
        if (!lenticular_ && !contains(optics_.aperture(), from.lens_point))
            return std::nullopt;
        return film_point_seen(from.sheet_point, from.lens_point, projection_->distance);
    }

    /// The film point that is seen at a point of the sheet from `eye`, `distance` in front of it.
    std::optional<Vec2> film_point_seen(Vec2 point, Vec2 eye, double distance) const
    {
        if (refracts_at_surface(optics_.model()))
            return surface_.film_point_seen(point, (1 / distance) * (point - eye), film_gap_);
        const Vec3 direction{eye.x - point.x, eye.y - point.y, -distance}; // to the eye
        // All light that this lens sends in that direction comes from one point of the focal plane.
        const Vec2 focus = optics_.film_point_seen(point, direction);
        // If the film is elsewhere, the point seen lies on the line from the lens's point to focus.
        return focus + gap_parts_ * (focus - point);
    }

    /// Each colour channel from its own nearest subpixel; their pixels' mean alpha.
    Colour subpixels_at(Vec2 pixel) const
    {
        const auto nearest = [&](int channel) {
            const PixelPlace at = pixel_of_nearest_subpixel(film_.subpixels, pixel, channel);
            return pixel_(std::clamp(at.column, 0, film_.width - 1),
                          std::clamp(at.row, 0, film_.height - 1));
        };
        const Colour red = nearest(0), green = nearest(1), blue = nearest(2);
        return {red.r, green.g, blue.b, (red.a + green.a + blue.a) / 3};
    }

    Film film_;
    double distance_;
    double film_gap_;  ///< the film's distance behind the lenses' focus, mm
    double gap_parts_; ///< the same in thicknesses
    std::optional<ProjectionLens> projection_;
    bool lenticular_;
    SheetOptics optics_;
    SheetSurface surface_; ///< for models that refract there
    LinearReader pixel_;
    Colour outside_;
};

/// Points of a disc, spread evenly over the samples of a pixel and differently in each pixel.
class DiscPoints {
public:
    /// `steps`: increments of the two coordinates (0 to 1) from sample to sample. `seed` shifts one
    /// disc's points against another's.
    DiscPoints(Vec2 centre, double diameter, Vec2 steps, std::uint64_t seed)
        : centre_(centre), radius_(0.5 * diameter), steps_(steps), seed_(seed)
    {
    }

    Vec2 point(int x, int y, int sample) const
    {
        if (radius_ == 0)
            return centre_;
        const std::uint64_t bits = random_bits(std::uint64_t(x) ^ seed_, std::uint64_t(y));
        const auto part = [](double v) { return v - std::floor(v); };
        const double u = part(double(bits >> 32) * 0x1p-32 + sample * steps_.x);
        const double v = part(double(bits & 0xffffffff) * 0x1p-32 + sample * steps_.y);
        constexpr double turn = 6.28318530717958647692;
        const double r = radius_ * std::sqrt(u);
        return centre_ + Vec2{r * std::cos(turn * v), r * std::sin(turn * v)};
    }

private:
    Vec2 centre_;
    double radius_;
    Vec2 steps_;
    std::uint64_t seed_;
};

constexpr Vec2 roberts_steps{0.75487766624669276, 0.56984029099805327}; // Roberts (2018)
constexpr Vec2 richtmyer_steps{
    0.41421356237309505, 0.73205080756887729}; // sqrt(2) and sqrt(3) modulo 1: unlike Roberts's

struct SamplePlaces {
    std::vector<double> across, down; ///< mm on the sheet
};

/// The coordinates of the columns and rows of a view's samples on the sheet, evenly spaced.
SamplePlaces sample_places(const View& view, const SheetPart& part)
{
    // The view's pixels, as a film of their own over its part of the sheet.
    const Film grid{view.width, view.height, {part.width / view.width, part.height / view.height}};
    const int n = view.samples;
    SamplePlaces places;
    for (int k = 0; k < view.width * n; ++k)
        places.across.push_back(part.middle.x + film_from_pixel(grid, {(k + 0.5) / n, 0}).x);
    for (int k = 0; k < view.height * n; ++k)
        places.down.push_back(part.middle.y + film_from_pixel(grid, {0, (k + 0.5) / n}).y);
    return places;
}

} // namespace

std::optional<Image> replay(const Frame& frame, const View& view, int threads,
                            const Progress& progress)
{
    const SheetSeen seen(frame, view);
    const Vec2 eye{view.eye.x, view.eye.y};
    const DiscPoints pupil(eye, view.pupil, roberts_steps, 0),
        spot({0, 0}, view.blur, richtmyer_steps, std::uint64_t(1) << 32);
    // From a pupil point offset by v from the pupil's centre, the point in focus is seen through
    // the sheet point offset by `sideways` v.
    const double sideways = view.focus / (view.eye.distance + view.focus);
    Image image = blank_like(frame.image, view.width, view.height);

    const int n = view.samples;
    const SamplePlaces places = sample_places(view, part_seen(view, *frame.metadata));
    const double weight = 1.0 / (double(n) * n);
    const auto row = [&](int y) {
        for (int x = 0; x < view.width; ++x) {
            double r = 0, g = 0, b = 0, a = 0;
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    const Vec2 point{places.across[x * n + i], places.down[y * n + j]};
                    const Vec2 from = pupil.point(x, y, j * n + i);
                    const Colour c = seen.at(point + sideways * (from - eye), from,
                                             spot.point(x, y, j * n + i));
                    r += c.r;
                    g += c.g;
                    b += c.b;
                    a += c.a;
                }
            store_linear(
                image, x, y,
                {float(r * weight), float(g * weight), float(b * weight), float(a * weight)});
        }
    };
    if (!for_each_row(view.height, threads, row, progress))
        return std::nullopt;
    return image;
}

} // namespace integral
