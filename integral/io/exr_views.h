// SPDX-License-Identifier: AGPL-3.0-or-later
// Selects the channels of an OpenEXR file that are its picture: in one of its layers, in one of its
// parts, or in each of its views. To be included only by the OpenEXR codec.
#ifndef INTEGRAL_IO_EXR_VIEWS_H
#define INTEGRAL_IO_EXR_VIEWS_H

#include <ImfHeader.h>

#include <string>
#include <vector>

namespace integral {

/// The channels of a picture in a file.
struct ExrView {
    int part = 0;
    std::string name;                  ///< of the view, "left"; empty if the file names none
    std::vector<std::string> channels; ///< R, G, B (for a grey picture Y three times), maybe A
};

struct ExrViews {
    std::vector<ExrView> views; ///< the leftmost first; at least one
    std::string notice; ///< a sentence for the user about layers and further parts, or empty
};

/// `headers`: of all parts. Channels without a layer's name take precedence; otherwise the only
/// layer is used, or the only one with a picture's name ("beauty", "Combined"). Throws
/// std::runtime_error, with the layers' names, if none of these exists.
ExrViews exr_views(const std::vector<Imf::Header>& headers);

} // namespace integral

#endif
