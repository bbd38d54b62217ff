// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads stack.xml of an OpenRaster file: which layers lie on each other, and where.
#ifndef INTEGRAL_IO_LAYER_STACK_H
#define INTEGRAL_IO_LAYER_STACK_H

#include <string>
#include <vector>

namespace integral {

/// A layer, or a group of layers.
struct StackedLayer {
    std::string name;
    std::string source;    ///< name of its PNG in the file; empty for a group
    std::string blending;  ///< "svg:src-over": it covers what is below
    int left = 0, top = 0; ///< of its picture, or of the group's place, pixels
    double opacity = 1;    ///< 0 to 1
    bool visible = true;
    std::vector<StackedLayer> inside; ///< of a group, the highest first
};

struct LayerStack {
    int width = 0, height = 0; ///< of the canvas, pixels
    StackedLayer root;         ///< a group
};

/// Throws std::runtime_error, with the reason, for text that is no such list.
LayerStack layer_stack_of(const std::string& xml);

} // namespace integral

#endif
