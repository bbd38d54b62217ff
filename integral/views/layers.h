// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes a frame from flat pictures at distances behind and in front of the sheet: layered 3-D.
#ifndef INTEGRAL_VIEWS_LAYERS_H
#define INTEGRAL_VIEWS_LAYERS_H

#include "integral/base/parallel.h"
#include "integral/frame/frame_metadata.h"
#include "integral/frame/picture_fit.h"
#include "integral/views/frame_of_layers.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace integral {

constexpr double max_layer_distance = 1e6; // mm behind the sheet

/// A flat picture. Its size and place are measured on the sheet, as the eye
/// in the middle sees them there, so that another distance does not change the picture from there.
struct PictureLayer {
    std::string path;
    std::string name = "";      ///< that a painting program gave it; may be empty
    std::optional<int> picture; ///< index of the picture in a file of several; else the first
    int pictures = 0;           ///< number of pictures of that file that have layers
    double distance = 0; ///< mm behind the sheet, as depth frames have it; negative: in front
    /// Size, mm. If only one side is given, the other follows from the picture's shape; if neither
    /// is, the picture is fitted to the film.
    std::optional<double> width, height;
    Vec2 place; ///< of the picture's middle, mm from the film's: to the right, and upwards
    /// Angles by which the right side (turn) and the upper side (tilt) go back from the middle,
    /// which is at `distance`, in degrees, -89 to 89. Their tangents are the plane's slopes. The
    /// eye in the middle sees no difference.
    double turn = 0, tilt = 0;
};

struct LayersRequest {
    std::vector<PictureLayer> layers;
    std::string output;
    std::string depth_output; ///< the depth frame; empty: none is written
    FrameMetadata geometry;
    Fit fit = Fit::contain;   ///< of layers without a size; bars are transparent
    bool transparent = false; ///< keep alpha; else the layers stand on black
    std::optional<int> bits;  ///< 8, 16 or 32; nothing: the most bits of any picture
    int threads = 0;          ///< 0: one per core
    /// Takes notices for the user, a line each.
    std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// How sharp the sheet and film show a depth (depth_advice.h); unknown if they have no budget.
enum class LayerSharpness { sharp, soft, beyond, unknown };

/// Where a tilted layer begins and ends, mm behind the sheet.
struct LayerEnds {
    double nearest = 0, farthest = 0;
};

struct LayerFigures {
    std::string name;
    double distance = 0; ///< mm behind the sheet
    Vec2 size;           ///< at that distance, mm
    double shift = 0; ///< of the layer on the sheet while the eye crosses the viewing zone, mm; > 0
                      ///< in the direction of the eye
    LayerSharpness sharpness = LayerSharpness::unknown;
    std::optional<LayerEnds> tilted; ///< of a tilted layer
};

/// The farthest layer, if it fills the film for the eye in the middle but not for all eyes of the
/// viewing zone.
struct BareEdge {
    std::string name;
    double margin = 0; ///< mm of the film beside the layer, for an eye at the zone's edge
    double width = 0, height = 0; ///< of the layer, mm, with which it fills the film for all eyes
    bool stretched = false; ///< PictureLayer needs both; else its height follows from its width
};

struct LayersView {
    std::optional<double> budget; ///< mm on either side of the sheet (seen_budget)
    std::vector<LayerFigures> layers;
    std::optional<BareEdge> bare;
};

/// Writes the frame, and the depth frame if requested, and returns the figures. Throws
/// std::invalid_argument where the request makes no sense, InputError, OutputError, and Interrupted
/// where `progress` stops the work.
LayersView write_layers(const LayersRequest& request, const Progress& progress);

/// The figures for people: a line for each layer.
std::string layers_text(const LayersView& view);

/// The same as JSON.
std::string layers_json(const LayersView& view);

} // namespace integral

#endif
