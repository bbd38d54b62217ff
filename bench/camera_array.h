// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes the best possible frame of a sheet and film without the integral camera, from an array
// of perspective cameras.
#ifndef INTEGRAL_BENCH_CAMERA_ARRAY_H
#define INTEGRAL_BENCH_CAMERA_ARRAY_H

#include "bench/error_against_time.h"

#include "integral/optics/lens_mapping.h"

namespace integral::bench {

/// Cameras at the positions of eye_grid about the aperture's centre, with the sheet as image plane.
struct CameraArray {
    int columns, rows;
    double width, height;              ///< mm
    int picture_width, picture_height; ///< pixels, one ray each; of the film's shape
    std::vector<EyePosition> eyes() const;
};

/// Renders their pictures as animations, with several renderers at the same time because a renderer
/// is mostly idle between pictures. `see` is called with each picture and its number in eyes(),
/// never by two threads at once.
void render(const Renderer& renderer, const std::string& scene,
            const std::vector<std::string>& options, const CameraArray& array,
            const std::function<void(const Image&, int)>& see);

/// Collects light on a film; each pixel is the mean of its light (linear). A picture's pixel is a
/// ray through a point of the sheet, and the lens there images it at a film point
/// (SheetOptics::film_point_seen). With eyes all over the aperture and rays all over the lenses,
/// each pixel becomes the mean over its area and its lens's cell.
class GatheredFrame {
public:
    explicit GatheredFrame(const Frame& like); ///< a frame of that geometry, which has metadata
    void add(const Image& picture, const EyePosition& eye);
    Frame frame() const;    ///< black where nothing fell
    double missing() const; ///< of the pixels that are not black in `like`, the fraction on which
                            ///< nothing fell
    double rays_a_pixel() const; ///< mean over those on which some fell

private:
    struct Light {
        double r = 0, g = 0, b = 0;
        int rays = 0;
    };
    Frame like_;
    SheetOptics optics_;
    std::vector<Light> film_; ///< row by row
};

} // namespace integral::bench

#endif
