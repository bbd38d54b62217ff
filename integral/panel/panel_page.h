// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes a page for browsers with WebGL 2 that drives a panel: it interlaces views for the panel and
// shows the image on it, in full screen.
#ifndef INTEGRAL_PANEL_PANEL_PAGE_H
#define INTEGRAL_PANEL_PANEL_PAGE_H

#include "integral/panel/panel_images.h"

#include <string>

namespace integral {

/// A page that contains the pictures, as a quilt, and the mapping of the panel in `images`. Its
/// image equals the one made by `images`, subpixel by subpixel, if the pictures have 8 bits and
/// no alpha; others are converted to that first, with a notice. `name`: the pictures' name.
/// Throws RequestError and Interrupted.
std::string panel_page(PanelImages& images, const PanelPictures& pictures, const std::string& name);

/// The same for a quilt video, which the page plays in a loop. Throws InputError, too.
std::string panel_video_page(PanelImages& images, const std::string& path);

} // namespace integral

#endif
