// SPDX-License-Identifier: AGPL-3.0-or-later
// Finds the pixels of a quilt's other views whose samples a pixel uses: a matte place of a surface
// has the same colour from all eyes, so that one set of samples serves all views (Andersson and
// others 2011).
#ifndef INTEGRAL_RECONSTRUCTION_VIEW_REUSE_H
#define INTEGRAL_RECONSTRUCTION_VIEW_REUSE_H

#include "integral/reconstruction/beam_footprint.h"
#include "integral/frame/quilt_geometry.h"

#include <vector>

namespace integral {

class ViewReuse {
public:
    explicit ViewReuse(const QuiltGeometry& quilt);

    /// Whether a quilt has enough views for reuse to pay: three at least.
    static bool pays(const QuiltGeometry& quilt) { return quilt.tiles.count() >= 3; }

    /// The footprint of the quilt's pixels.
    const BeamFootprint& footprint() const { return footprint_; }

    /// The largest tilt (BeamSamples::Seen::tilt) that counts: that of a surface edge-on to a ray
    /// whose eye is 1/100 of a step between eyes away.
    double most_tilt() const { return most_tilt_; }

    /// The greatest distance, in rows, between a pixel and a pixel whose samples it uses.
    int rows() const { return rows_; }

    /// Sets `scratch` to the pixels of other views that may show what pixel (x, y) of the view in
    /// `tile` shows at one of `depths` (mm from the sheet away from the viewer, in increasing
    /// order), or at a depth in between if two of them are near each other.
    void find(int x, int y, LensIndex tile, const std::vector<float>& depths,
              ReuseNeighbourhood::Scratch& scratch) const;

private:
    /// The way from a view to another one.
    struct Step {
        int columns, rows; ///< to the right and up, tiles
        Vec2 eye;          ///< from eye to eye, to the right and down, pixels at the sheet
        double pixels;     ///< the length of `eye`
        Eight part;        ///< weight of the other view's samples, eight times
    };
    void find_in(const Step& step, double left, double top, LensIndex tile,
                 const std::vector<double>& parts, ReuseNeighbourhood::Scratch& scratch) const;
    struct Span {
        int first, last;
    };
    static Span pixels_around(double from, double to);
    void append(const Step& step, Span across, Span down, LensIndex tile,
                ReuseNeighbourhood::Scratch& scratch) const;

    QuiltGeometry quilt_;
    BeamFootprint footprint_;
    std::vector<Step> steps_;
    int rows_ = 0;
    double most_tilt_, most_pixels_ = 0; ///< the latter: of Step::pixels
};

} // namespace integral

#endif
