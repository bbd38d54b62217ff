// SPDX-License-Identifier: AGPL-3.0-or-later
// Views that a command is given, as a quilt or as files, or sees in a frame.
#ifndef INTEGRAL_CLI_GIVEN_VIEWS_H
#define INTEGRAL_CLI_GIVEN_VIEWS_H

#include "integral/cli/command.h"
#include "integral/cli/values.h"
#include "integral/lightfield/frame.h"
#include "integral/lightfield/view_grid.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

constexpr int most_views_a_side = 256;

/// The value of --views. Throws UsageError.
ViewGrid parse_view_grid(const std::string& text);
ViewGrid parse_view_grid(const options::variables_map& arguments);

/// Views by number, and what is known of them.
struct GivenViews {
    std::vector<Image> views;
    ViewGrid grid;
    std::optional<FrameMetadata> metadata; ///< of the frame they come from, with its quilt record
};

/// What a line says of the views that it gives.
struct ViewsSaid {
    std::optional<ViewGrid> grid;  ///< their number
    bool ignore_documents = false; ///< the line has other geometry than the files'
    bool eyes = false;             ///< they are what eyes see
};

/// Reads one quilt, or the files of all views. Their number is what the line says, else what they
/// say of themselves, else (files) how many there are. A quilt of what eyes see may have a rest
/// beside its views. Throws UsageError and InputError.
GivenViews read_given_views(const Words& inputs, const ViewsSaid& said);
GivenViews read_given_views(const options::variables_map& arguments, const Words& inputs,
                            bool eyes);

/// What eyes see of a frame that are spread over its viewing zone, by number. Throws Interrupted.
std::vector<Image> views_of_eyes(const Frame& frame, ViewGrid grid, PixelSize size, int threads);

} // namespace integral

#endif
