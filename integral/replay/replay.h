// SPDX-License-Identifier: AGPL-3.0-or-later
// What an eye sees of a frame through its lens sheet.
#ifndef INTEGRAL_REPLAY_REPLAY_H
#define INTEGRAL_REPLAY_REPLAY_H

#include "integral/base/parallel.h"
#include "integral/lightfield/frame.h"

namespace integral {

/// An eye: a point in front of the sheet, mm from the sheet's centre. It may be anywhere, in the
/// viewing zone or beyond it, where it sees side lobes.
struct Eye {
    double x = 0, y = 0;
    double distance = 0; ///< in front of the sheet, > 0
};

/// A rectangle of the sheet, mm: its middle, from the sheet's centre (y upwards), and its size. 0
/// by 0: all of the film's.
struct SheetPart {
    Vec2 middle;
    double width = 0, height = 0;
};

/// One view. Its pixels divide a rectangle of the sheet evenly: the picture that a perspective
/// camera at the eye takes with its window laid on the sheet.
struct View {
    Eye eye;                   ///< the pupil's centre
    int width = 0, height = 0; ///< pixels, > 0
    int samples = 3;           ///< across a pixel and down it, averaged in linear light; > 0
    double pupil = 0;    ///< diameter, mm, >= 0; the pupil is parallel to the sheet. 0: a pinhole
    double focus = 0;    ///< z of the plane, parallel to the sheet, that the eye sees sharply: mm
                         ///< behind the sheet, > -distance
    double film_gap = 0; ///< mm by which the film lies farther from the lenses than their focus; >
                         ///< -thickness (thesis 4.2)
    double blur = 0; ///< diameter of the even spot on the film that a point of a lens gathers light
                     ///< from, mm, >= 0
    /// pinhole and extended_pinhole: ideal lenses. full: the curved surface's own refraction, its
    /// aberrations and the light that reaches neighbouring lenses' pixels. hybrid is not for the
    /// eye.
    LensModel model = LensModel::extended_pinhole;
    SheetPart part = {};
};

/// The eye from which the frame shows the scene's own perspective picture: the aperture's centre.
Eye centre_eye(const FrameMetadata& metadata);

/// Size of a view of the shape of its part of the sheet, whose longer side has `longer` pixels.
void set_view_size(View& view, const Film& film, int longer);

/// The view of a frame that has metadata, 8, 16 or 32 bits and encoded like the frame, with alpha
/// if the frame has it. Where the eye looks past the film's edge it sees black (transparent). The
/// frame's pixels are boxes: what a view sample sees is one pixel's colour. Of a film with
/// subpixels each colour channel's pixels are such boxes, a pixel wide, centred at their own
/// stripes: what an eye sees that does not tell the stripes apart. The film's edges stay where they
/// are; alpha is the mean of the three stripes' pixels. With a pupil each of a pixel's samples is
/// seen from a point of its own of the pupil's area; with blur each sees a point of its own of the
/// spot. full: the sheet needs a surface (has_surface). Where no light of the film reaches the eye,
/// black as well. `threads` 0 is one per core; the result does not depend on it. Empty: `progress`
/// stopped it.
std::optional<Image> replay(const Frame& frame, const View& view, int threads = 0,
                            const Progress& progress = {});

} // namespace integral

#endif
