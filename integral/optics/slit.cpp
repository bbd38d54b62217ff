// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/slit.h"

#include <algorithm>

namespace integral {

namespace {

/// A step of Newton's method leaves an error of about change^2/(distance to the end of the
/// interval). The search ends when that error is less than this fraction of the root.
constexpr double slit_settled = 1e-17;

/// The foot of a film point on a line of the lens parallel to its axis.
struct Foot {
    double h;   ///< mm: signed distance from the film point to the line, along `across`
    Vec2 point; ///< the point of the line nearest to the film point, projected to z = 0
};

/// `on_axis`: any point of the lens's axis; the line is `v` mm from it along `across`.
inline Foot foot_on_line(const Slit& slit, Vec2 film_point, Vec2 on_axis, double v)
{
    const double h = dot(slit.across, on_axis - film_point) + v;
    return {h, film_point + h * slit.across};
}

/// The slit's equation for light that is refracted in the plane of the poles: with S = sqrt(E - m
/// tau^2), E the clearance at tau = 0, p = g tau + h e.b and D the slit's distance
///     H(tau) = alpha + g tau + n D p/S,   H' = g + n D (g E + m h (e.b) tau)/S^3.
struct PoleEquation {
    double alpha;    ///< e.foot - eta
    double g;        ///< e.a
    double lateral;  ///< h e.b
    double nd;       ///< n D
    double m, clear; ///< of the medium; E
    double end;      ///< the greatest |tau|, sqrt(E/m)

    /// Whether there is a root: H changes its sign between -end and end.
    bool has_root() const { return std::fabs(lateral) < g * end; }

    /// An approximation of the root, of third order in tau. Uses series in place of quotients,
    /// which are accurate if E is little less than t^2.
    double start(double root_clear, double t) const
    {
        const double inverse_t2 = 1 / (t * t), inverse_reach = 1 / (t + nd), inverse_g = 1 / g;
        const double narrower = (t - root_clear) * inverse_reach,
                     paraxial = inverse_g * inverse_reach * (1 + narrower + narrower * narrower);
        const double taken = 1 - clear * inverse_t2,
                     bend = (0.5 * m * inverse_t2) * (1 + taken + taken * taken);
        const double first = -(alpha * root_clear + nd * lateral) * paraxial;
        return first - nd * (g * first + lateral) * paraxial * (bend * first * first);
    }
    double root(double tau) const { return std::sqrt(m * ((end - tau) * (end + tau))); } ///< S
    /// Newton's step, H/H'.
    double step(double tau) const
    {
        const double s2 = m * ((end - tau) * (end + tau)), s = std::sqrt(s2);
        return ((alpha + g * tau) * s + nd * (g * tau + lateral)) * s2 /
               (g * s * s2 + nd * (g * clear + m * lateral * tau));
    }
    /// Whether the step by `change` that led to tau needs no further step.
    bool settled(double change, double tau) const
    {
        return change * change <= slit_settled * std::fabs(tau) * (end - std::fabs(tau));
    }
};

/// The slit's equation at a line of the lens. With S = sqrt(E - m tau^2), E the clearance at tau =
/// 0, the refracted ray is (n k cosine + S sine, n tau, -C)/L in the directions (b, a, z), C = S
/// cosine - n k sine.
///     H(tau) = alpha + g tau + D (g n tau + e.b (n k cosine + S sine))/C = 0,
///     H' = g + D n phi/(S C^2), phi = g (cosine E - n k sine S) + m (e.b) k tau,
/// D the distance from the line to the aperture. G of optics.md is H C.
struct Equation {
    double alpha, g, eb, distance, n, m, root_m, k, sine, cosine, e;

    double c(double s) const { return s * cosine - n * k * sine; }
    double g_value(double tau, double s) const
    {
        return (alpha + g * tau) * c(s) +
               distance * (g * n * tau + eb * (n * k * cosine + s * sine));
    }
    /// Newton's step, H/H'.
    double step(double tau, double s, double value) const
    {
        const double cs = c(s), phi = g * (cosine * e - n * k * sine * s) + m * eb * k * tau;
        return value * (s * cs) / (g * s * cs * cs + distance * n * phi);
    }
};

/// The equation; empty if no light reaches the plane from inside or leaves it towards the viewer.
std::optional<Equation> equation_of(const Slit& slit, const Medium& medium, Vec2 foot, double h,
                                    double eta, const TangentPlane& plane)
{
    const Incidence way = incidence(medium, plane, h);
    const double clear = clearance(medium, way, 0);
    if (!(clear > 0) || !(way.normal > 0))
        return std::nullopt;
    const Equation equation{dot(slit.normal, foot) - eta,
                            dot(slit.normal, slit.axis),
                            dot(slit.normal, slit.across),
                            slit.distance + plane.height,
                            medium.n,
                            medium.m,
                            medium.root_m,
                            way.tangential,
                            plane.sine,
                            plane.cosine,
                            clear};
    if (!(equation.c(std::sqrt(clear)) > 0))
        return std::nullopt;
    return equation;
}

/// The greatest |tau|, `end`: `limit`, where total reflection starts, or where C = 0 if that comes
/// first. Empty unless H is below 0 at -end and above 0 at end. If it is, H has one root only: H
/// rises throughout, except perhaps next to an end, where it has that end's sign.
std::optional<double> end_of(const Equation& equation, double root_e, double limit)
{
    const double floor = equation.n * equation.k * equation.sine; // C > 0 needs S cosine > floor
    if (floor < 0) {
        if (equation.g_value(-limit, 0) < 0 && equation.g_value(limit, 0) > 0)
            return limit;
        return std::nullopt;
    }
    double end = limit;
    if (floor > 0) {
        const double least_s = floor / equation.cosine;
        end = std::sqrt((root_e - least_s) * (root_e + least_s)) / equation.root_m;
    }
    if (std::fabs(equation.eb * equation.k) < equation.g * equation.cosine * end)
        return end;
    return std::nullopt;
}

/// Newton's method for light that is refracted in the plane of the poles. Nearly every ray of a
/// picture needs two steps.
class PoleSearch {
public:
    static constexpr int usual_steps = 2;

    /// To be called once, before the first step. `foot`: the foot of the film point.
    void begin(const Slit& slit, const Medium& medium, const Foot& foot, double eta)
    {
        const double clear = clearance(medium, {foot.h, 0});
        if (!(medium.m > 0 && clear > 0))
            return;
        const double root_clear = std::sqrt(clear);
        equation_ = {dot(slit.normal, foot.point) - eta,
                     dot(slit.normal, slit.axis),
                     foot.h * dot(slit.normal, slit.across),
                     medium.n * slit.distance,
                     medium.m,
                     clear,
                     root_clear * (1 / medium.root_m)};
        going_on_ = equation_.has_root();
        tau_ = equation_.start(root_clear, medium.t);
    }

    /// Does one step, unless the search has ended.
    void step()
    {
        if (!going_on_)
            return;
        ++steps_;
        going_on_ = std::fabs(tau_) < equation_.end;
        if (!going_on_)
            return;
        const double change = equation_.step(tau_);
        tau_ -= change;
        found_ = equation_.settled(change, tau_);
        going_on_ = !found_;
    }

    /// Does the remaining steps. Returns false if they do not suffice: use solve_in_bracket then.
    bool settles()
    {
        constexpr int most_steps = 5;
        while (going_on_ && steps_ < most_steps)
            step();
        return found_ && s() > 0;
    }

    double tau() const { return tau_; }
    double s() const { return equation_.root(tau_); } ///< S at tau

private:
    PoleEquation equation_; ///< not set if nothing is refracted, or all light is reflected; then
                            ///< there is no step
    double tau_ = 0;
    int steps_ = 0;
    bool going_on_ = false, found_ = false;
};

/// The ray that leaves the lens at the offset tau from `foot`, in the direction `refracted`.
/// `line`: a point of the line on which it leaves; `distance`: from there to the aperture plane.
inline SlitRay ray_from(const Slit& slit, double n, const Foot& foot, Vec2 line, double tau,
                        double eta, double distance, Vec3 refracted)
{
    SlitRay ray;
    ray.offset = foot.h * slit.across + tau * slit.axis;
    ray.refracted = refracted;
    ray.point = foot.point + tau * slit.axis;
    const double stretch = distance / -refracted.z;
    const Vec2 to_aperture = stretch * Vec2{refracted.x, refracted.y};
    if (n * stretch < 1) {
        // The slit is so near that foot + tau a loses accuracy to cancellation. The point's
        // component across the slit follows from where the light meets the slit.
        const double across_slit = eta - dot(slit.normal, to_aperture);
        const double along_axis = (across_slit - dot(slit.normal, line)) /
                                  dot(slit.normal, slit.axis);
        ray.point = line + along_axis * slit.axis;
    }
    ray.aperture_point = ray.point + to_aperture;
    if (slit.normal.x == 0)
        ray.aperture_point.y = slit.normal.y * eta;
    else
        ray.aperture_point.x = slit.normal.x * eta;
    return ray;
}

/// The same for light that is refracted in the plane of the poles.
inline SlitRay ray_from_pole(const Slit& slit, const Medium& medium, const Foot& foot, Vec2 on_axis,
                             const PoleSearch& search, double eta)
{
    const Vec2 lateral = medium.n * (foot.h * slit.across + search.tau() * slit.axis);
    return ray_from(slit, medium.n, foot, on_axis, search.tau(), eta, slit.distance,
                    {lateral.x, lateral.y, -search.s()});
}

/// solve_slit if PoleSearch does not settle, or the light is refracted elsewhere than in the plane
/// of the poles: Newton's method within a bracket.
std::optional<double> solve_in_bracket(const Slit& slit, const Medium& medium, Vec2 foot, double h,
                                       double eta, const TangentPlane& plane)
{
    const auto found = equation_of(slit, medium, foot, h, eta, plane);
    if (!found)
        return std::nullopt;
    const Equation& equation = *found;
    const double root_e = std::sqrt(equation.e);
    const double paraxial = -equation.step(0, root_e, equation.g_value(0, root_e));
    if (medium.m == 0)
        return paraxial; // exact: nothing is refracted
    const double limit = root_e / medium.root_m;
    const auto reach = end_of(equation, root_e, limit);
    if (!reach)
        return std::nullopt;

    // Newton steps, kept inside a shrinking bracket.
    const double end = *reach;
    double low = -end, high = end;
    double tau = paraxial > low && paraxial < high ? paraxial : 0;
    constexpr int most_steps = 200, soon = 20; // the worst cases tested need 55
    for (int step = 0; step < most_steps; ++step) {
        const double s2 = medium.m * (limit - tau) * (limit + tau);
        const double s = s2 > 0 ? std::sqrt(s2) : 0;
        if (!(s > 0) || !(equation.c(s) > 0))
            return std::nullopt; // grazing light, rounded onto an end of the interval
        const double value = equation.g_value(tau, s);
        if (value == 0)
            break;
        (value < 0 ? low : high) = tau;
        const double before = tau, change = equation.step(tau, s, value);
        tau -= change;
        if (tau == before ||
            change * change <= slit_settled * std::fabs(tau) * (end - std::fabs(tau)))
            break;
        if (!(tau > low && tau < high) || (step > soon && step % 3 == 0))
            tau = 0.5 * (low + high);
        if (!(tau > low && tau < high)) // no number left in between
            break;
    }
    return std::clamp(tau, -end, end);
}

} // namespace

bool reaches_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h, double eta,
                  const TangentPlane& plane)
{
    const auto equation = equation_of(slit, medium, foot, h, eta, plane);
    if (!equation)
        return false;
    const double root_e = std::sqrt(equation->e);
    return medium.m == 0 || end_of(*equation, root_e, root_e / medium.root_m);
}

std::optional<double> solve_slit(const Slit& slit, const Medium& medium, Vec2 foot, double h,
                                 double eta, const TangentPlane& plane)
{
    if (plane.sine == 0) {
        PoleSearch search;
        search.begin(slit, medium, {h, foot}, eta);
        if (search.settles())
            return search.tau();
    }
    return solve_in_bracket(slit, medium, foot, h, eta, plane);
}

/// slit_ray by solve_in_bracket.
static std::optional<SlitRay> ray_in_bracket(const Slit& slit, const Medium& medium,
                                             const Foot& foot, Vec2 on_axis, double eta,
                                             const TangentPlane& plane)
{
    const auto tau = solve_in_bracket(slit, medium, foot.point, foot.h, eta, plane);
    if (!tau)
        return std::nullopt;
    const Incidence way = incidence(medium, plane, foot.h);
    const double clear = clearance(medium, way, *tau);
    if (!(clear > 0))
        return std::nullopt;
    const Vec3 out = refracted(medium, plane, way, *tau, std::sqrt(clear));
    if (!(out.z < 0))
        return std::nullopt;
    const Vec3 direction{out.x * slit.across.x + out.y * slit.axis.x,
                         out.x * slit.across.y + out.y * slit.axis.y, out.z};
    return ray_from(slit, medium.n, foot, on_axis + plane.v * slit.across, *tau, eta,
                    slit.distance + plane.height, direction);
}

std::optional<SlitRay> slit_ray(const Slit& slit, const Medium& medium, Vec2 film_point,
                                Vec2 on_axis, double eta, const TangentPlane& plane)
{
    const Foot foot = foot_on_line(slit, film_point, on_axis, plane.v);
    if (plane.sine == 0) {
        PoleSearch search;
        search.begin(slit, medium, foot, eta);
        if (search.settles())
            return ray_from_pole(slit, medium, foot, on_axis, search, eta);
    }
    return ray_in_bracket(slit, medium, foot, on_axis, eta, plane);
}

void slit_rays(const Slit& slit, const Medium& medium, int number, const RayRun<Vec2>& film_points,
               const RayRun<Vec2>& on_axes, const RayRun<double>& etas,
               RayRun<std::optional<SlitRay>>& rays)
{
    RayRun<Foot> feet;
    RayRun<PoleSearch> searches;
    for (int k = 0; k < number; ++k) {
        feet[k] = foot_on_line(slit, film_points[k], on_axes[k], 0);
        searches[k].begin(slit, medium, feet[k], etas[k]);
    }
    for (int step = 0; step < PoleSearch::usual_steps; ++step)
        for (int k = 0; k < number; ++k)
            searches[k].step();
    for (int k = 0; k < number; ++k)
        rays[k] = searches[k].settles()
                      ? ray_from_pole(slit, medium, feet[k], on_axes[k], searches[k], etas[k])
                      : ray_in_bracket(slit, medium, feet[k], on_axes[k], etas[k], {});
}

} // namespace integral
