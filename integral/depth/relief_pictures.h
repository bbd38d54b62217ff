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

/// Parallax of a grey picture's pixels. Throws std::invalid_argument if the picture has colours, or
/// white or black is behind the eye.
std::vector<float> parallax_of_greys(const Image& picture, const GreyDepths& grey, double distance);

/// z / (distance + z): 1 at infinity, NaN for a point that is not in front of the eye.
float parallax_of(double mm, double distance);

/// The depths for white and black that the request gives, or that its limit implies; the latter are
/// reported to the user. `white`, `black`: their names in that message.
GreyDepths grey_depths(const std::string& path, const std::string& white, const std::string& black,
                       const ReliefRequest& request);

/// Reads a picture with the depth that request.own describes. Throws InputError, and
/// std::invalid_argument if there is no such depth.
ReliefInput read_own_depth(const std::string& path, const ReliefRequest& request, int threads);

/// Makes a relief of a pair of views, and reports its depth to the user. Nine tenths of it lie
/// within request.grey or, without it, within request.limit. Throws std::invalid_argument,
/// Interrupted.
ReliefInput relief_of_pair(const std::string& name, Image left, Image right,
                           const ReliefRequest& request, int threads, const Progress& progress);

} // namespace integral

#endif
