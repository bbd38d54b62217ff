// SPDX-License-Identifier: AGPL-3.0-or-later
// An array of perspective cameras before a scene, and the frame that their light makes: what the
// best possible render of a sheet and film would be, found without the integral camera.
#ifndef INTEGRAL_BENCH_CAMERA_ARRAY_H
#define INTEGRAL_BENCH_CAMERA_ARRAY_H

#include "bench/error_against_time.h"

#include "integral/optics/lens_mapping.h"

namespace integral::bench {

/// Cameras at eye_grid's places about the aperture's centre, their windows laid on the sheet.
struct CameraArray {
    int columns, rows;
    double width, height;              ///< mm
    int picture_width, picture_height; ///< pixels, one ray each; of the film's shape
    std::vector<EyePosition> eyes() const;
};

/// Their pictures in the order of eyes(), as animations of several renderers at once (a renderer
/// mostly waits between pictures). `see` is called from one thread with each picture and its
/// number.
void render(const Renderer& renderer, const std::string& scene,
            const std::vector<std::string>& options, const CameraArray& array,
            const std::function<void(const Image&, int)>& see);

/// Light gathered on a film: each pixel is the mean (linear) of what fell on it. A picture's pixel
/// is a ray that crosses the sheet there; the lens that it meets sends it to its place on the film
/// (SheetOptics::film_point_seen). So with eyes all over the aperture and rays all over the lenses
/// each pixel is the mean over its area and its lens's cell.
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
