// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes a panel's images of quilts that follow each other, with tables that are made once.
#ifndef INTEGRAL_PANEL_QUILT_SEQUENCE_H
#define INTEGRAL_PANEL_QUILT_SEQUENCE_H

#include "integral/panel/blended_values.h"
#include "integral/panel/panel_images.h"

#include <mutex>
#include <string>
#include <vector>

namespace integral {

/// The image of each quilt equals that of PanelImages::image_of.
class QuiltSequence {
public:
    /// `video`: the name that gives the views (PanelImages::pictures_of_video). `form`: of all
    /// quilts, 8 bits and three channels. `images` must outlive this object, and make no other
    /// images meanwhile. Throws RequestError if a quilt has too few pixels, or as pictures_of_video
    /// does.
    QuiltSequence(PanelImages& images, const std::string& video, const Image& form);

    ViewGrid grid() const { return pictures_.grid; }

    /// The image sent to the panel. Several threads may call it at once.
    Image image_of(const Image& quilt) const;

private:
    Image light_of(const Image& quilt) const;

    const PanelImages& images_;
    const PanelPictures pictures_;
    const PanelMapping& mapping_;
    const bool in_light_;
    BlendedValues values_; ///< empty unless in_light_
    mutable std::mutex mutex_;
    mutable std::vector<Image> spare_; ///< of light_of: new memory takes longer than the table
};

} // namespace integral

#endif
