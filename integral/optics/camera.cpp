// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/camera.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace integral {

namespace {

[[noreturn]] void fail(const std::string& message) { throw std::invalid_argument(message); }

void check_view(const ViewFrame& view)
{
    const double right = length(view.right), up = length(view.up), axis = length(view.direction);
    if (!std::isfinite(length(view.location)))
        fail("location must be finite");
    if (!(right > 0 && up > 0 && axis > 0 && std::isfinite(right * up * axis)))
        fail("right, up and direction must be finite and not zero");
    if (!(std::fabs(dot(cross(view.right, view.up), view.direction)) > 1e-9 * right * up * axis))
        fail("right, up and direction must not lie in one plane");
}

/// k, scene units per mm. `film_width`: mm, without bleed.
double scale_of(const CameraParameters& p, const ViewFrame& view, double film_width)
{
    const double window = view.sheet_distance_ratio * length(view.right); // S, scene units
    const double k = p.film.units_per_mm.value_or(window / film_width);
    if (p.print_size && std::fabs(k - window / film_width) > 0.01 * k) {
        std::ostringstream text;
        text << "units_per_mm " << k << " and print_size <" << p.print_size->x << ", "
             << p.print_size->y << "> contradict each other: the camera's window in the sheet's "
             << "plane is " << window << " scene units wide, so that print_size alone makes "
             << "units_per_mm " << window / film_width << "; leave one of them out";
        fail(text.str());
    }
    return k;
}

/// mm from the scene's eye to the sheet, or its projected image, for k scene units per mm.
double scene_distance(const CameraParameters& p, const ViewFrame& view, double k)
{
    if (p.move_eye)
        return *p.viewing_distance;
    const double distance = scene_viewing_distance(view, k);
    if (!(distance >= 1e-2 && distance <= 1e9)) {
        std::ostringstream text;
        text << "the scene's eye is " << distance << " mm from the sheet (" << k
             << " scene units a mm); 0.01 to 1e9 mm is possible: change sheet_distance, angle or "
                "units_per_mm, or give viewing_distance and move_eye";
        fail(text.str());
    }
    return distance;
}

/// For eyes `scene` and `viewed` mm from the sheet. Empty if the two eyes always coincide.
std::optional<Parallax> parallax_of(const CameraParameters& p, double scene, double viewed)
{
    const Parallax parallax{p.parallax.value_or(scene / viewed), scene};
    if (parallax.factor == 1 && scene == viewed)
        return std::nullopt;
    return parallax;
}

/// `scale`: factor on the capture_aperture of the scene.
Aperture make_aperture(const CameraParameters& p, double distance, double scale)
{
    if (p.capture_aperture)
        return {distance, scale * p.capture_aperture->x, scale * p.capture_aperture->y,
                p.aperture_shape};
    Aperture aperture = *filling_aperture(modelled_sheet(p.sheet, p.model), distance);
    aperture.shape = p.aperture_shape;
    return aperture;
}

/// The aperture; with a projection lens, that lens. But a lenticular sheet's aperture fixes the
/// heights of the rays, so with a projection lens it is that lens's image of the viewer's aperture.
Aperture make_aperture(const CameraParameters& p, const std::optional<ProjectionLens>& projection,
                       double eye)
{
    if (!projection)
        return make_aperture(p, eye, 1);
    if (p.sheet.arrangement != Arrangement::lenticular)
        return make_aperture(p, projection->distance, 1);
    if (!(projection->eye_image_distance() >= 1e-2))
        fail(
            "the viewer's eye is so near to the projected image that the projection lens images it "
            "onto the sheet: give viewing_distance, or move the camera back");
    return make_aperture(p, projection->eye_image_distance(), projection->eye_scale());
}

/// `k`: scene units per mm.
Placement make_placement(const ViewFrame& view, double k)
{
    Placement placement;
    placement.x = (k / length(view.right)) * view.right;
    placement.y = (k / length(view.up)) * view.up;
    placement.z = (k / length(view.direction)) * view.direction;
    placement.origin = view.location + view.sheet_distance_ratio * view.direction;
    placement.units_per_mm = k;
    placement.sheet_distance = view.sheet_distance_ratio * length(view.direction);
    const double skew = std::max({std::fabs(dot(placement.x, placement.y)),
                                  std::fabs(dot(placement.y, placement.z)),
                                  std::fabs(dot(placement.z, placement.x))});
    placement.right_angled = skew <= 1e-14 * k * k;
    return placement;
}

} // namespace

double IntegralCamera::slit_height(Vec2 aperture_point) const
{
    const LensSheet& sheet = optics.sheet();
    const Aperture& aperture = optics.aperture();
    if (sheet.arrangement != Arrangement::lenticular)
        return 0;
    const Vec2 extent{aperture.width, aperture.height};
    const double height = extent_across_slit(sheet, extent);
    if (aperture.shape == ApertureShape::rectangle || height == 0)
        return height;
    const double along = 2 * extent_along_slit(sheet, aperture_point) /
                         extent_along_slit(sheet, extent); // -1..1 across the ellipse
    return height * std::sqrt(std::max(0.0, (1 - along) * (1 + along)));
}

Vec3 sheet_from_scene(const Placement& p, Vec3 point)
{
    const Vec3 v = point - p.origin;
    const double volume = dot(cross(p.x, p.y), p.z);
    return {dot(cross(p.y, p.z), v) / volume, dot(cross(p.z, p.x), v) / volume,
            dot(cross(p.x, p.y), v) / volume};
}

double scene_viewing_distance(const ViewFrame& view, double units_per_mm)
{
    return view.sheet_distance_ratio * length(view.direction) / units_per_mm;
}

IntegralCamera make_camera(const CameraParameters& p, const ViewFrame& view, int width, int height)
{
    const auto errors = find_errors(p);
    if (!errors.empty())
        fail(errors.front());
    if (width < 1 || height < 1)
        fail("the frame has no pixels");
    check_view(view);

    const Film film{width, height, p.film.pixel_pitch, p.film.subpixels, p.film.bleed};
    const std::string bleed = bleed_error(film);
    if (!bleed.empty())
        fail(bleed);
    std::optional<ProjectionLens> projection;
    if (p.projection_lens)
        projection = ProjectionLens{
            p.projection_lens->focal_length, p.projection_lens->distance,  0,
            int(p.projection_lens->columns), int(p.projection_lens->rows), {}};
    const double k = scale_of(
        p, view, (projection ? projection->magnification() : 1) * trimmed_size(film).x);
    const double scene = scene_distance(p, view, k), eye = p.viewing_distance.value_or(scene);
    const std::optional<Parallax> parallax = parallax_of(p, scene, eye);
    if (projection)
        projection->viewer = eye;
    const Aperture aperture = make_aperture(p, projection, eye);
    if (projection)
        projection->extent = {aperture.width, aperture.height};
    Placement placement = make_placement(view, k);
    placement.scale_is_given = p.film.units_per_mm.has_value();
    return {SheetOptics(p.sheet, aperture, p.model),
            film,
            placement,
            p.mapping,
            p.depth_range,
            p.pixel_samples.value_or(default_pixel_samples(p)),
            p.beam_samples.value_or(default_beam_samples(p)),
            p.pseudoscopic,
            p.display_prefilter,
            projection,
            parallax,
            parallax ? relief_of(*parallax, eye) : Collineation()};
}

double viewer_distance(const IntegralCamera& camera)
{
    return camera.projection ? camera.projection->viewer : camera.optics.aperture().distance;
}

/// Distance in front of the sheet at which sight lines start, mm. The viewer sees nothing behind
/// the eye, whatever the depth_range.
static double start_distance(const IntegralCamera& camera)
{
    const double eye = viewer_distance(camera);
    return camera.pseudoscopic  ? 0
           : camera.depth_range ? std::min(camera.depth_range->x, eye)
                                : eye;
}

/// The start and direction (any length) of the line of sight as the viewer sees it: in the sheet
/// frame, or with a projection lens in the frame of the sheet's image.
static Line seen_line(const IntegralCamera& camera, const BeamRay& ray)
{
    const Vec3 d = -1 * ray.direction;
    const double distance = camera.optics.aperture().distance, front = start_distance(camera);
    if (camera.projection) {
        const Vec3 in_plane = ray.point + (-ray.point.z / d.z) * d;
        const Vec2 from{in_plane.x, in_plane.y};
        const Vec2 on_lens = from +
                             (camera.projection->distance / distance) * (ray.aperture_point - from);
        const Line line = projected(*camera.projection, from, on_lens);
        const Vec3 way = (1 / length(line.direction)) * line.direction;
        return {line.origin + -front * line.direction, way};
    }
    if (front < distance)
        return {ray.point + (-(front + ray.point.z) / d.z) * d, d};
    return {{ray.aperture_point.x, ray.aperture_point.y, -distance}, d};
}

/// The line in the scene, of unit direction, that the viewer sees as `seen`.
static Line scene_line(const Collineation& relief, const Line& seen)
{
    Line line = preimage_of(relief, seen);
    line.origin = line.origin + *preimage_depth(relief, seen.origin.z) * line.direction;
    line.direction = (1 / length(line.direction)) * line.direction;
    return line;
}

Vec3 seen_from_scene(const IntegralCamera& camera, Vec3 scene_point)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Vec3 point = sheet_from_scene(camera.placement, scene_point);
    return camera.parallax ? image_of(camera.relief, point).value_or(Vec3{0, 0, infinity}) : point;
}

std::optional<Vec3> scene_from_seen(const IntegralCamera& camera, Vec3 seen)
{
    const auto point = preimage_of(camera.relief, seen);
    return point ? std::optional(scene_from_sheet(camera.placement, *point)) : std::nullopt;
}

SightLine sight_line(const IntegralCamera& camera, const BeamRay& ray)
{
    const Placement& at = camera.placement;
    const Line seen = seen_line(camera, ray),
               sight = camera.parallax ? scene_line(camera.relief, seen) : seen;
    const Vec3 d = sight.direction;
    SightLine line;
    line.origin = scene_from_sheet(at, sight.origin);
    const Vec3 direction = d.x * at.x + d.y * at.y + d.z * at.z;
    const double scale = at.right_angled ? at.units_per_mm : length(direction);
    line.direction = (1 / scale) * direction;
    if (camera.depth_range)
        if (const auto end = preimage_depth(camera.relief, camera.depth_range->y))
            line.length = scale *
                          (*end - *preimage_depth(camera.relief, -start_distance(camera))) / d.z;
    return line;
}

std::optional<StartRegion> start_region(const IntegralCamera& camera)
{
    const SheetOptics& optics = camera.optics;
    if (refracts_at_surface(optics.model()) || camera.display_prefilter || camera.projection)
        return std::nullopt;
    const Aperture& aperture = optics.aperture();
    const bool at_aperture = !camera.depth_range && !camera.pseudoscopic;
    // Anti-aliasing and audit sample the lens's cell, so a ray may lie a cell's radius to the side
    // of the pole ray. The other margins allow for rounding: a ray through the very edge counts.
    const double margin = cell_circumradius(optics.sheet()),
                 rounding = 1e-3 * optics.sheet().pitch;
    Vec2 half{0.5 * aperture.width, 0.5 * aperture.height};
    if (!at_aperture) { // between aperture and sheet a ray is within the larger of the two
        half.x = std::max(half.x, 0.5 * size_of(camera.film).x);
        half.y = std::max(half.y, 0.5 * size_of(camera.film).y);
        if (camera.pseudoscopic)
            half = half + Vec2{2 * optics.sheet().pitch, 2 * optics.sheet().pitch};
    }
    const Placement& at = camera.placement;
    // `scale`: the scene's eye moves less or more than the viewer's.
    const double z = *preimage_depth(camera.relief, -start_distance(camera)),
                 scale = 1 + camera.relief.bend * z;
    const Vec2 reach{scale * (1.0001 * half.x + margin) + rounding,
                     scale * (1.0001 * half.y + margin) + rounding};
    return StartRegion{scene_from_sheet(at, {0, 0, z}), reach.x * at.x, reach.y * at.y};
}

} // namespace integral
