// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes frames for any sheet, and pictures in focus at any depth, of a relief.
#ifndef INTEGRAL_DEPTH_RELIEF_FRAME_H
#define INTEGRAL_DEPTH_RELIEF_FRAME_H

#include "integral/depth/relief.h"
#include "integral/lightfield/picture_fit.h"

#include <string>

namespace integral {

/// Of the lines of sight that a picture needed.
struct ReliefFigures {
    double lines = 0; ///< number
    double holes = 0; ///< of what no view has seen: filled from farther off
};

/// What part of the lines of sight had to be filled, in a sentence.
std::string holes_text(const ReliefFigures& figures);

/// Writes the frame of that geometry which shows the relief, in the form of `form`, a band of rows
/// at a time. The relief is made as large as `fit` has it, contain or cover, of which contain
/// leaves black bars. A lens gathers the light of its whole cell, at up to 4 x 4 points where the
/// relief's pictures are finer than the lenses. Pixels that image nothing are black (transparent).
/// Throws OutputError, Interrupted.
ReliefFigures write_relief_frame(const std::string& path, Relief relief,
                                 const FrameMetadata& geometry, const Image& form, Fit fit,
                                 int threads, const Progress& progress);

/// A lens before the relief that takes its picture.
struct Refocus {
    double focus = 0;          ///< depth of what is sharp, mm behind the image plane, > -distance
    double pupil = 0;          ///< the lens's diameter, mm, >= 0; 0: all is sharp
    int width = 0, height = 0; ///< pixels of the picture, > 0
};

/// A picture, and its figures.
struct RefocusedPicture {
    Image image;
    ReliefFigures figures;
};

/// The picture that a lens before the middle of the eyes takes of what is seen through the
/// rectangle of the relief's pictures: the mean of 64 lines of sight a pixel, in the form of
/// `form`. Throws Interrupted.
RefocusedPicture refocused(const Relief& relief, const Refocus& lens, const Image& form,
                           int threads, const Progress& progress);

} // namespace integral

#endif
