// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes the views of a frame as pictures: as one quilt, as numbered files or as an animation.
#ifndef INTEGRAL_VIEWS_VIEW_FILES_H
#define INTEGRAL_VIEWS_VIEW_FILES_H

#include "integral/io/picture_series.h"
#include "integral/views/parallel_views.h"

#include <string>

namespace integral {

/// Parallel views as seen by a distant eye: upright. `view`: the views' size and their part of the
/// sheet. Black where the lenses reflect totally. Throws Interrupted if `progress` stops the work,
/// std::invalid_argument as lens_window does.
std::vector<Image> upright_views(const Frame& frame, ViewGrid grid, const View& view, int threads,
                                 const Progress& progress);

/// Writes parallel views as a quilt, a band of rows at a time; view 0 is at the bottom left.
/// `metadata` becomes the file's document. Throws OutputError, Interrupted.
void write_quilt(const std::string& path, const Frame& frame, const ParallelViews& views,
                 ViewGrid grid, const FrameMetadata& metadata, int threads,
                 const Progress& progress);

/// Adds parallel views to a series, each with `metadata`, which must have a quilt record; writes
/// the view's number in that record. Throws OutputError, Interrupted.
void write_views(PictureSeries& series, const Frame& frame, const ParallelViews& views,
                 ViewGrid grid, FrameMetadata metadata, int threads, const Progress& progress);

/// Writes views as an animation in which successive views are neighbours: row by row upwards, even
/// rows from the left, odd rows from the right. Throws OutputError, Interrupted.
void write_animation(PictureSeries& series, const std::vector<Image>& views, ViewGrid grid);

} // namespace integral

#endif
