// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes frames for any sheet, and pictures in focus at any depth, from a relief.
#ifndef INTEGRAL_DEPTH_RELIEF_FRAME_H
#define INTEGRAL_DEPTH_RELIEF_FRAME_H

#include "integral/depth/relief.h"
#include "integral/frame/picture_fit.h"

#include <mutex>
#include <string>

namespace integral {

/// Counts of the lines of sight that a picture needed.
struct ReliefFigures {
    double lines = 0; ///< all
    double holes = 0; ///< lines whose end no view shows: filled in from farther off
};

/// The mean light along lines of sight, which are counted.
class MeanSeen {
public:
    /// `lines`: the number of lines that the light is divided by.
    MeanSeen(int lines, ReliefFigures& figures) : weight_(1 / float(lines)), figures_(figures) {}

    void add(const Seen& seen)
    {
        figures_.lines += 1;
        figures_.holes += seen.known ? 0 : 1;
        light_.r += weight_ * seen.light.r;
        light_.g += weight_ * seen.light.g;
        light_.b += weight_ * seen.light.b;
    }
    const Colour& light() const { return light_; }

private:
    float weight_;
    ReliefFigures& figures_;
    Colour light_{0, 0, 0, 1};
};

/// Adds up rows' figures, from several threads.
class ReliefTally {
public:
    void add(const ReliefFigures& row);
    const ReliefFigures& all() const { return all_; }

private:
    std::mutex mutex_;
    ReliefFigures all_;
};

/// A sentence with the share of the lines of sight that had to be filled.
std::string holes_text(const ReliefFigures& figures);

/// Writes the frame with `geometry` that shows the relief, in the form of `form`, a band of rows at
/// a time. `fit`, contain or cover, sets the relief's size; contain leaves black bars. Each lens
/// gathers the light of its whole cell: at one point, or at up to 4 x 4 points if the relief's
/// pixels are smaller than the cell. Pixels that image nothing are black (transparent). Throws
/// OutputError, Interrupted.
ReliefFigures write_relief_frame(const std::string& path, Relief relief,
                                 const FrameMetadata& geometry, const Image& form, Fit fit,
                                 int threads, const Progress& progress);

/// A camera lens in front of the relief.
struct Refocus {
    double focus = 0;          ///< depth in focus, mm behind the image plane, > -distance
    double pupil = 0;          ///< the lens's diameter, mm, >= 0; 0: all is sharp
    int width = 0, height = 0; ///< pixels of the picture, > 0
};

/// A picture, and its figures.
struct RefocusedPicture {
    Image image;
    ReliefFigures figures;
};

/// The picture that a lens in the middle of the eyes' plane takes of the rectangle of the relief's
/// pictures: the mean of 64 lines of sight a pixel, in the form of `form`. Throws Interrupted.
RefocusedPicture refocused(const Relief& relief, const Refocus& lens, const Image& form,
                           int threads, const Progress& progress);

} // namespace integral

#endif
