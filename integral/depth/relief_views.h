// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws the views of a relief from eyes that are spread over a viewing zone, for quilts and panels.
#ifndef INTEGRAL_DEPTH_RELIEF_VIEWS_H
#define INTEGRAL_DEPTH_RELIEF_VIEWS_H

#include "integral/depth/relief_frame.h"
#include "integral/frame/view_grid.h"

#include <vector>

namespace integral {

/// The view of a relief from one eye, pixel by pixel.
class ReliefEyeView {
public:
    /// `eye`: mm; `part`: the distance of the relief's own eyes, divided by this eye's; `shown`:
    /// the rectangle around the middle of the image plane, mm, that `size` pixels cover. `relief`
    /// must outlive this.
    ReliefEyeView(const Relief& relief, Vec2 eye, double part, Vec2 shown, PixelSize size);

    /// The pixel's mean light, of 1 to 3 lines of sight one way. `with_bars`: it is black outside
    /// of the relief's pictures.
    Colour pixel(int x, int y, ReliefFigures& figures, bool with_bars = true) const;
    /// The parallax of the surface in the pixel's middle.
    double parallax(int x, int y) const;

private:
    ReliefLine line_at(Vec2 pixel) const;
    bool is_in_bar(Vec2 place) const;

    const Relief& relief_;
    Vec2 eye_;
    double part_;
    Film raster_;
    int across_, down_;
};

/// From one line of sight of such a view to the next in the image plane, across and down, mm.
Vec2 spacing_of_lines(const Relief& relief, Vec2 shown, PixelSize size);

/// Views by number, and the counts of their lines of sight.
struct ReliefViews {
    std::vector<Image> views;
    ReliefFigures figures;
};

/// The views of eyes, each of `size` pixels and in the form of `form`. A view shows a rectangle of
/// the image plane around the middle, `shown` mm; outside of the relief's pictures it is black.
/// `directions`: numbers of views across and up (directions_of). Throws
/// Interrupted.
ReliefViews views_of_relief(Relief relief, const EyeGrid& eyes, ViewGrid directions, Vec2 shown,
                            PixelSize size, const Image& form, int threads,
                            const Progress& progress);

} // namespace integral

#endif
