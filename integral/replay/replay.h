// SPDX-License-Identifier: AGPL-3.0-or-later
// Computes the picture that an eye sees when it looks at a frame through its lens sheet.
#ifndef INTEGRAL_REPLAY_REPLAY_H
#define INTEGRAL_REPLAY_REPLAY_H

#include "integral/base/parallel.h"
#include "integral/frame/frame.h"

namespace integral {

/// An eye: a point in front of the sheet, mm from the sheet's centre. Outside the viewing zone it
/// sees side lobes.
struct Eye {
    double x = 0, y = 0;
    double distance = 0; ///< in front of the sheet, > 0
};

/// A rectangle of the sheet, mm: its middle relative to the sheet's centre (y upwards), and its
/// size. A size of 0 by 0 means the whole film.
struct SheetPart {
    Vec2 middle;
    double width = 0, height = 0;
};

/// One view: the picture of a perspective camera at the eye whose image plane is a rectangle of the
/// sheet, divided into equal pixels.
struct View {
    Eye eye;                   ///< the pupil's centre
    int width = 0, height = 0; ///< pixels, > 0
    int samples = 3;           ///< samples x samples per pixel, averaged in linear light; > 0
    double pupil = 0;    ///< diameter of the pupil, parallel to the sheet, mm, >= 0; 0: a pinhole
    double focus = 0;    ///< distance behind the sheet of the plane in focus, mm, > -distance
    double film_gap = 0; ///< distance of the film behind the lenses' focal plane, mm, > -thickness
                         ///< (thesis 4.2)
    double blur = 0;     ///< diameter of the uniform spot on the film from which a point of a lens
                         ///< gathers light, mm, >= 0
    /// pinhole and extended_pinhole: ideal lenses. full: refraction at the curved surface, with
    /// aberrations and with light from neighbouring lenses' pixels. hybrid is not allowed.
    LensModel model = LensModel::extended_pinhole;
    SheetPart part = {};
};

/// The eye at the aperture's centre, from which the frame shows the scene's perspective picture.
Eye centre_eye(const FrameMetadata& metadata);

/// Sets the view to what a person sees of a print: the pupil of an indoor eye, and a blur that
/// combines the lenses' aberrations (LensModel::full) with, unless the film has subpixels, the
/// spread of printed dots. Keeps values that are not 0.
void set_as_seen(View& view, const FrameMetadata& metadata);

/// Samples across a pixel that a view needs by default: more with a pupil or blur.
constexpr int plain_samples = 3, scattered_samples = 8;
inline int default_samples(const View& view)
{
    return view.pupil > 0 || view.blur > 0 ? scattered_samples : plain_samples;
}

/// Sets the view's width and height to the aspect of its part of the sheet, with `longer` pixels on
/// the longer side.
void set_view_size(View& view, const Film& film, int longer);

/// The view of a frame that has metadata. The picture has the frame's sample type, encoding and
/// alpha channel; it is black (or transparent) where the line of sight misses the film or no light
/// of the film reaches the eye.
/// - A sample of the view gets the colour of one film pixel, without interpolation. On a film with
///   subpixels each colour channel comes from the pixel whose subpixel of that colour is nearest,
///   as for an eye that does not resolve the subpixels; alpha is the mean over these pixels. The
///   film's edges are the same for all channels.
/// - With a pupil, each sample of a pixel uses another point of the pupil; with blur, another point
///   of the spot.
/// - The model full needs a sheet with a surface (has_surface).
/// `threads`: 0 for one per core; the result does not depend on it. Returns nothing if `progress`
/// stopped the work.
std::optional<Image> replay(const Frame& frame, const View& view, int threads = 0,
                            const Progress& progress = {});

} // namespace integral

#endif
