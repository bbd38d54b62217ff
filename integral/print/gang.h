// SPDX-License-Identifier: AGPL-3.0-or-later
// Arranges several frames on one page behind one lens sheet (ganging: "6-up"), so that the sheet's
// lenses lie on every frame's own.
#ifndef INTEGRAL_PRINT_GANG_H
#define INTEGRAL_PRINT_GANG_H

#include "integral/print/page.h"

#include <string>
#include <vector>

namespace integral {

struct GangRequest {
    PixelSize room;    ///< for all frames together
    double gap = 8;    ///< mm, least distance between neighbouring frames
    bool fill = false; ///< repeat the frames as long as there is room
};

/// Frames in rows, as one picture.
struct Gang {
    FrameMetadata metadata; ///< of the picture: its film holds all frames, its lenses are those
                            ///< of the common sheet
    std::vector<PixelRectangle> places; ///< of each frame in the picture
    int rows = 0;
    double largest_error = 0; ///< mm between a frame's lenses and the common sheet's
};

/// Describes in what the sheets and films of two frames differ, so that they cannot share a lens
/// sheet: "pitch: 1.27 and 1 mm". Empty if they can.
std::string sheet_difference(const FrameMetadata& a, const FrameMetadata& b);

/// Places frames from left to right in rows from the top, each as near to its neighbours as the gap
/// and its lenses allow: the axes (poles) of its lenses must lie on those of the common sheet, to
/// half a pixel across and down. Frames must have the same sheet and pixels (sheet_difference);
/// only their sheets' offsets may differ. Throws std::invalid_argument if there is no room for all.
Gang gang(const std::vector<FrameMetadata>& frames, const GangRequest& request);

} // namespace integral

#endif
