// SPDX-License-Identifier: AGPL-3.0-or-later
// Replays a frame's view from an eye, and renders the scene's perspective picture from there.
#ifndef INTEGRAL_BENCH_VIEWS_H
#define INTEGRAL_BENCH_VIEWS_H

#include "integral/frame/frame.h"

#include <optional>
#include <string>
#include <vector>

namespace integral::bench {

struct Renderer;

/// The size and the sampling of the views' pixels.
struct ViewForm {
    int film_pixels; ///< a view's pixel is as wide and high as this many film pixels at
                     ///< dots_per_inch
    int margin;  ///< view pixels cut off on every side, because an eye looks past the film's edge
                 ///< through the outermost lenses
    int samples; ///< per pixel, in each direction
};

// A view's pixel is 5 film pixels wide and high, so that a lens has 2.7 (square) or 3 (lenticular)
// of them across. That is fine enough to show the blur of the lenses, and coarse enough for 5 x 5
// samples to leave no visible error of their own.
constexpr ViewForm usual_form{5, 3, 5};
// Pixels of the perspective picture for one of the film, in each direction: 15 for one of a view.
constexpr int perspective_times = 3;

/// An eye in the aperture, mm from its centre.
struct EyePosition {
    double x = 0, y = 0;
};

constexpr double zone = 0.8; // fraction of the aperture's width and height that the eyes fill

bool shows_a_row(const Frame& frame); ///< a lenticular sheet, which shows no vertical parallax

/// `across` x `across` eyes in the zone, row by row from the top left; for a lenticular sheet the
/// same number of eyes in one row.
std::vector<EyePosition> eyes_of(const Frame& frame, int across);

/// The picture without the margin.
Frame inner_part(const Image& image, const ViewForm& form);

/// The replayed view of a frame from that eye.
Frame view_of(const Frame& frame, const EyePosition& eye, const ViewForm& form);

/// The scene's perspective picture from `eye`, or from the scene's own eye if none is given. It is
/// rendered with `times` pixels to one of the film in each direction, then reduced to the pixels of
/// a view and cut by its margin.
Frame perspective_of(const Renderer& renderer, const std::string& scene, const std::string& name,
                     const std::optional<EyePosition>& eye, std::vector<std::string> options,
                     int times, const ViewForm& form);

/// Similarity of a replayed view to a picture of what the eye should see.
struct ViewFigures {
    double psnr = 0, ssim = 0; ///< dB; -1 to 1
};

ViewFigures view_figures(const Frame& view, const Frame& requested);
ViewFigures mean(const std::vector<ViewFigures>& views);
ViewFigures least(const std::vector<ViewFigures>& views);
ViewFigures greatest(const std::vector<ViewFigures>& views);

/// Root mean square difference of the colours, over the pixels that `frame` lights.
double lit_rmse(const Frame& frame, const Frame& reference);

/// Mean product of the frame's differences from two references, over the same pixels. If the
/// references err independently of each other, this is the frame's mean squared error without the
/// references' own errors. It may be below 0.
double lit_squared_error(const Frame& frame, const Frame& a, const Frame& b);

} // namespace integral::bench

#endif
