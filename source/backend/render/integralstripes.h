// SPDX-License-Identifier: AGPL-3.0-or-later
// A panel's colour stripes as the pixels of a frame, which reconstruction takes: three pixels of a
// third of the width for each pixel of the panel, all with all colours. In the end each pixel takes
// each colour from the colour's own stripe.
#ifndef POVRAY_BACKEND_INTEGRALSTRIPES_H
#define POVRAY_BACKEND_INTEGRALSTRIPES_H

#include <memory>
#include <vector>

#include "backend/frame.h"
#include "base/image/colourspace.h"
#include "integral/reconstruction/pass_schedule.h"
#include "integral/optics/camera.h"

namespace pov
{

class IntegralStripes
{
public:
    /// Only `rgb` and `bgr` give stripes.
    explicit IntegralStripes(const integral::Subpixels& subpixels);

    /// Number of stripes in a pixel: 3, or 1 for a film without stripes.
    int Number() const { return number; }

    /// The camera whose pixels are the stripes; null for a film without stripes.
    std::shared_ptr<const integral::IntegralCamera> Camera_Of(
        const integral::IntegralCamera& camera) const;

    /// The stripes of a block of pixels.
    integral::PictureBlock Of(const integral::PictureBlock& block) const;

    /// Makes pixels of their stripes, which follow each other from left to right.
    void Merge(std::vector<Colour>& colours) const;

private:
    int number = 1;
    int red = 0; ///< the place of red's stripe in its pixel: 0 or 2
};

}

#endif
