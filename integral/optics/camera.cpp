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
    c.require(in(p.sheet.pitch, 1e-4, 1e3), "pitch", p.sheet.pitch, "it is the width of a lens, 0.0001 to 1000 mm");
    c.require(in(p.sheet.thickness, 1e-6, 1e6), "thickness", p.sheet.thickness,
              "it is the distance from lens to film, 0.000001 to 1000000 mm");
    c.require(in(p.sheet.ior, 1, 4), "ior", p.sheet.ior, "it is the sheet's refractive index, 1 to 4");
    c.require(in(std::fabs(p.sheet.slant), 0, 89.99), "slant", p.sheet.slant, "it is in degrees, -89.99 to 89.99");
    for (const double offset : {p.sheet.offset.x, p.sheet.offset.y})
        c.require(in(std::fabs(offset), 0, 1e6), "offset", offset, "it is in mm, at most 1000000 either way");
    for (const double pitch : {p.film.pixel_pitch.x, p.film.pixel_pitch.y})
        c.require(in(pitch, 1e-6, 1e4), "film pixel pitch", pitch, "it is 0.000001 to 10000 mm (dpi = 25.4/pitch)");
    if (p.film.units_per_mm)
        c.require(in(*p.film.units_per_mm, 1e-6, 1e6), "units_per_mm", *p.film.units_per_mm,
                  "it is in scene units, 0.000001 to 1000000");
    if (p.sheet_distance)
        c.require(in(*p.sheet_distance, 1e-9, 1e9), "sheet_distance", *p.sheet_distance,
                  "it is in scene units, greater than 0, at most 1e9");
    if (p.capture_aperture)
        for (const double extent : {p.capture_aperture->x, p.capture_aperture->y})
            c.require(in(extent, 0, 1e12), "capture_aperture", extent, "its width and height are in mm, 0 to 1e12");
    if (p.depth_range) {
        for (const double depth : {p.depth_range->x, p.depth_range->y})
            c.require(in(depth, 0, 1e12), "depth_range", depth, "front and back are in mm, positive");
        if (p.depth_range->x == 0 && p.depth_range->y == 0)
            c.list.push_back("depth_range <0, 0> leaves nothing to be seen: one of front and back must be greater than 0");
    }
    return c.list;
}

std::vector<std::string> find_errors(const CameraParameters& p)
{
    auto errors = find_value_errors(p);
    if (errors.empty() && !p.capture_aperture && !filling_aperture(p.sheet, 1))
        errors.push_back("no aperture, however wide, fills these lenses (they are too wide for their thickness "
                         "and ior): give capture_aperture <width, height> in mm");
    if (errors.empty() && p.capture_aperture) {
        const Vec2 extent = *p.capture_aperture;
        if (p.sheet.arrangement != Arrangement::lenticular) {
            if (!(extent.x > 0 && extent.y > 0))
                errors.push_back("capture_aperture needs a width and a height greater than 0: nothing would be imaged");
        } else {
            const bool horizontal = slit_is_horizontal(p.sheet);
            const double along = horizontal ? extent.x : extent.y, across = horizontal ? extent.y : extent.x;
            if (!(along > 0) || across != 0)
                errors.push_back(horizontal
                    ? "the capture aperture of a lenticular sheet is a slit without height: capture_aperture <width, 0>, width greater than 0"
                    : "the capture aperture of a lenticular sheet slanted by more than 45 degrees is a slit without width: "
                      "capture_aperture <0, height>, height greater than 0");
        }
    }
    return errors;
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
    const Film film{width, height, p.film.pixel_pitch};
    const double sheet_distance = view.sheet_distance_ratio * axis; // D, scene units
    const double window = view.sheet_distance_ratio * right;        // S, scene units
    const double k = p.film.units_per_mm ? *p.film.units_per_mm : window / (width * film.pixel_pitch.x);
    const double distance = sheet_distance / k;                     // d, mm
    if (!in(distance, 1e-2, 1e9)) {
        std::ostringstream text;
        text << "the viewer is " << distance << " mm from the sheet (" << k
             << " scene units a mm); 0.01 to 1e9 mm is possible: change sheet_distance, angle or units_per_mm";
        fail(text.str());
    }

    Aperture aperture;
    if (p.capture_aperture)
        aperture = {distance, p.capture_aperture->x, p.capture_aperture->y, p.aperture_shape};
    else {
        aperture = *filling_aperture(p.sheet, distance);
        aperture.shape = p.aperture_shape;
    }

    Placement placement;
    placement.x = (k / right) * view.right;
    placement.y = (k / up) * view.up;
    placement.z = (k / axis) * view.direction;
    placement.origin = view.location + view.sheet_distance_ratio * view.direction;
    placement.units_per_mm = k;
    return {SheetOptics(p.sheet, aperture), film, placement, p.mapping, p.depth_range};
}

SightLine sight_line(const IntegralCamera& camera, const LensRay& ray)
{
    const Placement& at = camera.placement;
    const Vec3 d = -1 * ray.direction; // into the scene
    SightLine line;
    // the viewer does not see what is behind the eye, however far depth_range reaches
    const double distance = camera.optics.aperture().distance;
    const double front = camera.depth_range ? std::min(camera.depth_range->x, distance) : distance;
    const Vec3 start = front < distance ? Vec3{ray.pole.x, ray.pole.y, 0} + (-front / d.z) * d
                                        : Vec3{ray.aperture_point.x, ray.aperture_point.y, -distance};
    line.origin = scene_from_sheet(at, start);
    const Vec3 direction = d.x * at.x + d.y * at.y + d.z * at.z;
    const double scale = length(direction);
    line.direction = (1 / scale) * direction;
    if (camera.depth_range)
        line.length = scale * (front + camera.depth_range->y) / d.z;
    return line;
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
        const MappedPoint mapped = camera.optics.map(film_from_pixel(film, {x + 0.5, y + 0.5}), camera.mapping);
        result.imaged += mapped.ray.has_value();
        result.outside_aperture += mapped.empty == Empty::outside_aperture;
        result.total_reflection += mapped.empty == Empty::total_reflection;
        result.searched += mapped.ray.has_value() && mapped.searched;
    }
    for (double* share : {&result.imaged, &result.outside_aperture, &result.total_reflection, &result.searched})
        *share /= count;
    return result;
}

} // namespace integral
