// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/frame_of_shares.h"

#include "integral/frame/eye_place.h"
#include "integral/replay/arrange.h"
#include "integral/replay/interpolate.h"
#include "integral/views/covered_means.h"

#include <cmath>
#include <stdexcept>

namespace integral {

ZoneAxis zone_axis(const LensSheet& sheet)
{
    return lenses_lie_across(sheet) ? ZoneAxis::upwards : ZoneAxis::sideways;
}

Image for_lenses(const Image& picture, const FittedPicture& fit, const FrameMetadata& geometry,
                 int threads)
{
    const LensSheet& sheet = geometry.sheet;
    const Film& film = geometry.film;
    const Vec2 size = size_of(film);
    Vec2 step{sheet.pitch / 2, sheet.pitch / 2};
    if (sheet.arrangement == Arrangement::lenticular)
        (lenses_lie_across(sheet) ? step.x : step.y) = lenses_lie_across(sheet)
                                                           ? film.pixel_pitch.x
                                                           : film.pixel_pitch.y;
    return covered_means(picture, pixels_of_step(picture.width, fit.size.x * size.x, step.x),
                         pixels_of_step(picture.height, fit.size.y * size.y, step.y), threads);
}

struct FrameOfShares::State {
    State(const std::vector<SharedPicture>& given, const std::vector<int>& given_order,
          const FrameMetadata& geometry, const ZoneShares& given_shares, ZoneAxis given_axis)
        : film(geometry.film),
          eyes{viewing_zone(geometry, geometry.aperture.distance), geometry.aperture.distance},
          optics(geometry.sheet, geometry.aperture),
          pictures(given),
          order(given_order),
          shares(given_shares),
          axis(given_axis)
    {
        for (const SharedPicture& picture : pictures) {
            const Image& image = picture.image;
            if (picture.is_frame && (image.width != film.width || image.height != film.height))
                throw std::invalid_argument("a frame has another size than the film");
            light.emplace_back(image);
            windows.push_back(pixels_on(film, picture.fit, image.width, image.height));
        }
    }

    /// The light of a flat picture at a place on the sheet, or of a frame's pixel (x, y).
    Colour shown(int picture, Vec2 place, int x, int y) const
    {
        if (pictures[picture].is_frame)
            return light[picture](x, y);
        const Vec2 pixel = pixel_from_film(film, place);
        if (pictures[picture].fit.is_in_bar({pixel.x / film.width, pixel.y / film.height}))
            return Colour{0, 0, 0, 1};
        const Film& window = windows[picture];
        const Vec2 at = pixel_from_film(window, place);
        Colour c = between(at.x - 0.5, at.y - 0.5, window.width, window.height,
                           [&](int i, int j) { return light[picture](i, j); });
        c.a = 1; // a flat picture stands on black
        return c;
    }

    /// The light of the ray through a film point, which lies in film pixel (x, y).
    Colour at(Vec2 film_point, int x, int y) const
    {
        const auto seen = eye_place(optics, eyes, film_point);
        if (!seen)
            return Colour{0, 0, 0, 0};
        const PictureMix mix = shares.at(axis == ZoneAxis::upwards ? seen->eye.y : seen->eye.x);
        const Colour first = shown(order[mix.first], seen->place, x, y);
        if (!(mix.part > 0) || order[mix.first] == order[mix.second])
            return first;
        Colour sum{0, 0, 0, 0};
        add(sum, float(1 - mix.part), first);
        add(sum, float(mix.part), shown(order[mix.second], seen->place, x, y));
        return sum;
    }

    Film film;
    EyeGrid eyes;
    SheetOptics optics;
    const std::vector<SharedPicture>& pictures;
    std::vector<int> order;
    ZoneShares shares;
    ZoneAxis axis;
    std::vector<LinearReader> light;
    std::vector<Film> windows; ///< for each flat picture, its pixels laid out over the sheet
};

FrameOfShares::FrameOfShares(const std::vector<SharedPicture>& pictures,
                             const std::vector<int>& order, const FrameMetadata& geometry,
                             const ZoneShares& shares, ZoneAxis axis)
    : state_(std::make_unique<State>(pictures, order, geometry, shares, axis))
{
}
FrameOfShares::~FrameOfShares() = default;

bool FrameOfShares::draw(int first, Image& band, int threads, const Progress& progress) const
{
    const State& s = *state_;
    return draw_film(s.film, first, band, threads, progress,
                     [&](Vec2 film_point, int x, int y) { return s.at(film_point, x, y); });
}

} // namespace integral
