// SPDX-License-Identifier: AGPL-3.0-or-later
// Fits a picture to a target of another shape, without stretching unless requested. A shape is a
// width divided by a height, as displayed.
#ifndef INTEGRAL_FRAME_PICTURE_FIT_H
#define INTEGRAL_FRAME_PICTURE_FIT_H

#include "integral/optics/film.h"

#include <string>

namespace integral {

enum class Fit {
    contain, ///< the whole picture, centred, with bars at two sides of the target
    cover,   ///< the whole target is filled, two sides of the picture are cut off
    stretch  ///< the picture is made as wide and as high as the target
};

/// A picture on its target.
struct FittedPicture {
    Fit fit = Fit::contain;
    double shape = 1, target = 1; ///< shapes of the picture and of the target
    Vec2 size{1, 1}; ///< of the picture, in widths and heights of the target; same centre

    /// Whether the shapes differ by more than 1%. Else the picture fills the target.
    bool differs() const;

    /// Converts a place on the target to one on the picture, both as fractions of width and height
    /// from the top left. Outside 0 to 1 there is no picture.
    Vec2 picture_place(Vec2 target_place) const;

    /// Whether a place on the target is in a bar.
    bool is_in_bar(Vec2 target_place) const;
};

/// picture_place along one side. `size`: the picture's, as a fraction of the target's.
double part_of_picture(double part_of_target, double size);

/// Fits a picture of shape `shape` to a target of shape `target`, both > 0.
FittedPicture fitted(double shape, double target, Fit fit);

/// The factor by which a rectangle is enlarged so that it fits into another or, with Fit::cover,
/// fills it. Not for Fit::stretch.
double enlargement(Vec2 size, Vec2 rectangle, Fit how);

/// Width divided by height of a film.
double shape_of(const Film& film);

/// The film that a picture of width x height pixels becomes when it is fitted to `film`.
Film pixels_on(const Film& film, const FittedPicture& picture, int width, int height);

/// Describes the fit in a sentence that continues the picture's name: "its shape (width/height) is
/// 1.5, and the panel's 0.75: ...". `target`: the target's name in the sentence, such as "the
/// panel"; `bars`: the name of Fit::contain's bars.
std::string fit_text(const FittedPicture& picture, const std::string& target,
                     const std::string& bars = "black bars");

} // namespace integral

#endif
