// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/replay.h"

#include "integral/base/constants.h"
#include "integral/frame/linear_writer.h"
#include "integral/optics/film_seen.h"
#include "integral/optics/lens_surface.h"
#include "integral/replay/fit_part.h"
#include "integral/sampling/lens_profile.h"
#include "integral/sampling/sample_points.h"

#include <algorithm>
#include <cmath>

namespace integral {

Eye centre_eye(const FrameMetadata& metadata) { return {0, 0, viewer_distance(metadata)}; }

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
    // A disc's points have a standard deviation of a quarter of its diameter along any direction.
    return count ? 4 * std::sqrt(squares / count) * radians_per_degree * sheet.thickness / sheet.ior
                 : 0;
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

/// Offsets of film points, mm.
struct SeenAside {
    std::array<double, FilmSeenRun::length> x, y;
};

/// The light that the eye sees at points of the sheet: linear, premultiplied.
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

    /// Calls visit(k, light) for the first `number` points of a run. `aside`: offsets from the film
    /// points that are seen.
    template <class Visit>
    void light(int number, FilmSeenRun& run, const SeenAside& aside, Visit visit) const
    {
        find_film_points(number, run);
        for (int k = 0; k < FilmSeenRun::length; ++k) {
            const Vec2 pixel = pixel_from_film(film_, Vec2{run.film_x[k], run.film_y[k]} +
                                                          Vec2{aside.x[k], aside.y[k]});
            run.film_x[k] = pixel.x;
            run.film_y[k] = pixel.y;
        }
        pixel_.use([&](auto read) {
            for (int k = 0; k < number; ++k) {
                const Vec2 pixel{run.film_x[k], run.film_y[k]};
                if (!(pixel.x >= 0 && pixel.x < film_.width && pixel.y >= 0 &&
                      pixel.y < film_.height))
                    visit(k, outside_);
                else if (film_.subpixels == Subpixels::none)
                    visit(k, read(int(pixel.x), int(pixel.y)));
                else
                    visit(k, subpixels_at(pixel, read));
            }
        });
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

    /// The film points of a run; NaN where none is seen.
    void find_film_points(int number, FilmSeenRun& run) const
    {
        if (projection_ || refracts_at_surface(optics_.model())) {
            for (int k = 0; k < number; ++k) {
                const Vec2 point{run.x[k], run.y[k]}, eye{run.eye_x[k], run.eye_y[k]};
                const auto film_point = projection_ ? film_point_projected(point, eye)
                                                    : film_point_seen(point, eye, distance_);
                run.film_x[k] = film_point ? film_point->x : NAN;
                run.film_y[k] = film_point ? film_point->y : NAN;
            }
            return;
        }
        film_points_seen(optics_, distance_, number, run);
        if (gap_parts_ != 0)
            for (int k = 0; k < number; ++k) {
                const Vec2 point{run.x[k], run.y[k]}, focus{run.film_x[k], run.film_y[k]};
                const Vec2 film = focus + gap_parts_ * (focus - point);
                run.film_x[k] = film.x;
                run.film_y[k] = film.y;
            }
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
    template <class Read> Colour subpixels_at(Vec2 pixel, Read read) const
    {
        const auto nearest = [&](int channel) {
            const PixelPlace at = pixel_of_nearest_subpixel(film_.subpixels, pixel, channel);
            return read(std::clamp(at.column, 0, film_.width - 1),
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

/// The points of a circle of radius 1 at equal angles.
const std::vector<Vec2>& circle_points()
{
    static const std::vector<Vec2> points = [] {
        constexpr int number = 4096;
        std::vector<Vec2> all;
        for (int k = 0; k < number; ++k) {
            const double angle = 2 * pi * k / number;
            all.push_back({std::cos(angle), std::sin(angle)});
        }
        return all;
    }();
    return points;
}

/// Points of a disc, spread evenly over the samples of a pixel and differently in each pixel.
class DiscPoints {
public:
    /// `steps`: increments of the two coordinates (0 to 1) from sample to sample. `seed` shifts one
    /// disc's points against another's.
    DiscPoints(Vec2 centre, double diameter, Vec2 steps, std::uint64_t seed)
        : centre_(centre),
          radius_(0.5 * diameter),
          steps_(steps),
          seed_(seed),
          circle_(circle_points())
    {
    }

    /// Where a pixel's points begin, 0 to 1.
    Vec2 start(int x, int y) const
    {
        if (radius_ == 0)
            return {0, 0};
        const std::uint64_t bits = random_bits(std::uint64_t(x) ^ seed_, std::uint64_t(y));
        return {double(bits >> 32) * 0x1p-32, double(bits & 0xffffffff) * 0x1p-32};
    }

    Vec2 point(Vec2 start, int sample) const
    {
        if (radius_ == 0)
            return centre_;
        const auto part = [](double v) { return v - double(int(v)); }; // v >= 0
        const double u = part(start.x + sample * steps_.x), v = part(start.y + sample * steps_.y);
        return centre_ +
               (radius_ * std::sqrt(u)) * circle_[std::size_t(v * double(circle_.size()))];
    }

private:
    Vec2 centre_;
    double radius_;
    Vec2 steps_;
    std::uint64_t seed_;
    const std::vector<Vec2>& circle_;
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
    const LinearWriter store(image);

    const int n = view.samples;
    const SamplePlaces places = sample_places(view, part_seen(view, *frame.metadata));
    const double weight = 1.0 / (double(n) * n);
    const int across = view.width * n;
    const auto row = [&](int y) {
        std::vector<std::array<double, 4>> sums(std::size_t(view.width));
        FilmSeenRun run{};
        SeenAside aside{};
        std::array<int, FilmSeenRun::length> pixels;
        for (int j = 0; j < n; ++j)
            for (int first = 0; first < across; first += FilmSeenRun::length) {
                const int number = std::min(FilmSeenRun::length, across - first);
                for (int k = 0; k < number;) {
                    const int x = (first + k) / n;
                    const Vec2 pupil_start = pupil.start(x, y), spot_start = spot.start(x, y);
                    for (int i = (first + k) % n; i < n && k < number; ++i, ++k) {
                        const Vec2 from = pupil.point(pupil_start, j * n + i),
                                   point = Vec2{places.across[std::size_t(first + k)],
                                                places.down[std::size_t(y * n + j)]} +
                                           sideways * (from - eye),
                                   beside = spot.point(spot_start, j * n + i);
                        run.x[k] = point.x;
                        run.y[k] = point.y;
                        run.eye_x[k] = from.x;
                        run.eye_y[k] = from.y;
                        aside.x[k] = beside.x;
                        aside.y[k] = beside.y;
                        pixels[k] = x;
                    }
                }
                seen.light(number, run, aside, [&](int k, Colour c) {
                    std::array<double, 4>& sum = sums[std::size_t(pixels[k])];
                    sum[0] += c.r;
                    sum[1] += c.g;
                    sum[2] += c.b;
                    sum[3] += c.a;
                });
            }
        for (int x = 0; x < view.width; ++x) {
            const auto& [r, g, b, a] = sums[std::size_t(x)];
            store(x, y,
                  {float(r * weight), float(g * weight), float(b * weight), float(a * weight)});
        }
    };
    if (!for_each_row(view.height, threads, row, progress))
        return std::nullopt;
    return image;
}

} // namespace integral
