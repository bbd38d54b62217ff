// SPDX-License-Identifier: AGPL-3.0-or-later
// Samples area lights. POV-Ray divides an area light into quarters, and these again, as often as
// `adaptive` says, and further where the light differs. It takes the mean of all quarters, so that
// a point of a surface takes up to hundreds of shadow rays. A reconstructed frame takes the mean of
// many samples anyway (integral/lightfield/reconstruction.h). So where POV-Ray divides without
// looking, each sample takes two opposite quarters of the light at random, and one quarter of each
// of these from there on. The expected value is what POV-Ray computes.
#ifndef POVRAY_BACKEND_INTEGRALAREALIGHTS_H
#define POVRAY_BACKEND_INTEGRALAREALIGHTS_H

#include <cstdint>

namespace pov
{

class SceneData;

/// One thread's random choices. Those of the samples of one pixel are well distributed over a
/// light.
class IntegralAreaLights
{
public:
    /// Whether a scene has area lights that POV-Ray divides without looking.
    static bool Of_Use(const SceneData& scene);

    /// Begins a sample: number `index` of the set of samples (those of a pixel) that `key` names.
    void Begin(std::uint64_t key, std::uint32_t index)
    {
        samples = true;
        sample_key = key;
        sample_index = index;
        shadows = 0;
    }

    /// Until Begin is called, rays see all of each light.
    void See_All() { samples = false; }
    bool Samples() const { return samples; }

    /// Begins the choices for the sample's next shadow.
    void Begin_Shadow();

    /// A quarter of the light: the first or the second half along both of its sides.
    struct Quarter
    {
        bool u, v;
        Quarter Opposite() const { return {!u, !v}; }
    };
    /// The next choice.
    Quarter Choose();

private:
    bool samples = false;
    std::uint64_t sample_key = 0;
    std::uint32_t sample_index = 0, shadows = 0;
    double u = 0, v = 0; ///< where on the part of the light that is left, 0 to 1
};

}

#endif
