// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes the images that are sent to a panel, from frames, quilts and views, and of test cards.
#ifndef INTEGRAL_PANEL_PANEL_IMAGES_H
#define INTEGRAL_PANEL_PANEL_IMAGES_H

#include "integral/base/parallel.h"
#include "integral/frame/frame.h"
#include "integral/panel/interlace.h"
#include "integral/panel/lens_cards.h"
#include "integral/sheet/panel.h"
#include "integral/views/view_input.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace integral {

enum class PanelCard { views, crosstalk, colours, pitch };

struct PanelImageOptions {
    /// Number of views. Default: for a quilt the number in its name or metadata, for a frame the
    /// panel's pixels per lens, rounded, for a card 8, or 4 x 4 behind round lenses.
    std::optional<ViewGrid> views;
    std::optional<double> aspect; ///< shape of given views, as in ViewsRequest
    std::optional<double> video_time; ///< selects a quilt video's picture, as in ViewsRequest
    bool right_to_left = false;   ///< views in files stand from right to left
    Fit fit = Fit::contain;       ///< for frames and views of another shape than the panel's
    Blend blend;
    bool encoded = false;        ///< blend stored values, not linear light
    int width = 0, height = 0;   ///< of each view of a frame, pixels; 0: 1000 on the longer side
    std::optional<int> lit_view; ///< for PanelCard::crosstalk (default: every other view) and
                                 ///< colours (default: the middle view)
    std::optional<LensCard> lens_card; ///< for PanelCard::pitch: one of the lenses' cards in place
                                       ///< of the chart of pitches
    int threads = 0;             ///< 0: one per core
    std::string panel_name = "the panel"; ///< the panel's name in messages

    /// Called with a line for each warning to the user; the image is made nevertheless.
    std::function<void(const std::string&)> tell = [](const std::string&) {};
    /// Makes the Progress of a long task from its name.
    std::function<Progress(const char*)> progress = [](const char*) { return Progress(); };
};

/// Whether views are converted to linear light to be blended.
bool blends_light(Blend blend, const PanelImageOptions& options);

/// The pictures that a panel's image is interlaced from, and their places; or the image itself.
struct PanelPictures {
    std::vector<Image> views; ///< by number; or one picture: the image as it is sent to the panel
    bool is_image = false;
    ViewGrid grid{1, 1};
    std::optional<EyeGrid> eyes; ///< of the views; nothing: the panel's own
    Blend blend;
    FittedPicture fit;            ///< the place of the views' pictures on the panel
    std::optional<Aperture> zone; ///< the zone of eyes that see the image; nothing: the panel's
};

/// A picture over black in three channels of 8 or 16 bits.
Image over_black(const Image& picture, int bits, Encoding encoding);

/// Makes images for one panel; reuses intermediate results from image to image.
class PanelImages {
public:
    /// Throws RequestError if the panel is too large.
    PanelImages(const Panel& panel, PanelImageOptions options);

    /// Groups the inputs that make one image: each frame or quilt is a group by itself; files of
    /// single views form one group together. Throws InputError.
    std::vector<std::vector<std::string>> groups(const std::vector<std::string>& inputs) const;

    /// The panel's image of one group, with the geometry of a frame unless the panel is mirrored.
    /// Throws RequestError, InputError, Interrupted.
    Frame image_of(const std::vector<std::string>& group);

    /// The same for a frame with metadata, and for views of eyes, that are in memory. `name`: their
    /// name in messages. Throw RequestError and Interrupted.
    Frame image_of_frame(const std::string& name, const Frame& frame);
    Frame image_of_views(const std::string& name, ViewInput views);

    /// The panel's image of a test card. Throws RequestError.
    Frame card(PanelCard card);

    /// Returns the pictures that image_of, or card, interlaces. Throws as these do.
    PanelPictures pictures_of(const std::vector<std::string>& group);
    PanelPictures pictures_of(PanelCard card);

    /// The same for views of eyes that are in memory.
    PanelPictures pictures_of_views(const std::string& name, ViewInput views) const;

    /// The same for a quilt video, without `views`: the video is not read. Throws RequestError if
    /// neither its name nor the options give the views.
    PanelPictures pictures_of_video(const std::string& path) const;

    /// The mapping for these pictures; valid until the next image is made. Throws RequestError and
    /// Interrupted.
    const PanelMapping& mapping_for(const PanelPictures& pictures);

    /// The image as it is sent to the panel, mirrored if the panel is.
    Image as_sent(Image upright) const;

    /// A frame of the image sent to the panel, with its geometry unless the panel is mirrored.
    /// `zone`: the eyes' zone; default: the panel's.
    Frame frame_of_image(Image image, std::optional<Aperture> zone = std::nullopt) const;

    const Panel& panel() const { return panel_; }
    const PanelImageOptions& options() const { return options_; }

    /// Number of views in the last image; 0: it was a frame rendered for the panel.
    int views() const { return views_; }

private:
    std::optional<Frame> read_frame_of(const std::vector<std::string>& group) const;
    void check_directions(const std::string& name, const FrameMetadata& frame, ViewGrid grid) const;
    ViewInput read_views_of(const std::vector<std::string>& group) const;
    PanelPictures native_image(const std::string& name, const Frame& frame) const;
    PanelPictures pictures_of_frame(const std::string& name, const Frame& frame) const;
    PanelPictures pictures_of_card(PanelCard card) const;
    Frame image_of(PanelPictures pictures);
    void map_picture(const FittedPicture& picture, std::optional<EyeGrid> eyes);
    void map_through_lenses(std::optional<EyeGrid> eyes);
    FittedPicture fitted_to_panel(double shape) const;

    const Panel panel_;
    const PanelImageOptions options_;
    const FrameMetadata geometry_;
    int views_ = 0;
    std::optional<PanelMapping> mapping_;
    FittedPicture mapped_picture_;       ///< the picture that mapping_ is for
    std::optional<EyeGrid> mapped_eyes_; ///< the eyes that mapping_ is for, if it is through the
                                         ///< lenses
};

} // namespace integral

#endif
