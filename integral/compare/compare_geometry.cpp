// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/compare_geometry.h"

#include "integral/base/json_difference.h"
#include "integral/base/message_text.h"

namespace integral {
namespace {

/// The fields of the document that are compared; without `with_render`, none about rendering.
Json geometry_of(const FrameMetadata& metadata, bool with_render)
{
    Json json = parse_json(to_json(metadata));
    if (!with_render)
        json.erase("render");
    else
        for (const char* other :
             {"program", "scene", "mapping", "pixel_samples", "beam_samples", "seconds", "error"})
            json["render"].erase(other);
    return json;
}

} // namespace

std::string geometry_difference_text(const std::optional<FrameMetadata>& reference,
                                     const std::optional<FrameMetadata>& result)
{
    if (!reference || !result)
        return !reference && !result ? ""
               : reference           ? "it has no geometry, its reference has"
                                     : "it has geometry, its reference has none";
    const bool with_render = reference->render && result->render;
    constexpr double least_magnitude = 1e-3;
    const auto difference = json_difference(geometry_of(*reference, with_render),
                                            geometry_of(*result, with_render), least_magnitude);
    if (!difference)
        return "";
    const auto& [path, there, here] = *difference;
    return path + (here.empty() ? " is missing, its reference has it"
                   : there.empty()
                       ? " is there, its reference has none"
                       : " is " + excerpt(here) + ", its reference's " + excerpt(there));
}

} // namespace integral
