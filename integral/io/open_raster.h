// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads OpenRaster files (.ora), in which painting programs exchange pictures of layers: a ZIP of
// PNGs, and of an XML file that says how they lie on each other.
#ifndef INTEGRAL_IO_OPEN_RASTER_H
#define INTEGRAL_IO_OPEN_RASTER_H

#include "integral/io/codecs.h"
#include "integral/io/layer_stack.h"

namespace integral {

/// Whether a file begins as OpenRaster files do.
bool is_open_raster(const InputFile& file);

class OpenRaster {
public:
    /// Reads the list of layers, but no picture. The file may be closed afterwards. Throws
    /// std::runtime_error if it is not valid.
    explicit OpenRaster(const InputFile& file);

    /// The visible layers and groups of layers, the lowest first, by their names in the painting
    /// program. What is inside a group does not count by itself.
    std::vector<std::string> names() const;

    /// The layer with that index alone, transparent where it does not cover the canvas. Throws
    /// std::runtime_error if it is blended other than by covering what is below.
    std::unique_ptr<RowReader> layer(std::size_t index) const;

    /// All layers as the painting program shows them, from the file's own merged picture. Throws
    /// std::runtime_error if there is none.
    std::unique_ptr<RowReader> merged() const;

private:
    struct Archive;
    class LayerReader;

    std::shared_ptr<const Archive> archive_;
    std::vector<StackedLayer> layers_; ///< the visible ones, the lowest first
    int width_ = 0, height_ = 0;
};

} // namespace integral

#endif
