// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/picture_fit.h"

#include "integral/base/number_text.h"

#include <cmath>

namespace integral {
static constexpr double tolerance = 0.01;

double part_of_picture(double part, double size)
{
    return size == 1 ? part : (part - 0.5) / size + 0.5;
}

bool FittedPicture::differs() const { return std::fabs(std::log(shape / target)) > tolerance; }

Vec2 FittedPicture::picture_place(Vec2 place) const
{
    return {part_of_picture(place.x, size.x), part_of_picture(place.y, size.y)};
}

bool FittedPicture::is_in_bar(Vec2 place) const
{
    // Along a side that fills the target there are no bars: places beyond the target's edge count
    // as picture.
    const Vec2 at = picture_place(place);
    return (size.x < 1 && !(at.x >= 0 && at.x <= 1)) || (size.y < 1 && !(at.y >= 0 && at.y <= 1));
}

double enlargement(Vec2 size, Vec2 rectangle, Fit how)
{
    const double across = rectangle.x / size.x, up = rectangle.y / size.y;
    return how == Fit::cover ? std::max(across, up) : std::min(across, up);
}

FittedPicture fitted(double shape, double target, Fit fit)
{
    FittedPicture picture{fit, shape, target, {1, 1}};
    if (!picture.differs() || fit == Fit::stretch)
        return picture;
    const double wider = shape / target;
    if ((wider > 1) == (fit == Fit::contain))
        picture.size.y = 1 / wider;
    else
        picture.size.x = wider;
    return picture;
}

double shape_of(const Film& film)
{
    return film.width * film.pixel_pitch.x / (film.height * film.pixel_pitch.y);
}

Film pixels_on(const Film& film, const FittedPicture& picture, int width, int height)
{
    const Vec2 size = size_of(film);
    return {width, height, {picture.size.x * size.x / width, picture.size.y * size.y / height}};
}

std::string fit_text(const FittedPicture& picture, const std::string& target,
                     const std::string& bars)
{
    const bool wider = picture.shape > picture.target;
    const std::string shapes = "its shape (width/height) is " + with_digits(picture.shape, 3) +
                               ", and " + target + "'s " + with_digits(picture.target, 3) + ": ";
    if (picture.fit == Fit::stretch)
        return shapes + "it is stretched to " +
               with_digits(wider ? picture.shape / picture.target : picture.target / picture.shape,
                           3) +
               " times its " + (wider ? "height" : "width");
    if (picture.fit == Fit::cover)
        return shapes + "its " + (wider ? "left and right" : "top and bottom") +
               " are cut off; --fit contain shows all of it";
    return shapes + "it has " + bars + (wider ? " above and below" : " at the left and right") +
           "; --fit cover fills " + target;
}

} // namespace integral
