// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/pixel_run.h"

#include <algorithm>

namespace integral {

namespace {

constexpr int lanes = PixelRun::pixels;
constexpr double border_margin = 1e-7; // pitches: within that of a border another lens may be as near
constexpr double fewest = 2;           // pixels that are searched for side by side: one is as soon found alone
constexpr int steps = 3;               // of Newton's: nearly every ray needs two

} // namespace

/// What each lane knows of its pole ray. Whole numbers as doubles; `sure` 0 or 1.
struct PixelRuns::PoleRays {
    Lanes film_x;
    double film_y;
    Lanes column, row, point_x, point_y, offset_x, offset_y, root, aperture_x, aperture_y, sure;
};

PixelRuns::PixelRuns(const IntegralCamera& camera)
{
    const SheetOptics& optics = camera.optics;
    const Aperture& aperture = optics.aperture();
    const Lattice& lattice = optics.lattice();
    const LensMapping mapping = camera.mapping;
    lenticular_ = lattice.arrangement() == Arrangement::lenticular;
    slit_horizontal_ = slit_is_horizontal(optics.sheet());
    possible_ = lattice.arrangement() != Arrangement::hexagonal && aperture.shape == ApertureShape::rectangle
             && (mapping == LensMapping::automatic || mapping == LensMapping::closest) && !camera.pseudoscopic
             && !refracts_at_surface(optics.model()) && optics.medium().m > 0;
    film_centre_ = {0.5 * camera.film.width, 0.5 * camera.film.height};
    pixel_pitch_ = camera.film.pixel_pitch;
    across_ = lattice.across();
    along_ = lattice.along();
    offset_ = optics.sheet().offset;
    edge_ = {0.5 * aperture.width * inclusive_edge, 0.5 * aperture.height * inclusive_edge};
    pitch_ = lattice.pitch();
    row_spacing_ = lattice.row_spacing();
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
    searches_ = mapping == LensMapping::automatic;
    // A lens whose ray passes so near to the aperture's centre is alone: of two, one would pass farther away (SheetOptics::map_accurate).
    alone_ = 0.5 * pitch_ * (1 + n_ * distance_ / t_) * (1 - 1e-6) - 4 * lattice.tie_tolerance();
    front_ = camera.depth_range ? std::min(camera.depth_range->x, distance_) : distance_;
    at_aperture_ = !(front_ < distance_);
    limited_ = camera.depth_range.has_value();
    seen_ = limited_ ? front_ + camera.depth_range->y : 0;
}

/// The lenses nearest to pixels' centres.
void PixelRuns::nearest_lenses(Vec2 centre, PoleRays& rays) const
{
    rays.film_y = (film_centre_.y - centre.y) * pixel_pitch_.y;
    for (int k = 0; k < lanes; ++k) {
        const double film_x = ((centre.x + k) - film_centre_.x) * pixel_pitch_.x;
        const double from_x = film_x - offset_.x, from_y = rays.film_y - offset_.y;
        const double u = (across_.x * from_x + across_.y * from_y) / pitch_;
        const double v = lenticular_ ? 0 : (along_.x * from_x + along_.y * from_y) / pitch_;
        const double column = nearest_integer(u), row = nearest_integer(v);
        rays.film_x[k] = film_x;
        rays.column[k] = column;
        rays.row[k] = row;
        const double off_border = 0.5 - border_margin;
        const double du = std::fabs(u - column), dv = std::fabs(v - row), far = std::fabs(film_x) + std::fabs(rays.film_y);
        rays.sure[k] = (du < off_border ? 1.0 : 0.0) * (dv < off_border ? 1.0 : 0.0) * (far < farthest_ ? 1.0 : 0.0);
    }
}

/// Pixels' pole rays through their lenses, to the aperture.
void PixelRuns::follow(PoleRays& rays) const
{
    const double film_y = rays.film_y, rows = lenticular_ ? 0 : 1;
    for (int k = 0; k < lanes; ++k) {
        double x = offset_.x + (rays.column[k] * pitch_) * across_.x, y = offset_.y + (rays.column[k] * pitch_) * across_.y;
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
        for (int k = 0; k < lanes; ++k) {
            h[k] = slit_across_.x * (rays.point_x[k] - rays.film_x[k]) + slit_across_.y * (rays.point_y[k] - film_y);
            foot_x[k] = rays.film_x[k] + h[k] * slit_across_.x;
            foot_y[k] = film_y + h[k] * slit_across_.y;
            const double mh2 = m_ * (h[k] * h[k]);
            clear[k] = t2 - mh2;
            alpha[k] = slit_normal_.x * foot_x[k] + slit_normal_.y * foot_y[k];
            lateral[k] = h[k] * eb;
            const double root_e = std::sqrt(clear[k]);
            end[k] = root_e / root_m_;
            rays.sure[k] *= (2 * mh2 <= t2 ? 1.0 : 0.0) * (std::fabs(lateral[k]) < g * end[k] ? 1.0 : 0.0);
            const double paraxial = 1 / (g * (root_e + nd));
            tau[k] = -(alpha[k] * root_e + nd * lateral[k]) * paraxial;
            tau[k] -= nd * (g * tau[k] + lateral[k]) * paraxial * (0.5 * m_ * tau[k] * tau[k] / clear[k]);
            done[k] = 0;
        }
        for (int step = 0; step < steps; ++step)
            for (int k = 0; k < lanes; ++k) {
                const double s2 = m_ * ((end[k] - tau[k]) * (end[k] + tau[k])), s = std::sqrt(s2);
                const double change = ((alpha[k] + g * tau[k]) * s + nd * (g * tau[k] + lateral[k])) * s2
                                    / (g * s * s2 + nd * (g * clear[k] + m_ * lateral[k] * tau[k]));
                const double next = tau[k] - change;
                const double close = change * change <= slit_settled * std::fabs(next) * (end[k] - std::fabs(next)) ? 1.0 : 0.0;
                tau[k] = done[k] != 0 ? tau[k] : next; // a settled root stays
                done[k] = done[k] != 0 ? 1.0 : close;
            }
        for (int k = 0; k < lanes; ++k) {
            const double s = std::sqrt(m_ * ((end[k] - tau[k]) * (end[k] + tau[k]))), stretch = slit_distance_ / s;
            const double offset_x = h[k] * slit_across_.x + tau[k] * slit_axis_.x, offset_y = h[k] * slit_across_.y + tau[k] * slit_axis_.y;
            const double x = foot_x[k] + tau[k] * slit_axis_.x, y = foot_y[k] + tau[k] * slit_axis_.y;
            const double aperture_x = x + stretch * (n_ * offset_x), aperture_y = y + stretch * (n_ * offset_y);
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
}

/// For pixels whose nearest lens is not seen from the aperture, the one that is: as far from the nearest as its ray is off the aperture's
/// centre, by the sheet's stretch there. Where that lens is beyond doubt it takes the nearest's place.
void PixelRuns::search(PoleRays& rays, Lanes& shown, PixelRun& run) const
{
    double unseen = 0;
    for (int k = 0; k < lanes; ++k)
        unseen += rays.sure[k] * (1 - shown[k]);
    if (unseen < fewest)
        return;
    PoleRays others = rays;
    for (int k = 0; k < lanes; ++k) {
        const double stretch = 1 + n_ * distance_ / rays.root[k];
        const double columns = nearest_integer(-(across_.x * rays.aperture_x[k] + across_.y * rays.aperture_y[k]) / (stretch * pitch_));
        const double rows = lenticular_ ? 0 : nearest_integer(-(along_.x * rays.aperture_x[k] + along_.y * rays.aperture_y[k]) / (stretch * row_spacing_));
        const bool wanted = rays.sure[k] != 0 && shown[k] == 0 && std::fabs(columns) + std::fabs(rows) > 0;
        others.column[k] += wanted ? columns : 0;
        others.row[k] += wanted ? rows : 0;
        others.sure[k] = wanted ? 1 : 0;
    }
    follow(others);
    const Lanes others_shown = pass(others);
    for (int k = 0; k < lanes; ++k) {
        const double x = others.aperture_x[k], y = others.aperture_y[k];
        const double off = lenticular_ ? std::fabs(slit_horizontal_ ? x : y) : std::sqrt(x * x + y * y);
        if (others.sure[k] == 0 || others_shown[k] == 0 || !(off < alone_))
            continue;
        for (const auto lane : {&PoleRays::column, &PoleRays::row, &PoleRays::point_x, &PoleRays::point_y, &PoleRays::offset_x, &PoleRays::offset_y,
                                &PoleRays::root, &PoleRays::aperture_x, &PoleRays::aperture_y})
            (rays.*lane)[k] = (others.*lane)[k];
        shown[k] = 1;
        run.searched[k] = true;
    }
}

/// Whether rays pass the aperture: 0 or 1.
PixelRuns::Lanes PixelRuns::pass(const PoleRays& rays) const
{
    Lanes passing;
    for (int k = 0; k < lanes; ++k) {
        const double within_x = std::fabs(rays.aperture_x[k]) <= edge_.x ? 1.0 : 0.0, within_y = std::fabs(rays.aperture_y[k]) <= edge_.y ? 1.0 : 0.0;
        const double across = lenticular_ && !slit_horizontal_ ? 1.0 : within_x, along = lenticular_ && slit_horizontal_ ? 1.0 : within_y;
        passing[k] = across * along;
    }
    return passing;
}

/// The same steps in the same order as SheetOptics::map and sight_line take for one pixel: every number is theirs.
void PixelRuns::work_out(Vec2 centre, PixelRun& run) const
{
    PoleRays rays;
    nearest_lenses(centre, rays);
    follow(rays);
    Lanes shown = pass(rays);
    run.searched = {};
    if (searches_)
        search(rays, shown, run);

    const Placement& at = placement_;
    Lanes origin_x, origin_y, origin_z, direction_x, direction_y, direction_z, length;
    for (int k = 0; k < lanes; ++k) {
        const double offset_x = rays.offset_x[k], offset_y = rays.offset_y[k];
        const double inverse_length = 1 / std::sqrt((offset_x * offset_x + offset_y * offset_y) + t_ * t_);
        const double sideways = n_ * inverse_length;
        const double x = -(sideways * offset_x), y = -(sideways * offset_y), z = rays.root[k] * inverse_length;
        const double back = -front_ / z;
        const double start_x = at_aperture_ ? rays.aperture_x[k] : rays.point_x[k] + back * x;
        const double start_y = at_aperture_ ? rays.aperture_y[k] : rays.point_y[k] + back * y;
        const double start_z = at_aperture_ ? -distance_ : back * z;
        origin_x[k] = at.origin.x + start_x * at.x.x + start_y * at.y.x + start_z * at.z.x;
        origin_y[k] = at.origin.y + start_x * at.x.y + start_y * at.y.y + start_z * at.z.y;
        origin_z[k] = at.origin.z + start_x * at.x.z + start_y * at.y.z + start_z * at.z.z;
        const double dx = x * at.x.x + y * at.y.x + z * at.z.x;
        const double dy = x * at.x.y + y * at.y.y + z * at.z.y;
        const double dz = x * at.x.z + y * at.y.z + z * at.z.z;
        const double scale = std::sqrt(dx * dx + dy * dy + dz * dz), inverse = 1 / scale;
        direction_x[k] = inverse * dx;
        direction_y[k] = inverse * dy;
        direction_z[k] = inverse * dz;
        length[k] = scale * seen_ / z;
    }

    for (int k = 0; k < lanes; ++k) {
        run.given[k] = rays.sure[k] != 0 && shown[k] != 0; // what is no number fails a comparison
        if (!run.given[k])
            continue;
        run.lens[k] = {static_cast<std::int64_t>(rays.column[k]), static_cast<std::int64_t>(rays.row[k])};
        run.line[k] = {{origin_x[k], origin_y[k], origin_z[k]}, {direction_x[k], direction_y[k], direction_z[k]}, limited_ ? length[k] : 0};
    }
}

} // namespace integral
