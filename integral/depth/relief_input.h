// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes reliefs from a frame, from views or from one photograph, with depth that is measured in
// them or given in a file.
#ifndef INTEGRAL_DEPTH_RELIEF_INPUT_H
#define INTEGRAL_DEPTH_RELIEF_INPUT_H

#include "integral/depth/depth_input.h"
#include "integral/depth/depth_quality.h"
#include "integral/depth/relief.h"
#include "integral/frame/picture_fit.h"

#include <functional>
#include <string>

namespace integral {

/// A nearest and a farthest depth, mm behind the sheet; of greys: of white and black.
struct DepthSpan {
    double near = 0, far = 0;
};

/// Depth that a picture brings along.
enum class OwnDepth {
    none,
    beside, ///< greys in its right half (RGBD)
    inside  ///< in its file, as phones store it (embedded_depth.h)
};

struct ReliefRequest {
    DepthRequest input;
    std::string depth_file;                    ///< "": depth is measured
    OwnDepth own = OwnDepth::none;             ///< of the one input; then depth_file is not used
    std::optional<DepthSpan> ends; ///< of greys: white and black; else of the nearest and farthest
                                   ///< twentieth of the depths
    double limit = 0; ///< mm behind the sheet, of the farthest depth of greys and pairs without
                      ///< `ends`; the nearest is as far in front, in parallax; 0: greys need `ends`
    int width = 0; ///< pixels that a photograph needs across: one that has at least twice as many
                   ///< is reduced; 0: all of them
    DepthQuality quality = DepthQuality::good; ///< of measuring
    Vec2 size;           ///< rectangle in the image plane that a photograph is fitted to, mm; its
                         ///< middle is in front of the photograph's eye
    double distance = 0; ///< of a photograph's eye from the image plane, mm
    Fit fit = Fit::contain; ///< of a photograph, and of a depth_file whose shape differs from the
                            ///< pictures'
    /// Takes notices about depths for the user, a line each.
    std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// Unit of a relief's depths.
enum class DepthUnit {
    mm,
    ends, ///< mm: greys of a view, which request.ends has placed
    none, ///< greys: a parallax from 0 (white) to 1 (black)
    pair  ///< measured in a pair: nine tenths have a parallax from 0 to 1
};

/// A relief, and the form of the pictures that it was made from.
struct ReliefInput {
    Relief relief;
    Image form;
    DepthUnit unit = DepthUnit::mm;
};

/// Reads the inputs as read_depth_input does; but one picture that is neither frame nor quilt is,
/// with a depth_file, or with depths beside it, a photograph; and two views without a record of
/// their eyes are a stereo pair, whose depth is put within the limit. The depth_file is a depth
/// frame (for a frame); a .pfm, or an .exr without a frame's geometry, of mm behind the sheet; or a
/// grey picture, in which equal steps are equal steps of parallax. Maps other than depth frames
/// cover the rectangle of the views and give depth for the middle view alone; depth frames and
/// measured depth also give it for the outermost eyes. Throws as read_depth_input does, and
/// std::invalid_argument if the depth_file does not fit, or if the views have no record of their
/// eyes: then their scale in mm is unknown.
ReliefInput read_relief(const std::vector<std::string>& inputs, const ReliefRequest& request,
                        int threads, const Progress& progress);

/// The same, before place().
ReliefInput read_unplaced_relief(const std::vector<std::string>& inputs,
                                 const ReliefRequest& request, int threads,
                                 const Progress& progress);

/// Moves the relief's depths to request.ends or, if they are not in mm, within request.limit, which
/// is reported to the user, on a picture of request.size that is seen from request.distance. Depths
/// in mm without request.ends stay as they are. Throws std::invalid_argument.
void place(ReliefInput& input, const std::string& name, const ReliefRequest& request);

/// Whether a file is one picture: no frame, also with the geometry in the file `sheet`, if that is
/// not "", and no views. Throws InputError.
bool is_plain_picture(const std::string& path, const std::string& sheet = "");

/// Whether inputs are the two views of a stereo pair, in one file (an MPO, a stereo OpenEXR) or
/// two, without a record of their eyes. Throws InputError.
bool is_pair_of_files(const std::vector<std::string>& inputs);

/// Measures the depth of an input that has been read, and makes its relief.
Relief measured_relief(const DepthInput& input, DepthQuality quality, int threads,
                       const Progress& progress);

} // namespace integral

#endif
