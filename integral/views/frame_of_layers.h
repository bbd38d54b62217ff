// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes the frame of flat pictures in space, some rows at a time.
//
// Places in a layer are measured on the sheet: as the eye in the middle of the aperture sees them
// there. Where a layer is z mm behind the sheet, and for an eye d mm before it, the line of sight
// through a point P of the sheet and A of the aperture plane meets the layer at the place P - rho
// A, with rho = z/(d + z), the layer's parallax there (relief.h).
#ifndef INTEGRAL_VIEWS_FRAME_OF_LAYERS_H
#define INTEGRAL_VIEWS_FRAME_OF_LAYERS_H

#include "integral/base/parallel.h"
#include "integral/frame/depth_range.h"
#include "integral/views/layer_picture.h"

#include <memory>
#include <optional>
#include <vector>

namespace integral {

/// A rectangle on the sheet, mm: its middle from the sheet's centre (y upwards), and its size.
struct LayerWindow {
    Vec2 middle, size;
};

/// The parallax of a layer z mm behind the sheet, seen from `distance` mm; z > -distance.
inline double layer_parallax(double z, double distance) { return z / (distance + z); }

/// Inverse of layer_parallax; `parallax` < 1.
inline double layer_depth(double parallax, double distance)
{
    return parallax * distance / (1 - parallax);
}

/// A layer's plane. A point of it has a place: where the eye in the middle sees it on the sheet,
/// mm. The parallax is an affine function of this place.
struct PicturePlane {
    double parallax = 0; ///< at the sheet's centre
    Vec2 slope;          ///< change of the parallax a mm to the right, and upwards

    double at(Vec2 place) const { return parallax + dot(slope, place); }
    bool tilted() const { return slope.x != 0 || slope.y != 0; }
};

/// The plane through the place `middle`, z mm behind the sheet there. `gradient`: slopes, mm that
/// it goes back for each mm to the right, and upwards. Empty if the eye in the middle, at
/// `distance`, is not in front of it.
std::optional<PicturePlane> picture_plane(double z, Vec2 gradient, Vec2 middle, double distance);

struct ParallaxRange {
    double least = 0, greatest = 0;
};

/// The range of the parallax of a plane in a window.
ParallaxRange parallax_range(const PicturePlane& plane, const LayerWindow& window);

/// A picture in its window on a plane.
struct DrawnLayer {
    PicturePlane plane;
    LayerWindow window;
    ParallaxRange range;
    /// The first is as fine as the plane can show it anywhere, each further one half as fine.
    std::vector<LayerPicture> pictures;
    std::vector<int> picture_of; ///< indices of `pictures`, for equal parts of `range`
};

/// The picture reduced to the detail that a pixel of the frame shows of a layer in that window:
/// pixels of a quarter of the beam's width there, or, of a tilted one, of an eighth to a quarter.
/// `threads`: 0: one per core.
DrawnLayer drawn_layer(const Image& picture, const PicturePlane& plane, const LayerWindow& window,
                       const FrameMetadata& geometry, int threads);

/// Draws the frame. A film pixel (or each of its subpixels) gathers light over its own area and its
/// lens's cell (with a lenticular sheet also over the height of the aperture), along 16 lines of
/// sight, with the same pattern in all pixels. Along each line the layers cover each other from the
/// front to the back, in linear light. All lines of a pixel go through the lens of the pixel's
/// centre, from the part of the pixel that lies behind this lens.
class FrameOfLayers {
public:
    /// `layers`: any order; of two at the same distance, the later one is in front. Tilted ones may
    /// pass through each other. If `transparent` is not set, they stand on black.
    FrameOfLayers(std::vector<DrawnLayer> layers, const FrameMetadata& geometry, bool transparent);
    ~FrameOfLayers();

    /// Draws rows as FrameOfShares::draw does.
    bool draw(int first, Image& band, int threads, const Progress& progress) const;

    /// The depth of each pixel: the distance of the nearest layer whose alpha is at least 1/2 on
    /// the line of sight through the pixel's centre and its lens's middle, else infinite. Throws
    /// Interrupted.
    DepthFrame depths(int threads, const Progress& progress) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace integral

#endif
