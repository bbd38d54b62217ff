// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes reliefs from pictures that do not state their depths in millimetres: pictures with greys
// for depths, and stereo pairs.
#ifndef INTEGRAL_DEPTH_RELIEF_PICTURES_H
#define INTEGRAL_DEPTH_RELIEF_PICTURES_H

#include "integral/depth/relief_input.h"

namespace integral {

/// The part of a picture's rectangle that its pixels cover after a reduction (averaged.h).
struct PictureRaster {
    Vec2 size;                  ///< of the whole picture, mm
    double pixel = 1;           ///< side of a pixel of the whole picture, mm
    int factor = 1;             ///< of the reduction
    PixelPlaces places() const; ///< of the reduced picture's pixels
};

/// Places of the pixels of a map that covers a centred rectangle of that size, mm.
PixelPlaces places_over(Vec2 size, int width, int height);

/// The raster of a picture that fits request.size as request.fit says; stretch is as contain.
PictureRaster raster_of(const Image& picture, const ReliefRequest& request);

/// The light of a picture from an eye in the middle, reduced as the request says.
ReliefPicture relief_picture(const Image& picture, const PictureRaster& raster, int threads);

/// A grey picture's pixels as parallax from 0 (white) to 1 (black), which Relief::move() places.
/// Throws std::invalid_argument if the picture has colours.
std::vector<float> parallax_of_greys(const Image& picture);

/// z / (distance + z): 1 at infinity, NaN for a point that is not in front of the eye.
float parallax_of(double mm, double distance);

/// The parallax of the nearest and farthest depth (greys: of white and black) that the request
/// gives, or that its limit implies, which is reported to the user for the depths in `path`.
/// `distance`: from the eye to the image plane, mm. Throws std::invalid_argument if one of them is
/// behind the eye, or if neither is given.
ParallaxSpan requested_span(const std::string& path, const ReliefRequest& request, double distance);

/// Reads a picture with the depth that request.own describes, as greys. Throws InputError, and
/// std::invalid_argument if there is no such depth.
ReliefInput read_own_depth(const std::string& path, const ReliefRequest& request, int threads);

/// Makes a relief of a pair of views: nine tenths of it have a parallax from 0 to 1. Reports a poor
/// match to the user. Throws std::invalid_argument, Interrupted.
ReliefInput relief_of_pair(const std::string& name, Image left, Image right,
                           const ReliefRequest& request, int threads, const Progress& progress);

} // namespace integral

#endif
