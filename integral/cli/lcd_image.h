// SPDX-License-Identifier: AGPL-3.0-or-later
// The part of integral lcd that makes panel images: of frames, quilts and views, and test cards.
#ifndef INTEGRAL_CLI_LCD_IMAGE_H
#define INTEGRAL_CLI_LCD_IMAGE_H

#include "integral/cli/command.h"
#include "integral/lightfield/frame.h"
#include "integral/output/interlace.h"
#include "integral/output/panel.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

void add_panel_options(options::options_description& all);

/// Refuses options that make no sense together. Throws UsageError.
void check_panel_options(const options::variables_map& arguments);

/// The panel of --panel, seen from --viewing-distance. Throws UsageError, InputError.
Panel panel_of(const options::variables_map& arguments);

/// Makes images for one panel; what it works out once serves all of them.
class PanelImages {
public:
    PanelImages(const options::variables_map& arguments, const Panel& panel);

    /// The inputs taken together that make one image each: files of views, or a frame or a quilt
    /// alone. Throws UsageError, InputError.
    std::vector<std::vector<std::string>> groups(const std::vector<std::string>& inputs) const;

    /// The panel's image of one group, with its frame's geometry unless it is mirrored. Throws
    /// UsageError, InputError, Interrupted.
    Frame image_of(const std::vector<std::string>& group);

    /// The test card of --card.
    Frame card();

    int views() const
    {
        return views_;
    } ///< of which the last image was made; 0: none, it was native

private:
    Image interlaced(std::vector<Image> views, ViewGrid grid, std::optional<EyeGrid> eyes,
                     Blend blend);
    Frame finished(Image image, std::optional<Aperture> zone = std::nullopt) const; ///< `zone`:
                                                                                    ///< where not
                                                                                    ///< the panel's

    const options::variables_map& arguments_;
    Panel panel_;
    FrameMetadata geometry_;
    int threads_, views_ = 0;
    std::optional<PublishedMapping> published_;
    std::optional<RayMapping> rays_;
    EyeGrid rays_eyes_;
};

} // namespace integral

#endif
