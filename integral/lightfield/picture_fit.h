// SPDX-License-Identifier: AGPL-3.0-or-later
// Brings a picture onto a target of another shape, so that nothing is stretched unless it is asked
// for. A shape is a width divided by a height, as they are seen.
#ifndef INTEGRAL_LIGHTFIELD_PICTURE_FIT_H
#define INTEGRAL_LIGHTFIELD_PICTURE_FIT_H

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
    double shape = 1, target = 1; ///< of the picture and of the target
    Vec2 size{1, 1}; ///< of the picture, in widths and heights of the target; both are centred

    /// Whether the shapes differ by more than 1%. Else the picture fills the target.
    bool differs() const;

    /// A place on the target as one on the picture, both in parts of the width and height from the
    /// top left. Outside of 0 to 1 there is no picture.
    Vec2 picture_place(Vec2 target_place) const;

    /// Whether a place on the target is beside the picture: in a bar.
    bool is_in_bar(Vec2 target_place) const;
};

/// A place along one side of the target as one along the picture, whose size is in parts of the
/// target's, as picture_place has it.
double part_of_picture(double part_of_target, double size);

/// Fits a picture of one shape, > 0, on a target of another.
FittedPicture fitted(double shape, double target, Fit fit);

/// Width divided by height of a film.
double shape_of(const Film& film);

/// The pixels of a picture that lies so on a film, as a film of their own.
Film pixels_on(const Film& film, const FittedPicture& picture, int width, int height);

/// What was done, in a sentence that goes on after the picture's name: "its shape (width/height) is
/// 1.5, and the panel's 0.75: ...". `target` is the owner of the target's shape: "the panel";
/// `bars` what Fit::contain has beside the picture.
std::string fit_text(const FittedPicture& picture, const std::string& target,
                     const std::string& bars = "black bars");

} // namespace integral

#endif
