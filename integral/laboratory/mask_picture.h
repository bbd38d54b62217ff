// SPDX-License-Identifier: AGPL-3.0-or-later
// Pictures from which lens sheets are made: masks for photo-sculpting, height maps for printing.
#ifndef INTEGRAL_LABORATORY_MASK_PICTURE_H
#define INTEGRAL_LABORATORY_MASK_PICTURE_H

#include "integral/base/parallel.h"
#include "integral/frame/image.h"
#include "integral/laboratory/lens_shape.h"
#include "integral/laboratory/response.h"
#include "integral/optics/film.h"

#include <optional>

namespace integral {

enum class MaskKind {
    greyscale, ///< grey by the response: white is exposed most, and sculpted deepest
    relief,    ///< a height map: white is highest, black the cells' deepest corners
    spinning   ///< of one lens, black and white: its mean over a turn about the pole is the mask
};

struct MaskRequest {
    LensSheet sheet;
    LensShape shape;
    MaskKind kind = MaskKind::greyscale;
    Film film;             ///< the picture's pixels; in the sheet frame, as a frame's film
    double from_depth = 0; ///< mm: depth of the poles in the process
    std::optional<Response> response; ///< none: linear, from the poles to the deepest corners
    bool negative = false;            ///< black and white exchanged
    int bits = 16;                    ///< 8 or 16
};

/// Fits the film to one lens's cell, upright and in the sheet's middle.
void show_one_lens(MaskRequest& request);

/// Grey (0 to 1) of the mask at a point. Throws std::invalid_argument where the response does not
/// cover the depths of the lenses.
class MaskGrey {
public:
    explicit MaskGrey(const MaskRequest& request);
    double at(Vec2 point) const; ///< of the sheet frame
    const SheetRelief& relief() const { return relief_; }

private:
    double grey_of(double depth) const;

    const MaskRequest& request_;
    SheetRelief relief_;
    Response response_;
    Vec2 pole_;
};

/// A picture of one channel, whose samples are the greys themselves. Returns nothing if `progress`
/// stopped the work. Throws as MaskGrey does.
std::optional<Image> mask_picture(const MaskRequest& request, int threads,
                                  const Progress& progress);

} // namespace integral

#endif
