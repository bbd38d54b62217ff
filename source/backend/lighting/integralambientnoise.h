// SPDX-License-Identifier: AGPL-3.0-or-later
// The noise of radiosity's points. Radiosity gathers light at some points and takes the weighted
// mean of those around as the ambient light of other places. The points are noisy, and all samples
// of a frame share them, so that an audit, which renders some pixels again, does not meet other
// noise than the frame did. Therefore it changes the ambient light of each lookup by its standard
// error, as the differences between the points show it: upwards or downwards, the same for all
// samples of a pixel. So the noise counts in the error that the audit finds.
//
// Only the points that were gathered while the frame was rendered count; those of the pretrace are
// taken as exact. If they counted, too, dense frames of POV-Ray's scene radiosity3 would be told up
// to 1.45 times their error. As they do not, other errors are told too low: by a quarter in
// tests/render/radiosity_noise.test.
#ifndef POVRAY_BACKEND_INTEGRALAMBIENTNOISE_H
#define POVRAY_BACKEND_INTEGRALAMBIENTNOISE_H

#include <array>

#include "backend/frame.h"
#include "backend/lighting/integralambient.h"

namespace pov
{

class IntegralAmbientNoise : public IntegralAmbient
{
public:
    /// In which direction the following lookups are changed.
    void Set_Direction(bool brighter) { direction = brighter ? 1 : -1; }

    virtual void Begin();
    virtual void Add(const RGBColour& light, double weight, bool pretraced, double radius);

    /// Changes the mean of the points' light by its standard error, but no light to less than 0.
    virtual void End(RGBColour& mean);

private:
    double direction = 1;
    double weights = 0, squared_weights = 0; ///< of all points
    double new_squared_weights = 0;          ///< of those that are not pretraced
    /// Sums of light and of its square, times the squared weight, of those that are not pretraced.
    std::array<double, 3> sums{}, squares{};
};

}

#endif
