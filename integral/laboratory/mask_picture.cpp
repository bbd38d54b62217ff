// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/laboratory/mask_picture.h"

#include "integral/base/constants.h"
#include "integral/base/number_text.h"

#include <cmath>
#include <stdexcept>

namespace integral {

MaskGrey::MaskGrey(const MaskRequest& request)
    : request_(request),
      relief_(request.sheet, request.shape),
      response_(request.response ? *request.response : Response::linear(relief_.deepest())),
      pole_(Lattice(request.sheet).pole({0, 0}))
{
    const double lowest = request.from_depth + relief_.deepest();
    if (request.from_depth < response_.least_depth() || lowest > response_.deepest() * (1 + 1e-9))
        throw std::invalid_argument("the lenses take depths from " +
                                    with_digits(request.from_depth, 4) + " to " +
                                    with_digits(lowest, 4) + " mm, the response gives " +
                                    with_digits(response_.least_depth(), 4) + " to " +
                                    with_digits(response_.deepest(), 4) + " mm");
}

double MaskGrey::grey_of(double depth) const
{
    if (request_.kind == MaskKind::relief)
        return 1 - depth / relief_.deepest();
    return response_.grey(request_.from_depth + depth);
}

double MaskGrey::at(Vec2 point) const
{
    double grey = grey_of(relief_.depth(point));
    if (request_.kind == MaskKind::spinning) {
        // At a distance r, the part of the circle that is white equals the grey.
        const Vec2 from_pole = point - pole_;
        const double r = length(from_pole);
        const double turn = 0.5 + std::atan2(from_pole.y, from_pole.x) / (2 * pi);
        grey = r <= relief_.reach() && turn < grey_of(relief_.depth_at(r)) ? 1 : 0;
    }
    return request_.negative ? 1 - grey : grey;
}

std::optional<Image> mask_picture(const MaskRequest& request, int threads, const Progress& progress)
{
    const MaskGrey grey(request);
    const Film& film = request.film;
    Image image = blank_like(form_of(request.bits, film.width, film.height, 1, Encoding{}),
                             film.width, film.height);
    const bool done = for_each_row(
        film.height, threads,
        [&](int y) {
            for (int x = 0; x < film.width; ++x) {
                const float g = float(grey.at(film_from_pixel(film, {x + 0.5, y + 0.5})));
                store_pixel(image, x, y, {g, g, g, 1});
            }
        },
        progress);
    if (!done)
        return std::nullopt;
    return image;
}

void show_one_lens(MaskRequest& request)
{
    const Lattice lattice(request.sheet);
    Film& film = request.film;
    film.pixel_pitch.x = request.sheet.pitch / film.width;
    film.pixel_pitch.y = (request.sheet.arrangement == Arrangement::hexagonal
                              ? lattice.row_spacing() * 4 / 3
                              : request.sheet.pitch) /
                         film.height;
    request.sheet.offset = {};
    request.sheet.slant = 0;
}

} // namespace integral
