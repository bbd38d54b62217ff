// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/light_field.h"

#include "integral/frame/recorded_camera.h"
#include "integral/views/view_lenses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace integral {

struct LightFieldAxes::State {
    State(const FrameMetadata& m, ViewGrid directions)
        : lenses(m, directions), medium(recorded_camera(m).optics.medium())
    {
        if (lenses.exact) {
            const auto whole = [](const Side& side, int pixels, int& from, int& count) {
                from = side.border % side.pixels;
                count = (pixels - from) / side.pixels;
            };
            whole(lenses.across, m.film.width, first.column, s);
            whole(lenses.down, m.film.height, first.row, t);
        } else {
            const bool hexagonal = m.sheet.arrangement == Arrangement::hexagonal;
            s = hexagonal ? lenses.window.columns / 2 : lenses.window.columns;
            t = lenses.window.rows;
        }
        if (s < 1 || t < 1)
            throw std::invalid_argument("the film has no whole lens; a light field needs one");
        constexpr int most_directions = 4096; // one way, as a quilt's views
        const ViewGrid grid = lenses.grid;
        if (std::max(grid.columns, grid.rows) > most_directions ||
            double(grid.columns) * grid.rows * t > std::numeric_limits<int>::max())
            throw std::invalid_argument("the light field has too many samples; choose fewer "
                                        "directions, at most " +
                                        std::to_string(most_directions) + " one way");
    }

    /// The first pixel of lens (t, s) in the views of `lenses`.
    PixelPlace view_pixel_of(int row, int column) const
    {
        if (lenses.exact)
            return {column + lenses.across.lens(first.column), row + lenses.down.lens(first.row)};
        if (lenses.arrangement == Arrangement::hexagonal)
            return {2 * column + int((lenses.window.first.j - row) & 1), row};
        return {column, row};
    }
    LensIndex lens(int row, int column) const
    {
        const PixelPlace pixel = view_pixel_of(row, column);
        return lenses.lens_at(pixel.column, pixel.row);
    }

    /// The number of the view that shows a direction. Views are numbered from the left and from
    /// below, as the viewer sees them: the opposite of the order on the film, sideways.
    int view(int v, int u) const { return v * lenses.grid.columns + lenses.grid.columns - 1 - u; }

    Lenses lenses;
    Medium medium;
    PixelPlace first{0, 0};
    int s = 0, t = 0;
};

LightFieldAxes::LightFieldAxes(const FrameMetadata& metadata, ViewGrid directions)
    : state_(std::make_unique<State>(metadata, directions))
{
}
LightFieldAxes::~LightFieldAxes() = default;

int LightFieldAxes::u() const { return state_->lenses.grid.columns; }
int LightFieldAxes::v() const { return state_->lenses.grid.rows; }
int LightFieldAxes::s() const { return state_->s; }
int LightFieldAxes::t() const { return state_->t; }
bool LightFieldAxes::is_exact() const { return state_->lenses.exact; }
PixelPlace LightFieldAxes::first() const { return state_->first; }

Vec2 LightFieldAxes::pole(int t, int s) const
{
    // Film rows count from 0 along upright lenticular lenses, film columns along lying ones.
    return state_->lenses.middle(state_->lens(t, s), s, t);
}

Vec2 LightFieldAxes::film_point(int v, int u, int t, int s) const
{
    const Lenses& lenses = state_->lenses;
    if (lenses.exact)
        return lenses.point(state_->first.column + s * this->u() + u,
                            state_->first.row + t * this->v() + v);
    return lenses.film_point(pole(t, s), lenses.part_of_view(state_->view(v, u)));
}

std::optional<Vec2> LightFieldAxes::aperture_point(int v, int u, double distance) const
{
    const auto direction = direction_from_offset(state_->medium,
                                                 pole(0, 0) - film_point(v, u, 0, 0));
    if (!direction)
        return std::nullopt;
    return (-distance / direction->z) * Vec2{direction->x, direction->y};
}

double LightFieldAxes::along_rows(Vec2 point) const
{
    const Lenses& lenses = state_->lenses;
    return lenses.arrangement == Arrangement::lenticular ? point.x
                                                         : dot(lenses.lattice.across(), point);
}

double LightFieldAxes::across_rows(Vec2 point) const
{
    const Lenses& lenses = state_->lenses;
    return lenses.arrangement == Arrangement::lenticular ? point.y
                                                         : dot(lenses.lattice.along(), point);
}

std::optional<Image> light_field_samples(const Frame& frame, const LightFieldAxes& axes,
                                         int threads, const Progress& progress)
{
    const LightFieldAxes::State& state = *axes.state_;
    const int rows = axes.v() * axes.u() * axes.t();
    Image samples = blank_like(frame.image, axes.s(), rows);
    const LinearReader light(frame.image);
    const auto draw = [&](int row) {
        const int t = row % axes.t(), direction = row / axes.t();
        const int v = direction / axes.u(), u = direction % axes.u();
        for (int s = 0; s < axes.s(); ++s) {
            if (axes.is_exact()) {
                store_pixel(samples, s, row,
                            stored_pixel(frame.image, axes.first().column + s * axes.u() + u,
                                         axes.first().row + t * axes.v() + v));
                continue;
            }
            const PixelPlace pixel = state.view_pixel_of(t, s);
            if (const auto colour = view_pixel(state.lenses, light, state.view(v, u), pixel.column,
                                               pixel.row))
                store_linear(samples, s, row, *colour);
        }
    };
    if (!for_each_row(rows, threads, draw, progress))
        return std::nullopt;
    return samples;
}

std::vector<unsigned char> light_field_mask(const FrameMetadata& metadata,
                                            const LightFieldAxes& axes, int threads)
{
    const IntegralCamera camera = recorded_camera(metadata);
    const Film& film = metadata.film;
    // The lens of the sheet's own lattice, which may not be the one with the least slant.
    const auto is_imaged = [&](double x, double y, LensIndex lens) {
        if (!(x >= 0 && y >= 0 && x < film.width && y < film.height))
            return false;
        const Vec2 centre{std::floor(x) + 0.5, std::floor(y) + 0.5};
        const auto ray = camera.optics.map(film_from_pixel(film, centre), camera.mapping).ray;
        return ray && ray->lens == lens;
    };
    // Interpolated samples need the pixels around them; a sample in a pixel's middle only that one.
    const double around = axes.is_exact() ? 0 : 0.5 - 1e-6;
    const int s_count = axes.s(), t_count = axes.t(), u_count = axes.u();
    std::vector<unsigned char> mask(std::size_t(axes.v()) * u_count * t_count * s_count);
    for_each_row(axes.v() * u_count * t_count, threads, [&](int row) {
        const int t = row % t_count, direction = row / t_count;
        for (int s = 0; s < s_count; ++s) {
            const Vec2 pixel = pixel_from_film(
                film, axes.film_point(direction / u_count, direction % u_count, t, s));
            const LensIndex lens = camera.optics.lattice().nearest(axes.pole(t, s));
            bool imaged = true;
            for (const double y : {pixel.y - around, pixel.y + around})
                for (const double x : {pixel.x - around, pixel.x + around})
                    imaged = imaged && is_imaged(x, y, lens);
            mask[std::size_t(row) * s_count + s] = imaged;
        }
    });
    return mask;
}

} // namespace integral
