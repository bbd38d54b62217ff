// SPDX-License-Identifier: AGPL-3.0-or-later
// Shading that is worked out once for all lenses. Many beams, of neighbouring lenses above all, cross the same small patch
// of a surface. What such a patch looks like is worked out once, at one point of it, and taken by all rays that meet it.
// Visibility is not shared: each ray finds its own surface.
//
// Patches are the cells of cubic grids, as fine as the beams at that depth ask for, cut out of one object's surface. A
// patch's point follows from the patch alone, not from the ray that comes first: the frame does not depend on the
// order in which pixels are rendered.
#ifndef POVRAY_BACKEND_INTEGRALSURFACES_H
#define POVRAY_BACKEND_INTEGRALSURFACES_H

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

/// The patches of a view, shared by its threads: a table of fixed size, in which new patches displace old ones.
class IntegralPatches
{
    public:
        /// `cells`: patches that a pixel's beam covers, about; their size follows from it.
        IntegralPatches(const integral::IntegralCamera& camera, double cells);

        struct Patch
        {
            std::uint64_t key = 0; ///< 0: none
            float red, green, blue;
            float height;          ///< of its point along the patch's axis, from the patch's middle, in patch sizes; NaN: it has none
        };

        /// The patch of that key, kept at that slot if anywhere; false: it is not there.
        bool Find(std::size_t slot, std::uint64_t key, Patch& patch) const;
        void Store(std::size_t slot, const Patch& patch);

        static constexpr std::size_t slots = std::size_t(1) << 20;

        /// The patches' size at a point of the scene: a step of a scale on which each is 2^(1/2) times the one before.
        int Level(const VECTOR point) const;
        static double Size(int level); ///< scene units

        /// The angle between neighbouring pixels of a lens, as a part of 1.
        double Spread() const { return spread; }

        /// Whether patches at the sheet are large against POV-Ray's tolerances.
        bool Of_Use() const;

    private:
        integral::IntegralCamera camera;
        double spread, cells, scale;
        std::vector<Patch> patches;
        mutable std::vector<std::atomic_flag> locks; ///< one for each row of slots
};

/// One thread's use of the patches.
class IntegralSurfaces
{
    public:
        IntegralSurfaces(IntegralPatches& patches, IntegralTally& tally, TraceThreadData *thread);

        /// Whether a scene's shading costs much more than finding the patch: radiosity, area lights or several lights.
        static bool Pays(const SceneData& scene);

        /// The colour of the surface that a ray meets, if it may be shared. `shade(Intersection&, const Ray&, Colour&)` works
        /// out the colour of a patch's point.
        template <class Shade> bool Colour_Of(Intersection& isect, const Ray& ray, Trace& trace, Colour& colour, Shade shade);

    private:
        /// What a texture's colour depends on. steady: the point alone. glossy: also the direction that it is seen from.
        /// own: more.
        enum Kind { steady, glossy, own };

        /// Where a ray meets which patch.
        struct Place
        {
            std::size_t slot;
            std::uint64_t key;
            std::uint64_t spot;   ///< random bits that are the patch's own in every run
            int axis;             ///< the normal's largest component
            bool positive;        ///< the side of the surface that is seen: towards larger coordinates
            bool inside;          ///< that side is the object's inside
            double size;          ///< of the patch, scene units
            double centre[3];     ///< of the patch
            VECTOR direction;     ///< from which the patch is seen
        };

        bool Locate(Intersection& isect, const Ray& ray, Place& place);
        bool Put(const Place& place, const Intersection& isect, Trace& trace, Ray& ray, Intersection& at) const;
        Kind Kind_Of(const Intersection& isect, bool inside);
        static Kind Kind_Of(const TEXTURE *texture);
        Kind Known_Kind_Of(const TEXTURE *texture);
        void Count(bool worked_out);

        IntegralPatches& patches;
        IntegralTally& tally;
        TraceThreadData *thread;
        std::unordered_map<const TEXTURE *, Kind> kinds;
};

template <class Shade>
bool IntegralSurfaces::Colour_Of(Intersection& isect, const Ray& ray, Trace& trace, Colour& colour, Shade shade)
{
    Place place;
    if (!Locate(isect, ray, place))
        return false;
    IntegralPatches::Patch patch;
    bool worked_out = false;
    if (!patches.Find(place.slot, place.key, patch))
    {
        Ray from;
        Intersection at;
        patch.key = place.key;
        patch.height = std::numeric_limits<float>::quiet_NaN();
        if (Put(place, isect, trace, from, at))
        {
            Colour seen;
            seen.clear();
            shade(at, from, seen);
            worked_out = true;
            patch.red = seen.red();
            patch.green = seen.green();
            patch.blue = seen.blue();
            if (seen.filter() == 0 && seen.transm() == 0)
                patch.height = float((at.IPoint[place.axis] - place.centre[place.axis]) / place.size);
        }
        patches.Store(place.slot, patch);
    }
    // The point may be on another fold of the surface.
    constexpr double far = 2.5;
    if (!(std::fabs((isect.IPoint[place.axis] - place.centre[place.axis]) / place.size - patch.height) <= far))
        return false;
    Count(worked_out);
    colour.red() += patch.red;
    colour.green() += patch.green;
    colour.blue() += patch.blue;
    return true;
}

}

#endif
