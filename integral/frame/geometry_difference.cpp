// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/geometry_difference.h"

#include "integral/frame/geometry_json.h"

namespace integral {
namespace {

/// The fields that determine the lines of sight.
Json rays_of(const FrameMetadata& metadata)
{
    const RenderRecord render = metadata.render.value_or(RenderRecord());
    return {{"sheet", json_of(metadata.sheet)},
            {"film", json_of(metadata.film)},
            {"aperture", json_of(metadata.aperture)},
            {"render", {{"model", name_of(render.model)}, {"pseudoscopic", render.pseudoscopic}}}};
}

} // namespace

std::optional<JsonDifference> geometry_difference(const FrameMetadata& first,
                                                  const FrameMetadata& second)
{
    constexpr double least_magnitude = 1;
    auto difference = json_difference(rays_of(first), rays_of(second), least_magnitude);
    if (difference)
        for (std::string* value : {&difference->first, &difference->second})
            if (value->empty())
                *value = "not given";
    return difference;
}

} // namespace integral
