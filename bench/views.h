// SPDX-License-Identifier: AGPL-3.0-or-later
// Views of a frame from an eye, and the scene's perspective pictures from the same eye.
#ifndef INTEGRAL_BENCH_VIEWS_H
#define INTEGRAL_BENCH_VIEWS_H

#include "integral/lightfield/frame.h"

#include <optional>
#include <string>
#include <vector>

namespace integral::bench {

struct Renderer;

/// The views' pixels.
struct ViewForm {
    int film_pixels; ///< of a film of dots_per_inch to a view's pixel, across and down; as many mm
                     ///< of a coarser film
    int margin; ///< view pixels left out all round: through the outermost lenses the eye looks past
                ///< the film's edge
    int samples; ///< across a pixel and down it
};

// A view's pixel is 5 of the film's across and down, 2.7 (square) or 3 (lenticular) to a lens:
// finer than the lenses, so that what they blur is seen, and coarse enough that its 5 x 5 samples
// leave no error of their own.
constexpr ViewForm usual_form{5, 3, 5};
constexpr int perspective_times = 3; // the perspective picture's pixels to one of the film's: 15 to
                                     // such a view's

/// An eye in the aperture, mm from its centre.
struct EyePosition {
    double x = 0, y = 0;
};

constexpr double zone = 0.8; // of the aperture: what the eyes are spread over

bool shows_a_row(const Frame& frame); ///< lenticular: nothing new along the cylinders

/// across x across eyes over the zone, row by row from the top left; behind cylinders as many in
/// one row.
std::vector<EyePosition> eyes_of(const Frame& frame, int across);

/// A picture without its margin.
Frame inner_part(const Image& image, const ViewForm& form);

/// The replayed view of a frame from that eye.
Frame view_of(const Frame& frame, const EyePosition& eye, const ViewForm& form);

/// The scene's perspective picture, from the eye if one is given, as coarse as a view and without
/// its margin. It is rendered with `times` pixels to one of the film's.
Frame perspective_of(const Renderer& renderer, const std::string& scene, const std::string& name,
                     const std::optional<EyePosition>& eye, std::vector<std::string> options,
                     int times, const ViewForm& form);

/// The similarity of a replayed view to another picture of what that eye should see.
struct ViewFigures {
    double psnr = 0, ssim = 0; ///< dB; -1 to 1
};

ViewFigures view_figures(const Frame& view, const Frame& wanted);
ViewFigures mean(const std::vector<ViewFigures>& views);
ViewFigures least(const std::vector<ViewFigures>& views);
ViewFigures greatest(const std::vector<ViewFigures>& views);

/// Root mean square difference of the colours, over the pixels that the first frame's setting
/// lights.
double lit_rmse(const Frame& frame, const Frame& reference);

} // namespace integral::bench

#endif
