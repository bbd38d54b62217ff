// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/camera.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace integral {

namespace {

/// Collects complaints of the form "pitch 0 must be ...".
class Complaints {
public:
    void require(bool holds, const char* what, double value, const char* legal)
    {
        if (holds)
            return;
        std::ostringstream text;
        text.precision(10);
        text << what << ' ' << value << " is out of range: " << legal;
        list.push_back(text.str());
    }
    std::vector<std::string> list;
};

bool in(double value, double least, double most) { return value >= least && value <= most; }

[[noreturn]] void fail(const std::string& message) { throw std::invalid_argument(message); }

} // namespace

// The ranges are those over which the optics are proven (optics.md section 7), a little widened.
std::vector<std::string> find_value_errors(const CameraParameters& p)
{
    Complaints c;
    c.require(in(p.sheet.pitch, 1e-4, 1e3), "pitch", p.sheet.pitch,
              "it is the width of a lens, 0.0001 to 1000 mm");
    c.require(in(p.sheet.thickness, 1e-6, 1e6), "thickness", p.sheet.thickness,
              "it is the distance from lens to film, 0.000001 to 1000000 mm");
    c.require(in(p.sheet.ior, 1, 4), "ior", p.sheet.ior,
              "it is the sheet's refractive index, 1 to 4");
    c.require(in(std::fabs(p.sheet.slant), 0, 89.99), "slant", p.sheet.slant,
              "it is in degrees, -89.99 to 89.99");
    for (const double offset : {p.sheet.offset.x, p.sheet.offset.y})
        c.require(in(std::fabs(offset), 0, 1e6), "offset", offset,
                  "it is in mm, at most 1000000 either way");
    for (const double pitch : {p.film.pixel_pitch.x, p.film.pixel_pitch.y})
        c.require(in(pitch, 1e-6, 1e4), "film pixel pitch", pitch,
                  "it is 0.000001 to 10000 mm (dpi = 25.4/pitch)");
    for (int cell = 0; cell < p.film.subpixels.number; ++cell)
        for (const Vec2 place : p.film.subpixels.cell[cell])
            for (const double part : {place.x, place.y})
                c.require(in(std::fabs(part), 0, 1), "place of a subpixel", part,
                          "it is in pixels from its pixel's centre, -1 to 1");
    if (p.film.units_per_mm)
        c.require(in(*p.film.units_per_mm, 1e-6, 1e6), "units_per_mm", *p.film.units_per_mm,
                  "it is in scene units, 0.000001 to 1000000");
    if (p.sheet_distance)
        c.require(in(*p.sheet_distance, 1e-9, 1e9), "sheet_distance", *p.sheet_distance,
                  "it is in scene units, greater than 0, at most 1e9");
    if (p.capture_aperture)
        for (const double extent : {p.capture_aperture->x, p.capture_aperture->y})
            c.require(in(extent, 0, 1e12), "capture_aperture", extent,
                      "its width and height are in mm, 0 to 1e12");
    const char* const samples = "it is a whole number of points, 1 to 65536";
    c.require(in(p.beam_samples.value_or(1), 1, 65536), "beam_samples", p.beam_samples.value_or(1),
              samples);
    c.require(in(p.pixel_samples.value_or(1), 1, 65536), "pixel_samples",
              p.pixel_samples.value_or(1), samples);
    if (p.depth_range) {
        for (const double depth : {p.depth_range->x, p.depth_range->y})
            c.require(in(depth, 0, 1e12), "depth_range", depth,
                      "front and back are in mm, positive");
        if (p.depth_range->x == 0 && p.depth_range->y == 0)
            c.list.push_back("depth_range <0, 0> leaves nothing to be seen: one of front and back "
                             "must be greater than 0");
    }
    return c.list;
}

namespace {

/// Extents of a lenticular sheet's aperture along its slit and across it.
double along_slit(const LensSheet& sheet, Vec2 extent)
{
    return slit_is_horizontal(sheet) ? extent.x : extent.y;
}
double across_slit(const LensSheet& sheet, Vec2 extent)
{
    return slit_is_horizontal(sheet) ? extent.y : extent.x;
}

/// What is wrong with a capture aperture for this sheet; empty: nothing.
std::string aperture_error(const LensSheet& sheet, Vec2 extent)
{
    if (sheet.arrangement == Arrangement::lenticular) {
        if (along_slit(sheet, extent) > 0)
            return "";
        return slit_is_horizontal(sheet)
                   ? "the capture aperture of a lenticular sheet needs a width greater than 0: it "
                     "is "
                     "capture_aperture <width, slit height>"
                   : "the capture aperture of a lenticular sheet slanted by more than 45 degrees "
                     "needs a "
                     "height greater than 0: it is capture_aperture <slit width, height>";
    }
    return extent.x > 0 && extent.y > 0 ? ""
                                        : "capture_aperture needs a width and a height greater "
                                          "than 0: nothing would be imaged";
}

} // namespace

std::vector<std::string> find_errors(const CameraParameters& p)
{
    auto errors = find_value_errors(p);
    if (!errors.empty())
        return errors;
    if (refracts_at_surface(p.model) && !has_surface(p.sheet)) {
        std::ostringstream text;
        text << "lens_model " << (p.model == LensModel::hybrid ? "hybrid" : "full")
             << " needs lenses whose surface reaches their edge: "
             << "its radius, thickness*(ior - 1)/ior = " << surface_radius(p.sheet)
             << " mm, must be at least " << cell_circumradius(p.sheet)
             << " mm; lens_model extended_pinhole has no such limit";
        errors.push_back(text.str());
    }
    constexpr double most_rays = 1 << 20;
    if (double(p.pixel_samples.value_or(default_pixel_samples(p))) *
            p.beam_samples.value_or(default_beam_samples(p)) >
        most_rays)
        errors.push_back("pixel_samples times beam_samples are more than 1048576 rays a pixel: no "
                         "computer has the time for that");
    if (p.model == LensModel::hybrid && p.beam_samples)
        errors.push_back("beam_samples does not go with lens_model hybrid, which has 3 or 5 rays "
                         "of its own; lens_model full has as "
                         "many as beam_samples says");
    if (p.display_prefilter && refracts_at_surface(p.model))
        errors.push_back("display_prefilter is a filter of the ideal beam: it goes with lens_model "
                         "extended_pinhole or pinhole");
    if (!p.capture_aperture && !filling_aperture(modelled_sheet(p.sheet, p.model), 1))
        errors.push_back(
            "no aperture, however wide, fills these lenses (they are too wide for their thickness "
            "and ior): give capture_aperture <width, height> in mm");
    if (p.capture_aperture) {
        const std::string error = aperture_error(p.sheet, *p.capture_aperture);
        if (!error.empty())
            errors.push_back(error);
    }
    return errors;
}

int default_beam_samples(const CameraParameters& p)
{
    const bool slit_has_height = p.sheet.arrangement == Arrangement::lenticular &&
                                 p.capture_aperture &&
                                 across_slit(p.sheet, *p.capture_aperture) > 0;
    return p.model == LensModel::full || (slit_has_height && p.model != LensModel::hybrid) ? 16
           : p.display_prefilter                                                           ? 4
                                                                                           : 1;
}

int default_pixel_samples(const CameraParameters& p) { return p.display_prefilter ? 4 : 1; }

double IntegralCamera::slit_height(Vec2 aperture_point) const
{
    const LensSheet& sheet = optics.sheet();
    const Aperture& aperture = optics.aperture();
    if (sheet.arrangement != Arrangement::lenticular)
        return 0;
    const Vec2 extent{aperture.width, aperture.height};
    const double height = across_slit(sheet, extent);
    if (aperture.shape == ApertureShape::rectangle || height == 0)
        return height;
    const double along = 2 * along_slit(sheet, aperture_point) /
                         along_slit(sheet, extent); // -1..1 across the ellipse
    return height * std::sqrt(std::max(0.0, (1 - along) * (1 + along)));
}

Vec3 sheet_from_scene(const Placement& p, Vec3 point)
{
    const Vec3 v = point - p.origin;
    const double volume = dot(cross(p.x, p.y), p.z);
    return {dot(cross(p.y, p.z), v) / volume, dot(cross(p.z, p.x), v) / volume,
            dot(cross(p.x, p.y), v) / volume};
}

IntegralCamera make_camera(const CameraParameters& p, const ViewFrame& view, int width, int height)
{
    const auto errors = find_errors(p);
    if (!errors.empty())
        fail(errors.front());
    if (width < 1 || height < 1)
        fail("the frame has no pixels");

    const double right = length(view.right), up = length(view.up), axis = length(view.direction);
    if (!std::isfinite(length(view.location)))
        fail("location must be finite");
    if (!(right > 0 && up > 0 && axis > 0 && std::isfinite(right * up * axis)))
        fail("right, up and direction must be finite and not zero");
    if (!(std::fabs(dot(cross(view.right, view.up), view.direction)) > 1e-9 * right * up * axis))
        fail("right, up and direction must not lie in one plane");
    const Film film{width, height, p.film.pixel_pitch, p.film.subpixels};
    const double sheet_distance = view.sheet_distance_ratio * axis; // D, scene units
    const double window = view.sheet_distance_ratio * right;        // S, scene units
    const double k = p.film.units_per_mm ? *p.film.units_per_mm
                                         : window / (width * film.pixel_pitch.x);
    const double distance = sheet_distance / k; // d, mm
    if (!in(distance, 1e-2, 1e9)) {
        std::ostringstream text;
        text << "the viewer is " << distance << " mm from the sheet (" << k
             << " scene units a mm); 0.01 to 1e9 mm is possible: change sheet_distance, angle or "
                "units_per_mm";
        fail(text.str());
    }

    Aperture aperture;
    if (p.capture_aperture)
        aperture = {distance, p.capture_aperture->x, p.capture_aperture->y, p.aperture_shape};
    else {
        aperture = *filling_aperture(modelled_sheet(p.sheet, p.model), distance);
        aperture.shape = p.aperture_shape;
    }

    Placement placement;
    placement.x = (k / right) * view.right;
    placement.y = (k / up) * view.up;
    placement.z = (k / axis) * view.direction;
    placement.origin = view.location + view.sheet_distance_ratio * view.direction;
    placement.units_per_mm = k;
    const double skew = std::max({std::fabs(dot(placement.x, placement.y)),
                                  std::fabs(dot(placement.y, placement.z)),
                                  std::fabs(dot(placement.z, placement.x))});
    placement.right_angled = skew <= 1e-14 * k * k;
    return {SheetOptics(p.sheet, aperture, p.model),
            film,
            placement,
            p.mapping,
            p.depth_range,
            p.pixel_samples.value_or(default_pixel_samples(p)),
            p.beam_samples.value_or(default_beam_samples(p)),
            p.pseudoscopic,
            p.display_prefilter};
}

SightLine sight_line(const IntegralCamera& camera, const BeamRay& ray)
{
    const Placement& at = camera.placement;
    const Vec3 d = -1 * ray.direction; // into the scene
    SightLine line;
    // the viewer does not see what is behind the eye, however far depth_range reaches
    const double distance = camera.optics.aperture().distance;
    const double front = camera.pseudoscopic  ? 0
                         : camera.depth_range ? std::min(camera.depth_range->x, distance)
                                              : distance;
    const Vec3 start = front < distance
                           ? ray.point + (-(front + ray.point.z) / d.z) * d
                           : Vec3{ray.aperture_point.x, ray.aperture_point.y, -distance};
    line.origin = scene_from_sheet(at, start);
    const Vec3 direction = d.x * at.x + d.y * at.y + d.z * at.z;
    const double scale = at.right_angled ? at.units_per_mm : length(direction);
    line.direction = (1 / scale) * direction;
    if (camera.depth_range)
        line.length = scale * (front + camera.depth_range->y) / d.z;
    return line;
}

std::optional<StartRegion> start_region(const IntegralCamera& camera)
{
    const SheetOptics& optics = camera.optics;
    if (refracts_at_surface(optics.model()) || camera.display_prefilter)
        return std::nullopt;
    const Aperture& aperture = optics.aperture();
    const bool at_aperture = !camera.depth_range && !camera.pseudoscopic;
    const double front = at_aperture           ? aperture.distance
                         : camera.pseudoscopic ? 0
                                               : std::min(camera.depth_range->x, aperture.distance);
    // a beam is as wide as its lens, whose cell anti-aliasing and audit sample; and the edge of an
    // aperture belongs to it
    const double margin = cell_circumradius(optics.sheet()) + 1e-3 * optics.sheet().pitch;
    Vec2 half{0.5 * aperture.width, 0.5 * aperture.height};
    if (!at_aperture) { // a ray's film point, pole and aperture point follow each other along x and
                        // along y
        half.x = std::max(half.x, 0.5 * camera.film.width * camera.film.pixel_pitch.x);
        half.y = std::max(half.y, 0.5 * camera.film.height * camera.film.pixel_pitch.y);
        if (camera.pseudoscopic)
            half = half + Vec2{2 * optics.sheet().pitch, 2 * optics.sheet().pitch};
    }
    const Placement& at = camera.placement;
    return StartRegion{scene_from_sheet(at, {0, 0, -front}), (1.0001 * half.x + margin) * at.x,
                       (1.0001 * half.y + margin) * at.y};
}

Vec2 mirrored_in_lens(const SheetOptics& optics, Vec2 film_point, LensIndex lens)
{
    const Vec2 offset = optics.lattice().pole(lens) - film_point;
    if (optics.sheet().arrangement != Arrangement::lenticular)
        return film_point + 2 * offset;
    const Vec2 across = optics.lattice().across();
    return film_point + (2 * dot(across, offset)) * across;
}

Coverage coverage(const IntegralCamera& camera, int samples)
{
    // An even sample: every step-th pixel of the film, on a rank-1 lattice so that it does not
    // fall into step with the lenses.
    const Film& film = camera.film;
    const double pixels = double(film.width) * film.height;
    const int count = static_cast<int>(std::min<double>(pixels, std::max(samples, 1)));
    constexpr double golden = 0.61803398874989484820;
    Coverage result;
    for (int k = 0; k < count; ++k) {
        double x, y;
        if (count == pixels) {
            x = k % film.width;
            y = k / film.width;
        } else {
            const double turn = k * golden;
            x = std::floor((turn - std::floor(turn)) * film.width);
            y = std::floor((k + 0.5) / count * film.height);
        }
        const MappedPoint mapped = camera.optics.map(film_from_pixel(film, {x + 0.5, y + 0.5}),
                                                     camera.mapping);
        result.imaged += mapped.ray.has_value();
        result.outside_aperture += mapped.empty == Empty::outside_aperture;
        result.total_reflection += mapped.empty == Empty::total_reflection;
        result.searched += mapped.ray.has_value() && mapped.searched;
    }
    for (double* share :
         {&result.imaged, &result.outside_aperture, &result.total_reflection, &result.searched})
        *share /= count;
    return result;
}

} // namespace integral
