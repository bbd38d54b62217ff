// SPDX-License-Identifier: AGPL-3.0-or-later
// Names of quilt files by the Looking Glass quilt standard
// (lookingglassfactory.com/tutorial/what-is-a-quilt): they end in _qs<columns>x<rows>a<aspect>
// before the extension, as in first_qs8x6a0.75.png. Upper case is accepted, and so are the
// additions of browsers and file managers to a copy's name, as in "first_qs8x6a0.75 (1).png".
#ifndef INTEGRAL_FRAME_QUILT_NAME_H
#define INTEGRAL_FRAME_QUILT_NAME_H

#include "integral/frame/view_grid.h"

#include <optional>
#include <string>

namespace integral {

/// The data in a quilt's file name.
struct QuiltName {
    ViewGrid grid;
    double aspect = 0; ///< a view's width divided by its height, as displayed; > 0
};

/// Reads a quilt's file name; nothing if it has no such end.
std::optional<QuiltName> quilt_in_name(const std::string& path);

/// The path with such an end; unchanged if it already has one.
std::string quilt_name(const std::string& path, ViewGrid grid, double aspect);

/// The path without such an end, if it has one.
std::string without_grid(const std::string& path);

} // namespace integral

#endif
