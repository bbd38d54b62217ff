// SPDX-License-Identifier: AGPL-3.0-or-later
// Interlaces views: makes the image that is sent to a light-field panel, subpixel by subpixel.
#ifndef INTEGRAL_PANEL_INTERLACE_H
#define INTEGRAL_PANEL_INTERLACE_H

#include "integral/frame/image.h"
#include "integral/frame/view_grid.h"
#include "integral/panel/panel_mapping.h"

#include <vector>

namespace integral {

enum class Neighbours {
    nearest, ///< the neighbour whose part of the range contains the phase
    linear   ///< the two neighbours around it, with weights in 1/256
};

/// Selects the views, and the pixels in a view, that give a subpixel's value. Stored values are
/// blended as they are; for linear light, convert the views first (16 bits).
struct Blend {
    Neighbours views = Neighbours::linear, pixels = Neighbours::linear;
};

/// Refers to the pictures of views in memory: three channels of 8 or 16 bits. The images must
/// outlive this object.
class ViewRaster {
public:
    /// The views in a quilt, or a list of pictures by view number. Throws std::invalid_argument if
    /// pictures differ in size or form, have another form, or are not grid.count() in number.
    ViewRaster(const Image& quilt, ViewGrid grid);
    ViewRaster(const std::vector<Image>& views, ViewGrid grid);

    ViewGrid grid;
    int width = 0, height = 0;   ///< of a view, pixels
    const Image* form = nullptr; ///< an image of the views' encoding and bits
    std::size_t row_step = 0;    ///< samples from one row of a view to the next

    /// The top left sample of a view. `Sample` is the type of the images' samples.
    template <class Sample> const Sample* first(int view) const
    {
        return std::get<std::vector<Sample>>(images_[view]->samples).data() + begin_[view];
    }

private:
    std::vector<const Image*> images_;
    std::vector<std::size_t> begin_;
};

/// A black image for a panel, in the views' form. One image serves all frames of a sequence.
Image panel_image(const ViewRaster& views, int width, int height);

/// Fills the panel's image, made by panel_image. If the mapping has no table `up`, the views stand
/// side by side in the order of their numbers, whatever the grid. `threads` as in for_each_row.
/// Throws std::invalid_argument if the image has another size or form.
void interlace(Image& panel, const ViewRaster& views, const PanelMapping& mapping, Blend blend = {},
               int threads = 0);

} // namespace integral

#endif
