// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes the views of frames as pictures: a quilt, numbered files, an animation, or a picture with
// its depths.
#ifndef INTEGRAL_OUTPUT_VIEW_EXPORT_H
#define INTEGRAL_OUTPUT_VIEW_EXPORT_H

#include "integral/base/parallel.h"
#include "integral/io/picture_series.h"
#include "integral/lightfield/picture_fit.h"
#include "integral/lightfield/view_grid.h"
#include "integral/optics/film.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace integral {

constexpr int largest_picture_side = 32768; ///< pixels, of a view and of a quilt

enum class ViewKind {
    parallel, ///< what eyes endlessly far away see, a pixel a lens
    upright,  ///< the same as it looks: of the film's shape
    of_eyes   ///< what eyes see that are spread over the viewing zone
};

/// Which views are written, and how.
struct ViewExport {
    std::string output;
    std::string sheet;             ///< a file with the frames' geometry; "": they carry their own
    std::optional<ViewGrid> grid;  ///< nothing: as many as whole pixels are nearest to a lens's
    std::optional<PixelSize> size; ///< of a view that is not parallel; nothing: 500 on the longer
                                   ///< side
    ViewKind kind = ViewKind::parallel;
    bool files = false;          ///< a file for each view, in place of a quilt
    Fit fit = Fit::contain;      ///< of the film, where `size` or the quilt's name states another
                                 ///< shape, and nothing says that pixels are not square
    AnimationSettings animation; ///< where `output` is one
    int threads = 0;             ///< 0: one per core
    /// Is told, in a line each, what the user should know.
    std::function<void(const std::string&)> tell = [](const std::string&) {};
    /// Makes the Progress of a long piece of work from its name.
    std::function<Progress(const char*)> progress = [](const char*) { return Progress(); };
};

/// Each throws RequestError where the request makes no sense for the frame or the file's name,
/// InputError, OutputError, and Interrupted where its progress stops the work.

/// Writes the views of one frame, and returns the path: a quilt's name gets the number of views and
/// their shape, if it does not state them. Views of eyes that have bars, or are cut, carry no
/// geometry.
std::string write_views_of_frame(const std::string& frame, const ViewExport& wanted);

/// Writes the views of eyes of several frames as an animation of quilts of wanted.grid, and returns
/// its path.
std::string write_quilts(const std::vector<std::string>& frames, const ViewExport& wanted);

/// Writes what the centre eye sees of a frame, beside the depths that a depth frame (.exr) says.
void write_rgbd(const std::string& frame, const std::string& depths, const ViewExport& wanted);

} // namespace integral

#endif
