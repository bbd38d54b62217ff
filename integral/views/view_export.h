// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes the views of frames as pictures: a quilt, numbered files, an animation, or a picture with
// its depths.
#ifndef INTEGRAL_VIEWS_VIEW_EXPORT_H
#define INTEGRAL_VIEWS_VIEW_EXPORT_H

#include "integral/base/parallel.h"
#include "integral/frame/frame_metadata.h"
#include "integral/frame/picture_fit.h"
#include "integral/frame/view_grid.h"
#include "integral/io/picture_series.h"
#include "integral/optics/film.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace integral {

constexpr int largest_picture_side = 32768; ///< pixels, of a view and of a quilt
constexpr int default_longer_side_of_view = 500; ///< pixels, of a view that is not parallel

enum class ViewKind {
    parallel, ///< of infinitely distant eyes, a pixel a lens
    upright,  ///< parallel, but upright and with the film's shape
    of_eyes   ///< of eyes that are spread over the viewing zone
};

/// Options for writing views.
struct ViewExport {
    std::string output;
    std::string sheet;             ///< a file with the frames' geometry; "": the frames have it
    std::optional<ViewGrid> grid;  ///< nothing: natural_views
    std::optional<PixelSize> size; ///< of a view, unless it is parallel; nothing:
                                   ///< default_longer_side_of_view
    ViewKind kind = ViewKind::parallel;
    bool files = false;          ///< a file for each view, in place of a quilt
    Fit fit = Fit::contain;      ///< of the film, where the quilt's name, or `size` with square
                                 ///< pixels, gives another shape
    AnimationSettings animation; ///< used if `output` is an animation
    int threads = 0;             ///< 0: one per core
    /// Takes notices for the user, a line each.
    std::function<void(const std::string&)> tell = [](const std::string&) {};
    /// Makes the Progress of a long piece of work from its name.
    std::function<Progress(const char*)> progress = [](const char*) { return Progress(); };
};

/// Each function throws RequestError where the request makes no sense for the frame or the file's
/// name, InputError, OutputError, and Interrupted where its progress stops the work.

/// Writes the views of one frame, and returns the path. If a quilt's name lacks the number and the
/// shape of the views, they are added. Views of eyes that have bars, or are cut, carry no geometry.
std::string write_views_of_frame(const std::string& frame, const ViewExport& requested);

/// Properties of views of eyes that are in memory.
struct EyeViews {
    ViewGrid grid, directions;             ///< of the quilt, and of the views (directions_of)
    PixelSize size;                        ///< of each view
    double shape = 1;                      ///< width divided by height, as displayed
    std::optional<FrameMetadata> metadata; ///< of the frame whose film they show whole, with the
                                           ///< quilt's record
};

/// Writes such views as a quilt, files or an animation, and returns the path.
std::string write_views_of_eyes(std::vector<Image> views, const EyeViews& form,
                                const ViewExport& requested);

/// Throws where write_views_of_eyes would, before long work.
void check_views_of_eyes(const EyeViews& form, const ViewExport& requested);

/// Writes views of eyes of several frames as an animation, whose pictures are quilts of
/// requested.grid, and returns its path.
std::string write_quilts(const std::vector<std::string>& frames, const ViewExport& requested);

/// Writes the centre eye's view of a frame, and next to it the depths of a depth frame (.exr).
void write_rgbd(const std::string& frame, const std::string& depths, const ViewExport& requested);

} // namespace integral

#endif
