// SPDX-License-Identifier: AGPL-3.0-or-later
// Shading that is worked out once for all lenses. Many beams, of neighbouring lenses above all,
// cross the same small patch of a surface. What such a patch looks like is worked out once, at one
// point of it, and taken by all rays that meet it; where that depends on more than the point
// (highlights, mirrors, glass), what the point gets of each light. Visibility is not shared: each
// ray finds its own surface.
//
// Patches are the cells of cubic grids, as fine as the beams at that depth ask for, cut out of one
// object's surface. A patch's point follows from the patch alone, not from the ray that comes
// first: the frame does not depend on the order in which pixels are rendered.
#ifndef POVRAY_BACKEND_INTEGRALSHADING_H
#define POVRAY_BACKEND_INTEGRALSHADING_H

#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <unordered_map>
#include <vector>

#include "backend/frame.h"
#include "integral/optics/camera.h"

namespace pov
{

class SceneData;
class Trace;
class TraceThreadData;
struct IntegralTally;

/// The patches of a view, shared by its threads: a table whose size follows from the frame's, in
/// which new patches displace old ones.
class IntegralShadingCache
{
public:
    /// `cells`: patches that a pixel's beam covers, about; their size follows from it.
    IntegralShadingCache(const integral::IntegralCamera& camera, double cells);

    struct Patch
    {
        std::uint64_t key = 0;  ///< 0: none
        float red, green, blue; ///< its colour; or of a light, the parts that reach it
        float height; ///< of its point along the patch's axis, from the patch's middle, in patch
                      ///< sizes; NaN: it has none
    };

    /// The patch of that key, kept at that slot if anywhere; false: it is not there.
    bool Find(std::size_t slot, std::uint64_t key, Patch& patch) const;
    void Store(std::size_t slot, const Patch& patch);

    /// The slot for a row, any number, and a column.
    std::size_t Slot(std::uint64_t row, std::size_t column) const;

    /// The patches' size at a point of the scene: a step of a scale on which each is 2^(1/2) times
    /// the one before.
    int Level(const VECTOR point) const;
    static double Size(int level); ///< scene units

    /// Steps of that scale by which patches may be larger for what they get of a light: no pigment
    /// and no highlight is in it. No larger than a beam, though.
    int Coarser_For_Lights() const;

    /// Whether patches at the sheet are large against POV-Ray's tolerances.
    bool Of_Use() const;

private:
    integral::IntegralCamera camera;
    double spread, cells, scale;
    std::vector<Patch> patches;
    mutable std::vector<std::atomic_flag> locks; ///< one for each row of slots
};

/// One thread's use of the patches.
class IntegralCachedShading
{
public:
    IntegralCachedShading(IntegralShadingCache& patches, IntegralTally& tally,
                          TraceThreadData *thread);

    /// Whether a scene's shading costs much more than finding the patch: radiosity or an area
    /// light. Point lights, however many, do not count: patches' errors may then outweigh the time
    /// that they save.
    static bool Pays(const SceneData& scene);

    /// The colour of the surface that a ray meets, if it may be shared. `shade(Intersection&, const
    /// Ray&, Colour&)` works out the colour of a patch's point.
    template <class Shade>
    bool Colour_Of(Intersection& isect, const Ray& ray, Trace& trace, Colour& colour, Shade shade);

    /// Takes from a light's colour what does not reach a point of a surface, if that point was the
    /// last one for which Colour_Of was asked in vain. `test(const Vector3d& at, RGBColour& full,
    /// RGBColour& left)` works out what a patch's point would get and what it gets.
    template <class Test>
    bool Light_Of(int light, const Vector3d& point, const ObjectBase *object, Trace& trace,
                  RGBColour& colour, Test test);

private:
    /// What a texture's colour depends on. steady: the point alone. own: more.
    enum Kind
    {
        steady,
        own
    };

    /// Where a ray meets which patch.
    struct Place
    {
        std::uint64_t row;  ///< of the table; the same in every run
        std::size_t column; ///< in that row
        std::uint64_t key;
        std::uint64_t spot; ///< random bits that are the patch's own in every run
        int axis;           ///< the normal's largest component
        bool positive;      ///< the side of the surface that is seen: towards larger coordinates
        bool inside;        ///< that side is the object's inside
        double size;        ///< of the patch, scene units
        double centre[3];   ///< of the patch
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
    static float Height_Of(const Intersection& at, const Place& place);
    static bool On_Patch(const IntegralShadingCache::Patch& patch, const Place& place,
                         const Intersection& isect);
    /// The patch of a place, worked out now if need be: `look(const Ray&, Intersection&)` fills in
    /// its colour at its point, and tells whether it is of use. False: the surface there is not on
    /// the patch.
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
    IntegralTally& tally;
    TraceThreadData *thread;
    std::unordered_map<const TEXTURE *, Kind> kinds;
    Lit lit;
};

}

#endif
