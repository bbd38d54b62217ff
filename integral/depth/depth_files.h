// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes depth maps: as numbers, as coloured pictures and as points.
#ifndef INTEGRAL_DEPTH_DEPTH_FILES_H
#define INTEGRAL_DEPTH_DEPTH_FILES_H

#include "integral/depth/multibaseline.h"

#include <string>

namespace integral {

/// A depth map that stands upright and has square pixels, and the colours that were seen there.
/// Row by row from the top left.
struct UprightMap {
    int width = 0, height = 0;
    double pixel = 1;                ///< mm on the sheet; 1 where millimetres are not known
    std::optional<DepthScale> scale; ///< nothing: disparities are all that is known
    std::vector<float> disparity;    ///< NaN: nothing is known here
    std::vector<float> confidence;   ///< 0 to 1
    ColourPlanes colour;             ///< stored values; 1 is full scale

    /// Millimetres behind the sheet, negative in front; or the disparities if no scale is known.
    std::vector<float> depths() const;
};

/// The map of a set's middle view on a rectangle of `width_mm` x `height_mm` about the sheet's
/// centre, with `columns` pixels across (0: about as many as the view has). Between pixels of one
/// surface it is linear; across a step it takes the nearest.
UprightMap upright_map(const ViewSet& views, const DepthMap& map, double width_mm, double height_mm,
                       int columns);

/// The disparities between which all but a hundredth of a map's pixels are.
DisparityRange shown_range(const UprightMap& map);

/// Writes a map by its name: .pfm (depths(); NaN where nothing is known), .exr (channels Z:
/// depths(), A: 1 or 0 where nothing is known, disparity, confidence), .png (coloured, with a
/// scale), .ply (points in mm with colours; x right, y up, z behind the sheet). Throws OutputError;
/// std::invalid_argument for points of a map without millimetres.
void write_depth(const std::string& path, const UprightMap& map);

/// Writes colours and, to their right, depths as greys: white at the near end of shown_range(),
/// black at the far one and where nothing is known, equal steps for equal steps of parallax, as
/// rgbd_picture (replay/rgbd.h) has them. Returns the disparities of black and white. Throws
/// OutputError.
DisparityRange write_rgbd(const std::string& path, const UprightMap& map);

/// Whether write_depth knows the name's ending.
bool is_depth_file(const std::string& path);

} // namespace integral

#endif
