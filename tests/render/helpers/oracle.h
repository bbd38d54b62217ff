// SPDX-License-Identifier: AGPL-3.0-or-later
// The tests' own integral camera, written from optics.md alone, in long double and by brute force.
// It tries every lens within reach, and finds the slit's root by bisection. It shares no code with
// integral/optics.
#ifndef TESTS_RENDER_HELPERS_ORACLE_H
#define TESTS_RENDER_HELPERS_ORACLE_H

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace oracle {

using Real = long double;
using Point2 = std::array<Real, 2>;
using Point3 = std::array<Real, 3>;

/// A camera as the test's command line gives it. Lengths of sheet and aperture in mm, of the scene
/// in scene units.
struct Description {
    std::string arrangement = "lenticular", mapping = "auto", shape = "rectangle",
                model = "extended_pinhole", subpixels = "none";
    Real pitch = 1.27L, thickness = 3.08L, ior = 1.6L, slant = 0; ///< slant in degrees
    Point2 offset{0, 0}, dpi{300, 300};
    std::optional<Point2> pixel_pitch; ///< mm; instead of dpi
    int width = 160, height = 120;     ///< pixels
    std::optional<Point2> aperture;    ///< mm; default: fills a lens
    std::optional<Point2> depth_range; ///< mm; in the camera's text alone: the oracle's scene is
                                       ///< clipped instead
    std::optional<Real> sheet_distance, viewing_distance, parallax, units_per_mm, angle;
    bool move_eye = false;
    std::optional<Point3> look_at;
    std::string pattern = "same"; ///< of subpixels=cells,
    std::vector<Point2> places;   ///< and each cell's red, green, blue: pixels to the right and up
    Point3 location{0, 0, 0}, direction{0, 0, 1}, right{4 / 3.0L, 0, 0}, up{0, 1, 0}, sky{0, 1, 0};
    struct Transform {
        std::string kind;
        Point3 value;
    };
    std::vector<Transform> transforms;       ///< rotate, scale, translate in order
    int beam_samples = 0, pixel_samples = 1; ///< beam_samples 0: not given
    bool pseudoscopic = false, display_prefilter = false;

    // Keys for the oracle only:
    std::optional<Real> start; ///< mm before the sheet where its rays start; default: at the
                               ///< aperture
    int channel = 1;  ///< 0 red, 1 green, 2 blue: which of a pixel's film points, with subpixels
    int marginal = 0; ///< which of hybrid's 3 or 5 rays, the pole's first
    /// For tests in which the rays of groups of pixels start at different distances: a file with a
    /// number for every pixel, and the number of the pixels whose rays are made.
    std::string groups;
    int group = 0;
};

/// Reads "key=value" words. Throws std::invalid_argument at an unknown key.
Description read_description(const std::vector<std::string>& words);

/// The same camera in the scene language, for the renderer under test.
std::string camera_text(const Description& description);
/// An ordinary perspective camera with the same view.
std::string perspective_text(const Description& description);

/// The sheet's frame of reference in the scene.
struct Placed {
    Point3 location;     ///< the scene's eye
    Point3 x, y, z;      ///< one mm along the sheet frame's axes, in scene units
    Real distance;       ///< of the aperture, where the viewer's eye is, mm
    Real scene_distance; ///< of the scene's eye, mm
    Real parallax;       ///< mm that the scene's eye moves for 1 mm of the viewer's
};
Placed place(const Description& description);

/// A lens by its lattice indices; a lenticular sheet uses the first alone.
struct Lens {
    long first = 0, second = 0;
};

/// The ray of one film point through one lens, before any aperture: A on the aperture plane and the
/// direction from A into the scene, both in the sheet frame (mm; A's z is -d).
struct SheetRay {
    Lens lens;
    Point2 aperture_point;
    Point3 direction;
};

/// Section 8: the line in the scene for a line that the viewer sees. Its aperture_point is in the
/// plane of the scene's eye.
SheetRay in_scene(const Placed& placed, SheetRay ray);

/// Section 3, steps 1 to 4, by the pole; nothing if it is totally reflected.
std::optional<SheetRay> ray_through(const Description&, Real distance, Point2 film_point,
                                    Lens lens);

/// A point of a lens: offset from its pole (lenticular: across its axis), mm, and the height at
/// which the slit is passed, mm.
struct LensPoint {
    Point2 offset{0, 0};
    Real eta = 0;
};

/// The ray through any point of a lens, by the description's lens model: for hybrid and full
/// refracted at the curved surface, for the others the pole's ray moved sideways. Pseudoscopic: of
/// the film point on the pole's other side.
std::optional<SheetRay> beam_ray(const Description&, Real distance, Point2 film_point, Lens lens,
                                 const LensPoint& point);

/// The film point on the other side of the lens's pole (lenticular: of its axis), as far away.
Point2 mirrored_in_lens(const Description&, Point2 film_point, Lens lens);

/// The hybrid model's points of a lens and their weights, before anything is dropped.
std::vector<LensPoint> hybrid_points(const Description&);
std::vector<Real> hybrid_weights(const Description&);

/// Sections 3 and 4: the ray that the film point gets; nothing if it images nothing. `margin`
/// becomes the least relative distance of any decision taken (tie, aperture's edge) from the other
/// outcome, where that is less than it was.
std::optional<SheetRay> film_ray(const Description&, Real distance, Point2 film_point,
                                 Real& margin);

/// Numbers in [0, 1) that choose a sample: two for the pixel's area, two for the lens's cell (or,
/// with a slit, for the cell and the slit).
using Numbers = std::array<Real, 4>;

/// `count` rays of the pixel (i, j), chosen by the numbers from `next`, over all that the
/// description samples: the pixel's area with pixel_samples > 1, the lens's cell and the slit with
/// beam_samples > 1 or by default. Rays of another lens, of no lens, and totally reflected ones are
/// replaced by others. With the display prefilter the rays fill tents twice as wide, and may belong
/// to any lens. None where the pixel's centre images nothing.
std::vector<SheetRay> pixel_rays(const Description&, Real distance, int i, int j, int count,
                                 const std::function<Numbers()>& next);

/// Continuous pixel coordinates -> mm on the film, of the description's colour channel.
Point2 film_from_pixel(const Description&, Real px, Real py);

/// Section 5: full width and height, mm, of the given aperture or, by default, of the aperture that
/// fills a lens.
Point2 aperture_size(const Description&, Real distance);

} // namespace oracle

#endif
