// SPDX-License-Identifier: AGPL-3.0-or-later
// Determines whether a texture's colour depends on the point of the surface only, or also on the
// ray, as with highlights, mirrors and glass.

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/interior/interior.h"
#include "backend/pattern/pattern.h"
#include "backend/render/integralshading.h"
#include "backend/scene/objects.h"
#include "backend/texture/texture.h"

#include <algorithm>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

static bool Depends_On_Eye(const TPATTERN *pattern);

static bool Depends_On_Eye(const BLEND_MAP *map)
{
    if (map == NULL || (map->Type != PIGMENT_TYPE && map->Type != NORMAL_TYPE))
        return false;
    for (int k = 0; k < map->Number_Of_Entries; k++)
    {
        const BLEND_MAP_ENTRY& entry = map->Blend_Map_Entries[k];
        if (Depends_On_Eye(map->Type == PIGMENT_TYPE
                               ? static_cast<const TPATTERN *>(entry.Vals.Pigment)
                               : static_cast<const TPATTERN *>(entry.Vals.Tnormal)))
            return true;
    }
    return false;
}

/// Whether a pigment or normal depends on the angle of incidence.
static bool Depends_On_Eye(const TPATTERN *pattern)
{
    if (pattern == NULL)
        return false;
    return pattern->Type == AOI_PATTERN || Depends_On_Eye(pattern->Blend_Map) ||
           (pattern->Type == PIGMENT_PATTERN && Depends_On_Eye(pattern->Vals.Pigment));
}

static bool Is_Lit(const RGBColour& colour)
{
    return colour.red() != 0 || colour.green() != 0 || colour.blue() != 0;
}

IntegralCachedShading::Kind IntegralCachedShading::Kind_Of(const TEXTURE *texture)
{
    Kind kind = steady;
    for (const TEXTURE *layer = texture; layer != NULL;
         layer = static_cast<const TEXTURE *>(layer->Next))
    {
        if (layer->Type == AOI_PATTERN || layer->Type == NO_PATTERN)
            return own;
        if (layer->Type == PLAIN_PATTERN)
        {
            const FINISH *finish = layer->Finish;
            if (finish == NULL || layer->Pigment == NULL ||
                (layer->Pigment->Flags & HAS_FILTER) != 0 || finish->Specular != 0 ||
                finish->Phong != 0 || finish->Irid != 0 || finish->Crand != 0 ||
                finish->UseSubsurface || Is_Lit(finish->Reflection_Max) ||
                Depends_On_Eye(layer->Pigment) || Depends_On_Eye(layer->Tnormal))
                return own;
        }
        else if (layer->Type == BITMAP_PATTERN)
            for (const TEXTURE *material = layer->Materials; material != NULL;
                 material = material->Next_Material)
                kind = std::max(kind, Kind_Of(material));
        else if (layer->Blend_Map == NULL || layer->Blend_Map->Type != TEXTURE_TYPE)
            return own;
        else
            for (int k = 0; k < layer->Blend_Map->Number_Of_Entries; k++)
                kind = std::max(kind, Kind_Of(layer->Blend_Map->Blend_Map_Entries[k].Vals.Texture));
    }
    return texture == NULL ? own : kind;
}

IntegralCachedShading::Kind IntegralCachedShading::Known_Kind_Of(const TEXTURE *texture)
{
    const auto known = kinds.find(texture);
    return known != kinds.end() ? known->second
                                : kinds.emplace(texture, Kind_Of(texture)).first->second;
}

IntegralCachedShading::Kind IntegralCachedShading::Kind_Of(const Intersection& isect, bool inside)
{
    const ObjectBase *object = isect.Object;
    if (!Test_Flag(object, MULTITEXTURE_FLAG) && object->Texture != NULL)
        return Known_Kind_Of(inside && object->Interior_Texture != NULL ? object->Interior_Texture
                                                                        : object->Texture);
    if (!Test_Flag(object, MULTITEXTURE_FLAG) && !Test_Flag(object, CUTAWAY_TEXTURES_FLAG))
        return own;
    Intersection met = isect;
    WeightedTextureVector textures;
    isect.Object->Determine_Textures(&met, inside, textures, thread);
    Kind kind = textures.empty() ? own : steady;
    for (WeightedTextureVector::iterator i(textures.begin()); i != textures.end(); i++)
        kind = std::max(kind, Known_Kind_Of(i->texture));
    return kind;
}

}
