// SPDX-License-Identifier: AGPL-3.0-or-later
// The parallel views of a frame (thesis 5.3): what an eye endlessly far away sees through the
// sheet, direction by direction, a pixel a lens; and the frame that shows given views.
#ifndef INTEGRAL_REPLAY_PARALLEL_VIEWS_H
#define INTEGRAL_REPLAY_PARALLEL_VIEWS_H

#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"
#include "integral/lightfield/view_grid.h"
#include "integral/replay/replay.h"

#include <memory>
#include <optional>
#include <vector>

namespace integral {

/// The pixels of a view: one for each lens of which the film has a pixel, in the lattice's rows,
/// the top one first. Of hexagonal lenses each has two, side by side, so that odd rows stand half a
/// lens to the right. Lenticular: a row for each of the film's.
struct LensWindow {
    LensIndex first;           ///< the lens of the top left pixel (hexagonal: of an even row)
    int columns = 0, rows = 0; ///< pixels
};

/// Whole pixels of the film to a lens, the nearest to what there are.
ViewGrid natural_views(const FrameMetadata& metadata);

/// Throws std::invalid_argument for a lenticular sheet slanted by more than 45 degrees, whose
/// lenses lie across.
LensWindow lens_window(const FrameMetadata& metadata);

/// Whether each view takes whole pixels: natural views of lenticular or square lenses that are not
/// slanted, a whole number of pixels wide (1e-6 of one), on a film without subpixels. Then neither
/// way loses anything.
bool views_are_exact(const FrameMetadata& metadata, ViewGrid grid);

/// The parallel views of a frame, made row by row, as parallel_views makes them whole.
class ParallelViews {
public:
    /// The frame has metadata, and has to outlive this. Throws as lens_window does.
    ParallelViews(const Frame& frame, ViewGrid grid);
    ~ParallelViews();

    /// Pixels of a view.
    int width() const;
    int height() const;

    /// Writes row `row` of view `view` into an image of the frame's form, from its pixel (x, y) on.
    /// May be called by several threads.
    void draw(int view, int row, Image& image, int x, int y) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// All views of a frame that has metadata, in its form; black (transparent) where a lens has no
/// film. Not exact: the film is interpolated between its pixels' centres, in linear light, at the
/// middles of as many equal parts of each lens's width (and of its height, or for hexagonal lenses
/// their rows'). Of a film with subpixels each colour channel is read at its own stripes. `threads`
/// as in replay; empty: `progress` stopped it. Throws as lens_window does.
std::optional<std::vector<Image>> parallel_views(const Frame& frame, ViewGrid grid, int threads = 0,
                                                 const Progress& progress = {});

/// The same directions as eyes so far away (1e9 mm) that they see the whole sheet from one: what
/// `replay` draws for them are the parallel views upright, of the film's shape and any size.
/// Nothing: that part of the lenses is totally reflected. Throws as lens_window does.
std::vector<std::optional<Eye>> far_eyes(const FrameMetadata& metadata, ViewGrid grid);

/// What is lost on the way from a frame to its parallel views and back: PSNR of the frame of the
/// views against the frame, dB. Nothing: `progress` stopped it. Throws as lens_window does.
std::optional<double> psnr_there_and_back(const Frame& frame, ViewGrid grid, int threads = 0,
                                          const Progress& progress = {});

/// Inverse: the frame of that geometry which shows the views. Not exact: each film pixel, or stripe
/// of one, is interpolated between the directions of the views. The views are alike and of
/// lens_window's size, or std::invalid_argument is thrown.
std::optional<Image> frame_from_views(const std::vector<Image>& views,
                                      const FrameMetadata& metadata, ViewGrid grid, int threads = 0,
                                      const Progress& progress = {});

} // namespace integral

#endif
