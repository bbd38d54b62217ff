// SPDX-License-Identifier: AGPL-3.0-or-later
// Takes a frame apart into its parallel views (thesis 5.3), and makes the frame that shows given
// views. A parallel view is what an infinitely distant eye sees through the sheet from one
// direction, with one pixel for each lens.
#ifndef INTEGRAL_VIEWS_PARALLEL_VIEWS_H
#define INTEGRAL_VIEWS_PARALLEL_VIEWS_H

#include "integral/base/parallel.h"
#include "integral/frame/frame.h"
#include "integral/frame/view_grid.h"
#include "integral/replay/replay.h"

#include <memory>
#include <optional>
#include <vector>

namespace integral {

/// The lenses that have pixels in a view: all with a film pixel behind them, in the rows of the
/// lattice, the top row first. A hexagonal lens has two pixels side by side, so that odd rows can
/// lie half a lens further right. Behind upright lenticular lenses a view has the film's rows;
/// behind lenticular lenses that lie across, it has the film's columns.
struct LensWindow {
    LensIndex first;           ///< the lens of the top left pixel (hexagonal: of an even row)
    int columns = 0, rows = 0; ///< pixels
};

/// The number of film pixels to a lens, across and down, rounded to whole ones.
ViewGrid natural_views(const FrameMetadata& metadata);

/// The lenses of a frame's views. Throws std::invalid_argument if there are more than 1000000 one
/// way.
LensWindow lens_window(const FrameMetadata& metadata);

/// Whether the views have exactly the film's pixels, so that nothing is lost either way. The views
/// must be natural_views on a film without subpixels; the lenses lenticular or square, upright or
/// lying across, unslanted, and a whole number of pixels wide (to within 1e-6 of a pixel).
bool views_are_exact(const FrameMetadata& metadata, ViewGrid grid);

/// Makes the parallel views of a frame row by row.
class ParallelViews {
public:
    /// The frame must have metadata and outlive this. Throws as lens_window does.
    ParallelViews(const Frame& frame, ViewGrid grid);
    ~ParallelViews();

    /// Size of a view in pixels.
    int width() const;
    int height() const;

    /// Writes row `row` of view `view` into an image of the frame's form, from its pixel (x, y) on.
    /// May be called by several threads.
    void draw(int view, int row, Image& image, int x, int y) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// All views of a frame that has metadata, in its form; black (transparent) where there is no film
/// behind a lens. Views that are not exact (views_are_exact) are interpolated between the centres
/// of film pixels, in linear light: each lens's width (and its height; for hexagonal lenses, its
/// row's height) is divided into as many equal parts as there are views, and each view shows the
/// middle of its part. On a film with subpixels each colour channel is read at its own stripes.
/// `threads` as in replay. Returns nothing if `progress` stopped the work. Throws as lens_window
/// does.
std::optional<std::vector<Image>> parallel_views(const Frame& frame, ViewGrid grid, int threads = 0,
                                                 const Progress& progress = {});

/// The eyes that see the parallel views, so far away (1e9 mm) that their direction is the same over
/// the whole sheet: for them `replay` draws the views upright, of the film's shape and any size.
/// Nothing for a view whose light the lenses reflect totally. Throws as lens_window does.
std::vector<std::optional<Eye>> far_eyes(const FrameMetadata& metadata, ViewGrid grid);

/// Loss from a frame to its parallel views and back: the PSNR (dB) of the frame made from the views
/// against the original. Returns nothing if `progress` stopped the work. Throws as lens_window
/// does.
std::optional<double> psnr_there_and_back(const Frame& frame, ViewGrid grid, int threads = 0,
                                          const Progress& progress = {});

/// Makes the frame of frame_from_parallel_views some rows at a time.
class FrameOfViews {
public:
    /// The views must outlive this. Throws as frame_from_parallel_views does.
    FrameOfViews(const std::vector<Image>& views, const FrameMetadata& metadata, ViewGrid grid);
    ~FrameOfViews();

    /// Draws the frame's rows from `first` on into `band`, which has the views' form, the film's
    /// width, and only zeros. `threads` and `progress` as in replay; returns false if `progress`
    /// stopped the work.
    bool draw(int first, Image& band, int threads, const Progress& progress) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Inverse of parallel_views: the frame of that geometry which shows the views. If they are not
/// exact (views_are_exact), each film pixel, or each stripe of one, is interpolated between the
/// directions of the views. Throws std::invalid_argument unless all views have one form and
/// lens_window's size.
std::optional<Image> frame_from_parallel_views(const std::vector<Image>& views,
                                               const FrameMetadata& metadata, ViewGrid grid,
                                               int threads = 0, const Progress& progress = {});

} // namespace integral

#endif
