// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/zone_view.h"

#include "integral/replay/arrange.h"
#include "integral/views/deghost.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

double& along(Vec2& v, ZoneAxis axis) { return axis == ZoneAxis::upwards ? v.y : v.x; }

/// The film's middle part: three lenses long, across the zone's axis.
Film strip_of(const FrameMetadata& geometry, ZoneAxis axis)
{
    Film film = geometry.film;
    const double length = 3 * geometry.sheet.pitch;
    const auto cut = [&](int& pixels, double pitch) {
        const int most = std::max(1, int(std::ceil(length / pitch)));
        if (pixels > most)
            pixels = most + (pixels - most) % 2; // removes an even number: the pixels keep their
                                                 // places
    };
    axis == ZoneAxis::upwards ? cut(film.width, film.pixel_pitch.x)
                              : cut(film.height, film.pixel_pitch.y);
    return film;
}

/// A strip in which up to three pictures, from `first` on, are red, green and blue, and the others
/// black. The colours that an eye sees are the pictures' shares.
class Strip {
public:
    Strip(const FrameMetadata& geometry, const ZoneShares& shares, const std::vector<int>& order,
          int count, ZoneAxis axis, double contrast, int first, int threads)
        : contrast_(contrast), threads_(threads)
    {
        std::vector<SharedPicture> labels;
        for (int k = 0; k < count; ++k) {
            SharedPicture label;
            label.image = make_image<float>(1, 1, 3, Encoding{Encoding::Kind::linear});
            const auto lit = [&](int channel) { return k == first + channel ? 1.0f : 0.0f; };
            store_pixel(label.image, 0, 0, {lit(0), lit(1), lit(2), 1});
            labels.push_back(std::move(label));
        }
        FrameMetadata part = geometry;
        part.film = strip_of(geometry, axis);
        part.film.subpixels = Subpixels::none;
        part.encoding = Encoding{Encoding::Kind::linear};
        frame_.image = make_image<float>(part.film.width, part.film.height, 3, part.encoding);
        FrameOfShares(labels, order, part, shares, axis).draw(0, frame_.image, threads, {});
        set_metadata(frame_, part);
        if (contrast > 0)
            Deghosting(part, contrast, axis).apply(frame_.image, threads);
        const bool is_wide = part.film.width > part.film.height;
        view_.width = std::min(part.film.width, is_wide ? 200 : 4);
        view_.height = std::min(part.film.height, is_wide ? 4 : 200);
        set_as_seen(view_, part);
    }

    /// The mean light that an eye sees, without what Deghosting adds where there is none.
    Colour seen_from(Eye eye) const
    {
        View view = view_;
        view.eye = eye;
        const Image picture = *replay(frame_, view, threads_);
        Colour sum{0, 0, 0, 0};
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                const Colour c = stored_pixel(picture, x, y);
                sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b, 0};
            }
        const float pixels = float(picture.width) * picture.height;
        const auto own = [&](float light) {
            return std::max(0.0f, light / pixels - float(contrast_ / 2));
        };
        return {own(sum.r), own(sum.g), own(sum.b), 0};
    }

private:
    Frame frame_;
    View view_; ///< without its eye
    double contrast_;
    int threads_;
};

/// The greatest share of other pictures at eyes that should see one alone.
double greatest_other(const std::vector<EyeShares>& eyes)
{
    double greatest = 0;
    for (const EyeShares& eye : eyes)
        if (eye.picture)
            greatest = std::max(greatest, 1 - eye.shares[*eye.picture]);
    return greatest;
}

/// As ghost_in_zone, along either axis: 1.88 standard deviations of the place in the zone whose
/// picture an eye sees, taken as normal. Pupil and blur spot are discs; pixels lie differently
/// behind each lens.
double blur_in_zone(const FrameMetadata& geometry, ZoneAxis axis)
{
    View view;
    view.eye = centre_eye(geometry);
    set_as_seen(view, geometry);
    Vec2 cell = cell_extent(geometry.sheet), pixel = geometry.film.pixel_pitch,
         zone = viewing_zone(geometry, geometry.aperture.distance);
    const double scale = along(zone, axis) / along(cell, axis);
    return 1.88 * std::hypot(view.blur * scale / 4, view.pupil / 4,
                             along(pixel, axis) * scale / std::sqrt(12));
}

} // namespace

std::optional<double> ghost_in_zone(const FrameMetadata& geometry)
{
    if (geometry.projection)
        return std::nullopt;
    return blur_in_zone(geometry, zone_axis(geometry.sheet));
}

ZoneView zone_view(const FrameMetadata& geometry, const ZoneShares& shares,
                   const std::vector<int>& order, int count, ZoneAxis axis, double contrast,
                   int threads)
{
    ZoneView view;
    view.axis = axis;
    view.distance = geometry.aperture.distance;
    Vec2 zone = viewing_zone(geometry, view.distance);
    view.width = along(zone, axis);
    view.blur = blur_in_zone(geometry, axis);
    const auto mm = [&](double part) { return (part - 0.5) * view.width; };
    for (int k = 0; k < shares.count(); ++k) {
        ShareView part;
        part.picture = order[k];
        part.part = {mm(shares.border(k)), mm(shares.border(k + 1))};
        const double from = part.part.from + shares.half_transition(k) * view.width + view.blur,
                     to = part.part.to - shares.half_transition(k + 1) * view.width - view.blur;
        if (from <= to)
            part.alone = ZonePart{from, to};
        view.parts.push_back(part);
    }
    for (int k = 0; k < eyes_across_zone; ++k) {
        EyeShares eye;
        eye.place = mm((k + 0.5) / eyes_across_zone);
        for (const ShareView& part : view.parts)
            if (part.alone && eye.place >= part.alone->from && eye.place <= part.alone->to)
                eye.picture = part.picture;
        view.eyes.push_back(eye);
    }
    const auto look = [&](double lost) {
        for (EyeShares& eye : view.eyes)
            eye.shares.clear();
        for (int first = 0; first < count; first += 3) {
            const Strip strip(geometry, shares, order, count, axis, lost, first, threads);
            for (EyeShares& eye : view.eyes) {
                Vec2 at{0, 0};
                along(at, axis) = eye.place;
                const Colour seen = strip.seen_from({at.x, at.y, view.distance});
                const double parts[3] = {seen.r, seen.g, seen.b};
                for (int channel = 0; channel < 3 && first + channel < count; ++channel)
                    eye.shares.push_back(parts[channel]);
            }
        }
        for (EyeShares& eye : view.eyes) {
            double sum = 0;
            for (const double share : eye.shares)
                sum += share;
            for (double& share : eye.shares)
                share = sum > 0 ? share / sum : 0;
        }
        return greatest_other(view.eyes);
    };
    view.other_with_ghosts = view.greatest_other = look(0);
    view.lost_contrast = contrast;
    if (contrast > 0)
        view.greatest_other = look(contrast);
    return view;
}

} // namespace integral
