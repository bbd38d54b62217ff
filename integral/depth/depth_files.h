// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes depth maps: as numbers, as coloured pictures and as points.
#ifndef INTEGRAL_DEPTH_DEPTH_FILES_H
#define INTEGRAL_DEPTH_DEPTH_FILES_H

#include "integral/depth/multibaseline.h"

#include <string>

namespace integral {

/// An upright depth map with square pixels, and the colours at its pixels; row by row from the top
/// left.
struct UprightMap {
    int width = 0, height = 0;
    double pixel = 1;                ///< mm on the sheet; 1 where millimetres are not known
    std::optional<DepthScale> scale; ///< nothing: only disparities are known
    std::vector<float> disparity;    ///< NaN: nothing is known here
    std::vector<float> confidence;   ///< 0 to 1
    ColourPlanes colour;             ///< stored values; 1 is full scale

    /// Millimetres behind the sheet, negative in front; or the disparities if no scale is known.
    std::vector<float> depths() const;
};

/// Resamples the map of a set's middle view on a rectangle of `width_mm` x `height_mm` about the
/// sheet's centre, with `columns` pixels across (0: about the view's number). Interpolates
/// depth linearly within a surface and takes the nearest pixel's across a step.
UprightMap upright_map(const ViewSet& views, const DepthMap& map, double width_mm, double height_mm,
                       int columns);

/// Range of a map's known disparities without the lowest and the highest 0.5%.
DisparityRange shown_range(const UprightMap& map);

/// Writes a map in the format of its name: .pfm (depths(), or disparities if `as_disparity`; NaN
/// where nothing is known), .exr (channels Z: depths(), Y: the values of a .pfm, A: 1 or 0 where
/// nothing is known, disparity, confidence), .png (coloured, with a scale), .ply (points in mm with
/// colours; x right, y up, z behind the sheet). Throws OutputError; std::invalid_argument if a .ply
/// is requested of a map without millimetres.
void write_depth(const std::string& path, const UprightMap& map, bool as_disparity = false);

/// Writes colours and, to their right, depths as greys: white at the near end of shown_range(),
/// black at the far end and where nothing is known. Equal steps of grey are equal steps of
/// parallax, as in rgbd_picture (views/rgbd.h). Returns the disparities of black and white. Throws
/// OutputError.
DisparityRange write_rgbd(const std::string& path, const UprightMap& map);

/// Whether write_depth supports the name's ending.
bool is_depth_file(const std::string& path);

} // namespace integral

#endif
