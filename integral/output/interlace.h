// SPDX-License-Identifier: AGPL-3.0-or-later
// Interlacing: makes the image that a light-field panel is sent, subpixel by subpixel, of the
// views that it is to show.
#ifndef INTEGRAL_OUTPUT_INTERLACE_H
#define INTEGRAL_OUTPUT_INTERLACE_H

#include "integral/lightfield/image.h"
#include "integral/lightfield/view_grid.h"
#include "integral/output/panel_mapping.h"

#include <vector>

namespace integral {

enum class Neighbours {
    nearest, ///< the one neighbour in whose part of the range the phase is
    linear   ///< the two neighbours around it, by weights of 1/256
};

/// How a subpixel's value is taken: of which views, and of which pixels in a view. Stored values
/// are blended as they are; to blend linear light, convert the views to it (16 bits) before.
struct Blend {
    Neighbours views = Neighbours::linear, pixels = Neighbours::linear;
};

/// The pictures of views where they lie in memory: three channels of 8 or 16 bits. Refers to images
/// that must outlive it.
class ViewRaster {
public:
    /// The views in a quilt, or a list of pictures by view number. Throws std::invalid_argument
    /// where pictures differ in size or form, are of another form, or fewer than grid.count().
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

/// A black image for a panel, in the views' form. One serves all frames of a sequence.
Image panel_image(const ViewRaster& views, int width, int height);

/// Fills the panel's image, which panel_image has made. Where the mapping has no phases up, the
/// views stand side by side by number, whatever their grid. `threads` as in for_each_row. Throws
/// std::invalid_argument where the image is of another size or form.
void interlace(Image& panel, const ViewRaster& views, const PanelMapping& mapping, Blend blend = {},
               int threads = 0);

} // namespace integral

#endif
