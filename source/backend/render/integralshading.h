// SPDX-License-Identifier: AGPL-3.0-or-later
// Shares shading between rays of different lenses. Many beams, especially of neighbouring lenses,
// meet the same small patch of a surface. The colour of a patch is computed once, at one point of
// it, and used for all rays that meet it. If the colour also depends on the ray (highlights,
// mirrors, glass), only the light that reaches the patch from each light source is shared.
// Visibility is not shared: each ray finds its own surface.
//
// A patch is the part of one object's surface inside a cell of a cubic grid, whose cell size
// follows from the beams' width at that depth. The point at which a patch is shaded depends only on
// the patch, not on the ray that meets it first, so that the frame does not depend on the order in
// which pixels are rendered.
#ifndef POVRAY_BACKEND_INTEGRALSHADING_H
#define POVRAY_BACKEND_INTEGRALSHADING_H

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <unordered_map>
#include <vector>

#include "backend/frame.h"
#include "backend/render/integralshadingcache.h"

namespace pov
{

class SceneData;
class Trace;
class TraceThreadData;
struct ThreadCounters;

/// One thread's use of the patches.
class IntegralCachedShading
{
public:
    IntegralCachedShading(IntegralShadingCache& patches, ThreadCounters& tally,
                          TraceThreadData *thread);

    /// Whether a scene's shading costs much more than looking up a patch: whether the scene has radiosity or
    /// an area light. Point lights do not count, whatever their number, because the patches' errors may then
    /// outweigh the time saved.
    static bool Pays(const SceneData& scene);

    /// Sets `colour` to the shared colour of the surface that a ray meets and returns true; returns
    /// false if the colour may not be shared. `shade(Intersection&, const Ray&, Colour&)` computes
    /// the colour of a patch's point.
    template <class Shade>
    bool Colour_Of(Intersection& isect, const Ray& ray, Trace& trace, Colour& colour, Shade shade);

    /// If a point of a surface is the last one for which Colour_Of returned false, reduces a light's
    /// colour to the part that reaches the point, and returns true. `test(const Vector3d& at,
    /// RGBColour& full, RGBColour& left)` computes the light at a patch's point without and with
    /// shadows.
    template <class Test>
    bool Light_Of(int light, const Vector3d& point, const ObjectBase *object, Trace& trace,
                  RGBColour& colour, Test test);

private:
    /// Dependence of a texture's colour. steady: on the point only. own: also on the ray.
    enum Kind
    {
        steady,
        own
    };

    /// The patch that a ray meets.
    struct Place
    {
        std::uint64_t row;  ///< row in the table; the same in every run
        std::size_t column; ///< column in that row
        std::uint64_t key;
        std::uint64_t spot; ///< random bits for the patch's point; the same in every run
        int axis;           ///< axis of the normal's largest component
        bool positive;      ///< whether the visible side faces larger coordinates
        bool inside;        ///< whether that side is the object's inside
        double size;        ///< size of the patch, scene units
        double centre[3];   ///< centre of the patch
    };

    /// A surface that is being lit.
    struct Lit
    {
        Intersection isect;
        bool located = false;
        Place place;
    };

    static bool May_Share(const Ray& ray);
    bool Side_Seen(Intersection& isect, const Ray& ray, VECTOR normal) const;
    bool Locate(const Intersection& isect, const VECTOR normal, bool inside, int coarser,
                Place& place) const;
    static Place Of_Light(const Place& place, int light);
    /// The position of a patch's point on the patch's axis, from the middle, in patch sizes. The
    /// patch's note holds it, or NaN if the patch has no point.
    static float Height_Of(const Intersection& at, const Place& place);
    static bool On_Patch(const IntegralShadingCache::Patch& patch, const Place& place,
                         const Intersection& isect);
    /// Gets the patch of a place. If it is not in the table, it is computed first: `look(const
    /// Ray&, Intersection&)` fills in the colour at its point and returns whether it is valid.
    /// Returns false if the surface at the intersection does not belong to the patch.
    template <class Look>
    bool Take(const Place& place, const Intersection& isect, Trace& trace,
              IntegralShadingCache::Patch& patch, Look look);
    bool Put(const Place& place, const Intersection& isect, Trace& trace, Ray& ray,
             Intersection& at) const;
    Kind Kind_Of(const Intersection& isect, bool inside);
    static Kind Kind_Of(const TEXTURE *texture);
    Kind Known_Kind_Of(const TEXTURE *texture);
    void Count(bool worked_out);

    IntegralShadingCache& patches;
    ThreadCounters& tally;
    TraceThreadData *thread;
    std::unordered_map<const TEXTURE *, Kind> kinds;
    Lit lit;
};

}

#endif
