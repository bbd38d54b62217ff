// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes the best possible frame of a sheet and film without the integral camera, from an array
// of perspective cameras.
#ifndef INTEGRAL_BENCH_CAMERA_ARRAY_H
#define INTEGRAL_BENCH_CAMERA_ARRAY_H

#include "bench/renderer.h"
#include "bench/views.h"

#include "integral/optics/lens_mapping.h"

#include <functional>

namespace integral::bench {

/// A grid of perspective cameras that fills a rectangle of `width` x `height` about the aperture's
/// centre (see eye_grid). The sheet is the image plane of each.
struct CameraArray {
    int columns, rows;
    double width, height;                  ///< mm
    int picture_width, picture_height;     ///< pixels, one ray each; the aspect ratio is the film's
    std::vector<EyePosition> eyes() const; ///< the cameras' positions
};

/// Renders the cameras' pictures as animations. Several renderers run at the same time, because a
/// renderer is mostly idle between pictures. Calls `see` with each picture and its number in
/// eyes(); calls never overlap.
void render(const Renderer& renderer, const std::string& scene,
            const std::vector<std::string>& options, const CameraArray& array,
            const std::function<void(const Image&, int)>& see);

/// A film on which the pixels of perspective pictures are collected. A picture's pixel is a ray
/// through a point of the sheet; the lens at that point images the ray at a film point
/// (SheetOptics::film_point_seen). The colour of a film pixel is the mean, in linear light, of all
/// rays that reach it. With many eyes in the aperture and many rays for each lens, that is the mean
/// over the pixel's area and its lens's cell.
class GatheredFrame {
public:
    explicit GatheredFrame(const Frame& like); ///< has the geometry of `like`, which has metadata
    void add(const Image& picture, const EyePosition& eye);
    Frame frame() const;    ///< a pixel that no ray reached is black
    double missing() const; ///< fraction of the pixels not black in `like` that no ray reached
    double rays_a_pixel() const; ///< mean over the pixels that a ray reached

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
