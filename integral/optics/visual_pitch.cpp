// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/visual_pitch.h"

#include <cmath>

namespace integral {

/// The displacement of the eye's image from the lens, outwards, divided by the lens's place.
static double image_displacement(const LensSheet& sheet, double distance, double place)
{
    const double m = (sheet.ior - 1) * (sheet.ior + 1);
    return sheet.thickness / std::hypot(sheet.ior * distance, std::sqrt(m) * place);
}

double visual_pitch(double pitch, const LensSheet& sheet, double distance, double place)
{
    return pitch * (1 + image_displacement(sheet, distance, place));
}

double pitch_of_visual(double visual, const LensSheet& sheet, double distance, double place)
{
    return visual / (1 + image_displacement(sheet, distance, place));
}

} // namespace integral
