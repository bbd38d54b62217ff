// SPDX-License-Identifier: AGPL-3.0-or-later
// A scene's probe: a few small pictures with depth, around the scene's own eye, from which the
// studio's page synthesises what is seen through any sheet.
#ifndef INTEGRAL_STUDIO_PROBE_H
#define INTEGRAL_STUDIO_PROBE_H

#include "integral/batch/renderer.h"
#include "integral/frame/depth_range.h"
#include "integral/frame/image.h"

#include <string>
#include <vector>

namespace integral {

/// How a probe is to be rendered.
struct ProbeRequest {
    int width = 160;     ///< of a view, pixels
    double aspect = 1;   ///< width / height of the print
    ViewGrid grid{1, 1}; ///< odd numbers, so that one view is the scene's own eye's
    Vec2 zone; ///< extent of the eyes' places, as a part of the sheet's width; > 0 with more than
               ///< one view

    int height() const; ///< of a view, pixels
    /// The number of the scene's own eye's view.
    std::size_t middle() const { return std::size_t(grid.count() / 2); }
};

/// The perspective picture from one eye, whose window is the sheet at Probe::sheet_distance.
struct ProbeView {
    Vec2 eye; ///< relative to the scene's eye, to the right and up, scene units
    std::vector<std::uint8_t> colours; ///< sRGB: red, green and blue of each pixel
    std::vector<float> nearness; ///< 1 / distance of the surface from the eye's plane, scene units;
                                 ///< 0: no surface
};

struct Probe {
    ProbeRequest request;
    int width = 0, height = 0;    ///< of each view, pixels
    double sheet_distance = 0;    ///< scene units from the scene's eye
    Vec2 window{1, 1}; ///< width and height of the part of the sheet, around its middle, that shows
                       ///< the scene; the rest stays black
    std::vector<ProbeView> views; ///< the scene's own eye first
    DepthFrame depths; ///< for figures: eye_distances and the metadata with the placement; no
                       ///< pixels
};

/// The probe that a frame needs: three views each way in which views differ, the outer ones at the
/// edges of the region from which the frame's rays see the scene. `frame`: with its placement and
/// parallax. `probe_distance`: Probe::sheet_distance.
ProbeRequest probe_for(const FrameMetadata& frame, double probe_distance);

/// Whether a probe serves where another one is required.
bool serves(const ProbeRequest& present, const ProbeRequest& required);

/// The words of povray-integral's command line that render a probe's pictures into `scratch`.
/// `options`: the user's further words. Throws InputError.
std::vector<std::string> probe_words(const std::string& scene,
                                     const std::vector<std::string>& options,
                                     const ProbeRequest& request, const ScratchFolder& scratch);

/// A view of a quilt. `depths`: the quilt's depth frame, as large as `picture`. Its metadata
/// contain the placement and the quilt record with eyes.
ProbeView probe_view(const Image& picture, const DepthFrame& depths, int view);

/// Reads the finished pictures. Throws InputError.
Probe read_probe(const ProbeRequest& request, const ScratchFolder& scratch);

/// The probe for the page's script: a line of JSON (width, height, sheet_distance, window, eyes: a
/// list of pairs), then for each view its colours, R, G and B, and its nearness as 32-bit floats.
/// Numbers have this machine's byte order, which is the browser's on the same machine. Spaces at
/// the end of the line make its length a multiple of four, and so does padding after the colours.
std::string probe_bytes(const Probe& probe);

/// A JSON document on one line, padded with spaces so that the line's length is a multiple of four.
std::string padded_line(std::string json);

} // namespace integral

#endif
