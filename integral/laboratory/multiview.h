// SPDX-License-Identifier: AGPL-3.0-or-later
// Compares a scene's integral frame with multi-view images for the same lenticular sheet (thesis
// 5.2 and 6.1): by closed forms, and by the views of eyes across the viewing zone.
#ifndef INTEGRAL_LABORATORY_MULTIVIEW_H
#define INTEGRAL_LABORATORY_MULTIVIEW_H

#include "integral/laboratory/view_figures.h"
#include "integral/laboratory/view_switching.h"

#include <string>
#include <vector>

namespace integral {

struct MultiviewRequest {
    std::string scene;              ///< .pov
    std::vector<std::string> words; ///< of povray-integral, for the scene: +W, +H, +A, Declare=...
    int views = 0;                  ///< 0: as many as a lens has pixels, rounded
    int eyes = 0;                   ///< number, over the middle 80% of the zone; 0: four to a view
    int width = 0, height = 0;      ///< pixels of the eyes' pictures; 0: 360 on the longer side
    int threads = 0;                ///< 0: one per core
    std::string folder; ///< for frames and pictures: integral.png, parallel.png, converging.png,
                        ///< infinity.png, moire.png, seen.png
};

constexpr int most_views = 256, most_eyes = 4096;

/// Figures of the scene itself, or of one frame of it, as seen by the eyes.
struct SeenFrame {
    std::string name;
    std::optional<ViewSwitching> switching;  ///< of multi-view images
    double greatest_jump = 0, mean_jump = 0; ///< RMSE from one eye's picture to the next one's
    double mean_error = 0, worst_error = 0;  ///< RMSE to the scene's own perspective picture
};

struct MultiviewResult {
    FrameMetadata geometry;
    int views = 0, eyes = 0;
    ViewFigures figures;
    std::optional<double> moire; ///< period of the stripes in moire.png, mm
    std::vector<SeenFrame> seen; ///< the scene itself first, then its frame, then multi-view images
};

/// Renders the scene's frame and its views, interleaves them, replays all and writes the pictures.
/// Throws std::invalid_argument for a request that cannot be met, InputError where the scene cannot
/// be rendered, OutputError, Interrupted.
MultiviewResult compare_multiview(const MultiviewRequest& request, const Progress& progress = {});

} // namespace integral

#endif
