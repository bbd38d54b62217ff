// SPDX-License-Identifier: AGPL-3.0-or-later
// Samples area lights. POV-Ray divides an area light into quarters, and these again, as often as
// `adaptive` specifies, and further where the light differs. It averages all quarters, so that a
// point of a surface needs up to hundreds of shadow rays. A reconstructed frame averages many
// samples anyway (integral/reconstruction/reconstruction.h). So in the divisions that POV-Ray
// always makes, each sample takes two opposite quarters of the light at random, and then one random
// quarter of each of these at every further division. The expected value is what POV-Ray computes.
#ifndef POVRAY_BACKEND_INTEGRALAREALIGHTS_H
#define POVRAY_BACKEND_INTEGRALAREALIGHTS_H

#include <cstdint>

namespace pov
{

class SceneData;

/// One thread's random choices. The choices for one pixel's samples are well distributed over a
/// light.
class IntegralAreaLights
{
public:
    /// Whether a scene has area lights that POV-Ray always divides.
    static bool Of_Use(const SceneData& scene);

    /// Begins sample `index` of a set of samples, such as a pixel's; `key` identifies the set.
    void Begin(std::uint64_t key, std::uint32_t index)
    {
        samples = true;
        sample_key = key;
        sample_index = index;
        shadows = 0;
    }

    /// Makes rays see all of each light until Begin is called.
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
    /// Returns the next choice.
    Quarter Choose();

private:
    bool samples = false;
    std::uint64_t sample_key = 0;
    std::uint32_t sample_index = 0, shadows = 0;
    double u = 0, v = 0; ///< position on the remaining part of the light, 0 to 1
};

}

#endif
