// SPDX-License-Identifier: AGPL-3.0-or-later
// Interlacing: the image of a light-field panel of the views that it shows, subpixel by subpixel.
#ifndef INTEGRAL_OUTPUT_INTERLACE_H
#define INTEGRAL_OUTPUT_INTERLACE_H

#include "integral/base/parallel.h"
#include "integral/lightfield/image.h"
#include "integral/lightfield/view_grid.h"
#include "integral/output/looking_glass.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace integral {

/// The published mapping of a display, in 2^-32 parts of its views' range: phases add up modulo one
/// by themselves. Each is worked out in double precision by view_of_subpixel, so that no error adds
/// up along a row.
struct PublishedMapping {
    int width = 0, height = 0;                            ///< of the panel, pixels
    std::array<std::vector<std::uint32_t>, 4> of_columns; ///< by row modulo 4 (cells repeat so): a
                                                          ///< phase for each subpixel of a row
    std::vector<std::uint32_t> of_rows;                   ///< to be added
    bool flip_x = false, flip_y = false;                  ///< the views' pictures are mirrored, too
};
PublishedMapping published_mapping(const LookingGlassCalibration& calibration);

/// The mapping of a panel through the optics of its lenses, a number of 16 bits for each subpixel,
/// channel by channel within a pixel: `across` and `up` say from where in the eyes' zone it is
/// seen, x and y (downwards) at which place of the picture: which of `parts` equal parts from side
/// to side, the outermost for what is beyond, and the last but one for the last. `across` is
/// `empty` where no eye sees it: black.
struct RayMapping {
    int width = 0, height = 0;
    bool round_lenses = false; ///< else `up` is empty: lenticular lenses show all views from left
                               ///< to right
    std::vector<std::uint16_t> across, up, x, y;
    std::vector<std::array<std::uint16_t, 2>> y_of_rows; ///< the least and the greatest y in each
                                                         ///< row of what is seen
    static constexpr int parts = 65536, last = 65534, empty = 65535;
};

/// Of the panel that frames of that geometry are native to. `threads` and `progress` as in replay.
std::optional<RayMapping> ray_mapping(const FrameMetadata& geometry, EyeGrid eyes, int threads = 0,
                                      const Progress& progress = {});

enum class Neighbours {
    nearest, ///< the one whose part it is
    linear   ///< between the two around it, by weights of 8 bits
};

/// How a subpixel's colour is found: of which views, and of which pixels in a view. In the values
/// as they are stored: convert pictures to linear light (16 bits) to blend them so.
struct Blend {
    Neighbours views = Neighbours::linear, pixels = Neighbours::linear;
};

/// The pictures of views, as they lie in memory: three channels of 8 or 16 bits. Refers to images
/// which must outlive it.
class ViewPictures {
public:
    /// Views of a quilt, or one picture a view by number. Throws std::invalid_argument where they
    /// are not alike, of another form, or fewer than grid.count().
    ViewPictures(const Image& quilt, ViewGrid grid);
    ViewPictures(const std::vector<Image>& views, ViewGrid grid);

    ViewGrid grid;
    int width = 0, height = 0; ///< of a view, pixels
    const Image* form = nullptr;
    std::size_t row_step = 0; ///< samples from row to row

    /// The top left sample of a view. `Sample` is that of the images.
    template <class Sample> const Sample* first(int view) const
    {
        return std::get<std::vector<Sample>>(images_[view]->samples).data() + begin_[view];
    }

private:
    std::vector<const Image*> images_;
    std::vector<std::size_t> begin_;
};

/// An image for a panel, of the views' form: to be kept for all frames of a sequence.
Image panel_image(const ViewPictures& views, int width, int height);

/// Fills the panel's image; it is of panel_image's form. A quilt's views stand on one line, by
/// number, but those for round lenses in the columns and rows of their grid. `portable`: by the
/// plain loops alone, which the others must equal to the bit.
void interlace(Image& panel, const ViewPictures& views, const PublishedMapping& mapping,
               Blend blend = {}, int threads = 0, bool portable = false);
void interlace(Image& panel, const ViewPictures& views, const RayMapping& mapping, Blend blend = {},
               int threads = 0, bool portable = false);

} // namespace integral

#endif
