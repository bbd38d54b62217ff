// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes the images that a panel is sent: of frames, quilts and views, and of test cards.
#ifndef INTEGRAL_OUTPUT_PANEL_IMAGES_H
#define INTEGRAL_OUTPUT_PANEL_IMAGES_H

#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"
#include "integral/output/given_views.h"
#include "integral/output/interlace.h"
#include "integral/output/panel.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace integral {

enum class PanelCard { views, crosstalk, colours, pitch };

struct PanelImageOptions {
    /// How many views a quilt has, a frame is seen from, or a card shows. Nothing: as the quilt
    /// says; as many as pixels are nearest to a lens's; 8, or 4 x 4 behind round lenses.
    std::optional<ViewGrid> views;
    std::optional<double> aspect; ///< shape of given views, as in ViewsRequest
    bool right_to_left = false;   ///< given views stand from right to left
    Fit fit = Fit::contain;       ///< of frames and views of another shape than the panel's
    Blend blend;
    bool encoded = false;        ///< blend stored values, not linear light
    int width = 0, height = 0;   ///< of each view that is seen of a frame, pixels; 0: 1000 on the
                                 ///< longer side
    std::optional<int> lit_view; ///< of PanelCard::crosstalk and colours; nothing: every other; the
                                 ///< middle one
    int threads = 0;             ///< 0: one per core
    std::string panel_name = "the panel"; ///< how messages call it

    /// Is told, in a line each, what the user should know of an image that is made all the same.
    std::function<void(const std::string&)> tell = [](const std::string&) {};
    /// Makes the Progress of a long piece of work from its name.
    std::function<Progress(const char*)> progress = [](const char*) { return Progress(); };
};

/// Makes images for one panel; what it works out once serves all of them.
class PanelImages {
public:
    /// Throws RequestError where the panel is too large.
    PanelImages(const Panel& panel, PanelImageOptions options);

    /// Which inputs make one image together: the files of all views, or a frame or a quilt alone.
    /// Throws InputError.
    std::vector<std::vector<std::string>> groups(const std::vector<std::string>& inputs) const;

    /// The panel's image of one group, with the geometry of a frame unless the panel is mirrored.
    /// Throws RequestError, InputError, Interrupted.
    Frame image_of(const std::vector<std::string>& group);

    /// The panel's image of a test card. Throws RequestError.
    Frame card(PanelCard card);

    /// Of how many views the last image was made; 0: it was rendered for the panel.
    int views() const { return views_; }

private:
    std::optional<Frame> read_frame_of(const std::vector<std::string>& group) const;
    void check_directions(const std::string& name, const FrameMetadata& frame, ViewGrid grid) const;
    Frame image_of_views(const std::vector<std::string>& group);
    Frame image_of_frame(const std::string& name, const Frame& frame);
    Frame native_image(const std::string& name, const Frame& frame);
    Frame image_of_card(PanelCard card);
    Image interlaced(std::vector<Image> views, ViewGrid grid, std::optional<EyeGrid> eyes,
                     Blend blend, const FittedPicture& picture);
    void map_picture(const FittedPicture& picture, std::optional<EyeGrid> eyes);
    void map_through_lenses(std::optional<EyeGrid> eyes);
    FittedPicture fitted_to_panel(double shape) const;
    Image as_sent(const Image& upright) const;
    Frame finished(Image image, std::optional<Aperture> zone = std::nullopt) const;

    const Panel panel_;
    const PanelImageOptions options_;
    const FrameMetadata geometry_;
    int views_ = 0;
    std::optional<PanelMapping> mapping_;
    FittedPicture mapped_picture_;       ///< for which mapping_ is
    std::optional<EyeGrid> mapped_eyes_; ///< for which mapping_ is, where it is of the lenses
};

} // namespace integral

#endif
