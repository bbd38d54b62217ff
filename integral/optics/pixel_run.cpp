// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/pixel_run.h"

#include <algorithm>
#include <limits>

namespace integral {

namespace {

constexpr int lanes = PixelRun::pixels;
constexpr double border_margin = 1e-7; // pitches: within that of a border another lens may be as
                                       // near
constexpr double rival_margin = 1e-6;  // of the least distance between two lenses' rays at the
                                       // aperture
constexpr int steps = 3;               // of Newton's: nearly every ray needs two

} // namespace

/// What each lane knows of its pole ray. Whole numbers as doubles; `sure` and `shown` 0 or 1.
struct PixelRuns::PoleRays {
    Lanes film_x;
    double film_y;
    Lanes nearest_column, nearest_row, column, row, point_x, point_y, offset_x, offset_y, root,
        aperture_x, aperture_y, sure, shown;
};

/// Which other lenses might show pixels to the aperture, too. From lens to lens the place A at the
/// aperture to which a film point's ray goes moves along with the pole x: (A' - A).(x' - x) >= s
/// |x' - x|^2, s = 1 + n d/t (A is the gradient of a function whose curvature is at least s). So
/// the right neighbour's ray goes by the aperture on the right, but where the lens's own is far on
/// the left. That leaves of the eight neighbours, and of all lenses, mostly none.
struct PixelRuns::Rivals {
    Lanes number;      // 0 to 4, or more: not known
    Lanes column, row; // from the lens to its rival, if it is one
};

PixelRuns::PixelRuns(const IntegralCamera& camera) : lattice_(camera.optics.lattice())
{
    const SheetOptics& optics = camera.optics;
    const Aperture& aperture = optics.aperture();
    const LensMapping mapping = camera.mapping;
    lenticular_ = lattice_.arrangement() == Arrangement::lenticular;
    slit_horizontal_ = slit_is_horizontal(optics.sheet());
    possible_ = lattice_.arrangement() != Arrangement::hexagonal &&
                aperture.shape == ApertureShape::rectangle &&
                (mapping == LensMapping::automatic || mapping == LensMapping::closest) &&
                !camera.pseudoscopic && !refracts_at_surface(optics.model()) &&
                optics.medium().m > 0;
    film_centre_ = {0.5 * camera.film.width, 0.5 * camera.film.height};
    pixel_pitch_ = camera.film.pixel_pitch;
    across_ = lattice_.across();
    along_ = lattice_.along();
    offset_ = optics.sheet().offset;
    edge_ = {0.5 * aperture.width * inclusive_edge, 0.5 * aperture.height * inclusive_edge};
    pitch_ = lattice_.pitch();
    row_spacing_ = lattice_.row_spacing();
    farthest_ = 1e6 * pitch_;
    n_ = optics.medium().n;
    t_ = optics.medium().t;
    m_ = optics.medium().m;
    root_m_ = optics.medium().root_m;
    distance_ = aperture.distance;
    slit_distance_ = optics.slit().distance;
    slit_axis_ = optics.slit().axis;
    slit_across_ = optics.slit().across;
    slit_normal_ = optics.slit().normal;
    placement_ = camera.placement;
    front_ = camera.depth_range ? std::min(camera.depth_range->x, distance_) : distance_;
    at_aperture_ = !(front_ < distance_);
    limited_ = camera.depth_range.has_value();
    seen_ = limited_ ? front_ + camera.depth_range->y : 0;
    compare_lenses(mapping);
}

/// What guess_lenses, find_rivals and settle ask of a camera.
void PixelRuns::compare_lenses(LensMapping mapping)
{
    const double spacing = pitch_ * (1 + n_ * distance_ / t_); // the least between two lenses' rays
                                                               // at the aperture
    // A lens whose ray passes so near to the aperture's centre is alone: of two, one would pass
    // farther away (SheetOptics::map_accurate).
    alone_ = 0.5 * spacing * (1 - 1e-6) - 4 * lattice_.tie_tolerance();
    const double towards = t_ / (n_ * distance_ + t_);
    bend_ = m_ * (towards / t_) * (towards / t_);

    double half_diagonal;
    const double half_pitch = 0.5 * pitch_;
    if (lenticular_) {
        const double slit = slit_horizontal_ ? edge_.x : edge_.y,
                     turn = slit_horizontal_ ? across_.x : across_.y;
        columns_at_aperture_ = slit_horizontal_ ? Vec2{std::copysign(1.0, turn), 0}
                                                : Vec2{0, std::copysign(1.0, turn)};
        rows_at_aperture_ = {0, 0};
        column_ = spacing - slit;
        row_ = diagonal_ = other_diagonal_ = spacing;
        half_diagonal = slit;
        const double g = dot(slit_normal_, slit_axis_);
        nearest_gets_through_ = m_ * half_pitch * half_pitch < t_ * t_ * g * g * (1 - 1e-6);
    } else {
        columns_at_aperture_ = across_;
        rows_at_aperture_ = along_;
        const auto extent = [&](Vec2 direction) {
            return edge_.x * std::fabs(direction.x) + edge_.y * std::fabs(direction.y);
        };
        column_ = spacing - extent(across_);
        row_ = spacing - extent(along_);
        diagonal_ = 2 * spacing - extent(across_ + along_);
        other_diagonal_ = 2 * spacing - extent(across_ - along_);
        half_diagonal = length(edge_);
        nearest_gets_through_ = m_ * 2 * half_pitch * half_pitch < t_ * t_ * (1 - 1e-6);
    }
    beyond_ = 2 * spacing - half_diagonal; // a ray that passes nearer to the centre leaves none to
                                           // lenses beyond the neighbours
    for (double* limit : {&column_, &row_, &diagonal_, &other_diagonal_, &beyond_})
        *limit -= rival_margin * spacing;
    const bool telling = std::min({column_, row_, diagonal_, other_diagonal_}) > 0 &&
                         beyond_ > half_diagonal;
    guesses_ = mapping == LensMapping::automatic && telling;
    if (guesses_)
        return;
    // The nearest lens alone; with `closest` it has no rivals, and otherwise they are not known.
    const double infinity = std::numeric_limits<double>::infinity();
    column_ = row_ = diagonal_ = other_diagonal_ = beyond_ = mapping == LensMapping::closest
                                                                 ? infinity
                                                                 : 0;
}

/// The lenses nearest to pixels' centres, and those likely to show them: the nearest to where the
/// aperture's centre is seen from, which is p n d/(n d + root) of a film point p. The root is taken
/// by a series; a wrong guess costs time.
void PixelRuns::guess_lenses(Vec2 centre, PoleRays& rays) const
{
    rays.film_y = (film_centre_.y - centre.y) * pixel_pitch_.y;
    const double nd = n_ * distance_, lenses = 1 / pitch_;
    Lanes border;
    for (int k = 0; k < lanes; ++k) {
        const double film_x = ((centre.x + k) - film_centre_.x) * pixel_pitch_.x;
        const double from_x = film_x - offset_.x, from_y = rays.film_y - offset_.y;
        const double u = (across_.x * from_x + across_.y * from_y) * lenses;
        const double v = lenticular_ ? 0 : (along_.x * from_x + along_.y * from_y) * lenses;
        const double column = nearest_integer(u), row = nearest_integer(v);
        rays.film_x[k] = film_x;
        rays.nearest_column[k] = column;
        rays.nearest_row[k] = row;
        const double off_border = 0.5 - border_margin;
        const double du = std::fabs(u - column), dv = std::fabs(v - row),
                     far = std::fabs(film_x) + std::fabs(rays.film_y);
        border[k] = (du < off_border ? 0.0 : 1.0) + (dv < off_border ? 0.0 : 1.0);
        rays.sure[k] = far < farthest_ ? 1.0 : 0.0;

        const double steep = bend_ * (film_x * film_x + rays.film_y * rays.film_y),
                     inwards = nd / (nd + t_ * (1 - steep * (0.5 - 0.375 * steep)));
        const double there_x = inwards * film_x - offset_.x,
                     there_y = inwards * rays.film_y - offset_.y;
        const double guess_u = (across_.x * there_x + across_.y * there_y) * lenses;
        const double guess_v = lenticular_ ? 0 : (along_.x * there_x + along_.y * there_y) * lenses;
        rays.column[k] = guesses_ ? nearest_integer(guess_u) : column;
        rays.row[k] = guesses_ ? nearest_integer(guess_v) : row;
    }
    for (int k = 0; k < lanes; ++k)
        if (border[k] != 0 && rays.sure[k] != 0) { // perhaps as near to two
            const LensIndex lens = lattice_.nearest({rays.film_x[k], rays.film_y});
            rays.nearest_column[k] = static_cast<double>(lens.i);
            rays.nearest_row[k] = static_cast<double>(lens.j);
            rays.column[k] = guesses_ ? rays.column[k] : rays.nearest_column[k];
            rays.row[k] = guesses_ ? rays.row[k] : rays.nearest_row[k];
        }
}

/// Pixels' pole rays through the lenses of `column` and `row`, to the aperture, and whether they
/// pass it.
void PixelRuns::follow(PoleRays& rays) const
{
    const double film_y = rays.film_y, rows = lenticular_ ? 0 : 1;
    for (int k = 0; k < lanes; ++k) {
        double x = offset_.x + (rays.column[k] * pitch_) * across_.x,
               y = offset_.y + (rays.column[k] * pitch_) * across_.y;
        x = rows != 0 ? x + (rays.row[k] * row_spacing_) * along_.x : x;
        y = rows != 0 ? y + (rays.row[k] * row_spacing_) * along_.y : y;
        rays.point_x[k] = x;
        rays.point_y[k] = y;
    }
    if (!lenticular_)
        for (int k = 0; k < lanes; ++k) {
            const double x = rays.point_x[k] - rays.film_x[k], y = rays.point_y[k] - film_y;
            const double mq2 = m_ * (x * x + y * y), t2 = t_ * t_, root = std::sqrt(t2 - mq2);
            const double away = (n_ * distance_) / root;
            rays.offset_x[k] = x;
            rays.offset_y[k] = y;
            rays.root[k] = root;
            rays.aperture_x[k] = rays.point_x[k] + away * x;
            rays.aperture_y[k] = rays.point_y[k] + away * y;
            rays.sure[k] *= 2 * mq2 <= t2 ? 1.0 : 0.0;
        }
    else {
        const double g = slit_normal_.x * slit_axis_.x + slit_normal_.y * slit_axis_.y;
        const double eb = slit_normal_.x * slit_across_.x + slit_normal_.y * slit_across_.y;
        const double nd = n_ * slit_distance_, t2 = t_ * t_;
        Lanes h, foot_x, foot_y, alpha, lateral, clear, end, tau, done;
        const auto equation = [&](int k) {
            return PoleEquation{alpha[k], g, lateral[k], nd, m_, clear[k], end[k]};
        };
        for (int k = 0; k < lanes; ++k) {
            h[k] = slit_across_.x * (rays.point_x[k] - rays.film_x[k]) +
                   slit_across_.y * (rays.point_y[k] - film_y);
            foot_x[k] = rays.film_x[k] + h[k] * slit_across_.x;
            foot_y[k] = film_y + h[k] * slit_across_.y;
            const double mh2 = m_ * (h[k] * h[k]);
            clear[k] = t2 - mh2;
            alpha[k] = slit_normal_.x * foot_x[k] + slit_normal_.y * foot_y[k];
            lateral[k] = h[k] * eb;
            const double root_clear = std::sqrt(clear[k]);
            end[k] = PoleEquation::end_of(root_clear, root_m_);
            rays.sure[k] *= (2 * mh2 <= t2 ? 1.0 : 0.0) *
                            (std::fabs(lateral[k]) < g * end[k] ? 1.0 : 0.0);
            tau[k] = equation(k).start(root_clear, t_);
            done[k] = 0;
        }
        double settled = 0;
        for (int step = 0; step < steps && settled < lanes; ++step) {
            settled = 0;
            for (int k = 0; k < lanes; ++k) {
                const double change = equation(k).step(tau[k]), next = tau[k] - change;
                const double close = equation(k).settled(change, next) ? 1.0 : 0.0;
                tau[k] = done[k] != 0 ? tau[k] : next; // a settled root stays
                done[k] = done[k] != 0 ? 1.0 : close;
                settled += std::max(done[k], 1 - rays.sure[k]);
            }
        }
        for (int k = 0; k < lanes; ++k) {
            const double s = equation(k).root(tau[k]), stretch = slit_distance_ / s;
            const double offset_x = h[k] * slit_across_.x + tau[k] * slit_axis_.x,
                         offset_y = h[k] * slit_across_.y + tau[k] * slit_axis_.y;
            const double x = foot_x[k] + tau[k] * slit_axis_.x,
                         y = foot_y[k] + tau[k] * slit_axis_.y;
            const double aperture_x = x + stretch * (n_ * offset_x),
                         aperture_y = y + stretch * (n_ * offset_y);
            rays.point_x[k] = x;
            rays.point_y[k] = y;
            rays.offset_x[k] = offset_x;
            rays.offset_y[k] = offset_y;
            rays.root[k] = s;
            rays.aperture_x[k] = slit_horizontal_ ? aperture_x : slit_normal_.x * 0;
            rays.aperture_y[k] = slit_horizontal_ ? slit_normal_.y * 0 : aperture_y;
            rays.sure[k] *= done[k] * (s > 0 ? 1.0 : 0.0) * (n_ * stretch < 1 ? 0.0 : 1.0);
        }
    }
    for (int k = 0; k < lanes; ++k) {
        const double within_x = std::fabs(rays.aperture_x[k]) <= edge_.x ? 1.0 : 0.0,
                     within_y = std::fabs(rays.aperture_y[k]) <= edge_.y ? 1.0 : 0.0;
        const double across = lenticular_ && !slit_horizontal_ ? 1.0 : within_x,
                     along = lenticular_ && slit_horizontal_ ? 1.0 : within_y;
        rays.shown[k] = across * along;
    }
}

/// Of rays that need not pass the aperture.
void PixelRuns::find_rivals(const PoleRays& rays, Rivals& rivals) const
{
    for (int k = 0; k < lanes; ++k) {
        const double x = rays.aperture_x[k], y = rays.aperture_y[k];
        const double u = columns_at_aperture_.x * x + columns_at_aperture_.y * y,
                     v = rows_at_aperture_.x * x + rows_at_aperture_.y * y;
        const double sum = u + v, difference = u - v;
        const double in_column = std::fabs(v) < row_ ? 0.0 : 1.0,
                     in_row = std::fabs(u) < column_ ? 0.0 : 1.0;
        const double diagonal = std::fabs(sum) < diagonal_ ? 0.0 : 1.0,
                     other_diagonal = std::fabs(difference) < other_diagonal_ ? 0.0 : 1.0;
        rivals.number[k] = in_column + in_row + diagonal + other_diagonal +
                           (u * u + v * v < beyond_ * beyond_ ? 0.0 : 8.0);
        const double against_u = u > 0 ? -1.0 : 1.0, against_v = v > 0 ? -1.0 : 1.0;
        rivals.column[k] = (in_row + diagonal + other_diagonal) * against_u;
        rivals.row[k] = (in_column + diagonal + other_diagonal) * against_v;
    }
}

/// Which pixels are shown, and by which lens; those that several lenses come into question for are
/// followed through a second one: the nearest, which goes first if its ray passes, or the likely
/// one's only rival.
void PixelRuns::settle(PoleRays& rays, PixelRun& run) const
{
    Lanes nearest, second;
    double plain = 0;
    for (int k = 0; k < lanes; ++k) {
        nearest[k] = rays.column[k] == rays.nearest_column[k] && rays.row[k] == rays.nearest_row[k]
                         ? 1.0
                         : 0.0;
        plain += rays.sure[k] * rays.shown[k] * nearest[k];
    }
    if (plain == lanes) {
        run.given.fill(true);
        run.empty.fill(false);
        run.searched.fill(false);
        return;
    }

    Rivals rivals;
    find_rivals(rays, rivals);
    double seconds = 0;
    for (int k = 0; k < lanes; ++k) {
        const double alone = rivals.number[k] == 0 ? 1.0 : 0.0;
        const double given = rays.sure[k] * rays.shown[k] * std::max(nearest[k], alone);
        const double empty = rays.sure[k] * (1 - rays.shown[k]) * alone *
                             (nearest_gets_through_ ? 1.0 : nearest[k]);
        second[k] = rays.sure[k] * (1 - given) * (1 - empty) *
                    (rivals.number[k] == 1 ? 1.0 : 1 - nearest[k]);
        seconds += second[k];
        run.given[k] = given != 0;
        run.empty[k] = empty != 0;
        run.searched[k] = nearest[k] == 0;
    }
    if (seconds == 0)
        return;

    PoleRays others = rays;
    Lanes certain;
    for (int k = 0; k < lanes; ++k) {
        const double rival_column = rays.column[k] + rivals.column[k],
                     rival_row = rays.row[k] + rivals.row[k];
        others.column[k] = nearest[k] != 0 ? rival_column : rays.nearest_column[k];
        others.row[k] = nearest[k] != 0 ? rival_row : rays.nearest_row[k];
        others.sure[k] = second[k];
        certain[k] = rivals.number[k] == 1 && others.column[k] == rival_column &&
                             others.row[k] == rival_row
                         ? 1.0
                         : 0.0;
    }
    follow(others);
    for (int k = 0; k < lanes; ++k) {
        if (others.sure[k] == 0)
            continue;
        const double x = rays.aperture_x[k], y = rays.aperture_y[k];
        if (others.shown[k] != 0) {
            for (const auto lane : {&PoleRays::column, &PoleRays::row, &PoleRays::point_x,
                                    &PoleRays::point_y, &PoleRays::offset_x, &PoleRays::offset_y,
                                    &PoleRays::root, &PoleRays::aperture_x, &PoleRays::aperture_y})
                (rays.*lane)[k] = (others.*lane)[k];
            run.given[k] = true;
            run.searched[k] = nearest[k] != 0;
        } else if (rays.shown[k] != 0)
            run.given[k] = certain[k] != 0 || (lenticular_ ? std::fabs(slit_horizontal_ ? x : y)
                                                           : std::sqrt(x * x + y * y)) < alone_;
        else
            run.empty[k] = certain[k] != 0;
    }
}

/// The same steps in the same order as SheetOptics::map and sight_line take for one pixel: every
/// number is theirs.
void PixelRuns::work_out(Vec2 centre, PixelRun& run) const
{
    PoleRays rays;
    guess_lenses(centre, rays);
    follow(rays);
    settle(rays, run);

    const Placement& at = placement_;
    Lanes x, y, z, start_x, start_y, start_z, scale;
    Lanes origin_x, origin_y, origin_z, direction_x, direction_y, direction_z;
    for (int k = 0; k < lanes; ++k) {
        const double offset_x = rays.offset_x[k], offset_y = rays.offset_y[k];
        const double inverse_length = 1 / std::sqrt((offset_x * offset_x + offset_y * offset_y) +
                                                    t_ * t_);
        const double sideways = n_ * inverse_length;
        x[k] = -(sideways * offset_x);
        y[k] = -(sideways * offset_y);
        z[k] = rays.root[k] * inverse_length;
        start_x[k] = rays.aperture_x[k];
        start_y[k] = rays.aperture_y[k];
        start_z[k] = -distance_;
    }
    if (!at_aperture_)
        for (int k = 0; k < lanes; ++k) {
            const double back = -front_ / z[k];
            start_x[k] = rays.point_x[k] + back * x[k];
            start_y[k] = rays.point_y[k] + back * y[k];
            start_z[k] = back * z[k];
        }
    for (int k = 0; k < lanes; ++k) {
        origin_x[k] = at.origin.x + start_x[k] * at.x.x + start_y[k] * at.y.x + start_z[k] * at.z.x;
        origin_y[k] = at.origin.y + start_x[k] * at.x.y + start_y[k] * at.y.y + start_z[k] * at.z.y;
        origin_z[k] = at.origin.z + start_x[k] * at.x.z + start_y[k] * at.y.z + start_z[k] * at.z.z;
        direction_x[k] = x[k] * at.x.x + y[k] * at.y.x + z[k] * at.z.x;
        direction_y[k] = x[k] * at.x.y + y[k] * at.y.y + z[k] * at.z.y;
        direction_z[k] = x[k] * at.x.z + y[k] * at.y.z + z[k] * at.z.z;
        scale[k] = at.units_per_mm;
    }
    if (!at.right_angled)
        for (int k = 0; k < lanes; ++k)
            scale[k] = std::sqrt(direction_x[k] * direction_x[k] + direction_y[k] * direction_y[k] +
                                 direction_z[k] * direction_z[k]);

    const double same_inverse = 1 / at.units_per_mm;
    for (int k = 0; k < lanes; ++k) {
        if (!run.given[k])
            continue;
        const double inverse = at.right_angled ? same_inverse : 1 / scale[k];
        run.lens[k] = {static_cast<std::int64_t>(rays.column[k]),
                       static_cast<std::int64_t>(rays.row[k])};
        run.line[k] = {{origin_x[k], origin_y[k], origin_z[k]},
                       inverse * Vec3{direction_x[k], direction_y[k], direction_z[k]},
                       limited_ ? scale[k] * seen_ / z[k] : 0};
    }
}

} // namespace integral
