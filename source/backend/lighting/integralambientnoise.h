// SPDX-License-Identifier: AGPL-3.0-or-later
// Includes the noise of radiosity's points in the error that an audit finds. Radiosity gathers
// light at some points; the ambient light of any other place is the weighted mean of the points
// around it. The points are noisy, and all samples of a frame share them, so that an audit, which
// renders some pixels again, meets the same noise as the frame. Therefore the audit changes the
// ambient light of each lookup by its standard error, estimated from the differences between the
// points: upwards or downwards, the same for all samples of a pixel.
//
// Only the noise of points gathered while the frame was rendered is included; points of the pretrace are
// taken as exact. If their noise were included, too, the error reported for some frames of POV-Ray's scene
// radiosity3 would be up to 1.45 times too large. As it is not, the reported error may be too small: 0.60 and
// 0.74 of the true one in tests/render/radiosity_noise.test.
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
    /// Sets the direction in which the following lookups are changed.
    void Set_Direction(bool brighter) { direction = brighter ? 1 : -1; }

    virtual void Begin();
    virtual void Add(const RGBColour& light, double weight, bool pretraced, double radius);

    /// Changes the mean of the points' light by its standard error, but no light to less than 0.
    virtual void End(RGBColour& mean);

private:
    double direction = 1;
    double weights = 0, squared_weights = 0; ///< sums over all points
    double new_squared_weights = 0;          ///< sum over the points that are not pretraced
    /// Sums, over the points that are not pretraced, of light and squared light times squared weight.
    std::array<double, 3> sums{}, squares{};
};

}

#endif
