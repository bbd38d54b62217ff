// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/compare_geometry.h"

#include "integral/base/json.h"
#include "integral/base/message_text.h"

#include <algorithm>
#include <cmath>

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

/// The first difference, in words; empty if there is none. `path` names the values within their
/// documents.
std::string difference(const Json& reference, const Json& result, const std::string& path)
{
    if (reference.is_number() && result.is_number()) {
        const double a = reference.get<double>(), b = result.get<double>();
        if (std::fabs(a - b) <= 1e-9 * std::max({std::fabs(a), std::fabs(b), 1e-3}))
            return "";
    } else if (reference.is_object() && result.is_object()) {
        const auto path_of = [&](const std::string& key) {
            return path.empty() ? key : path + "." + key;
        };
        for (const auto& [key, value] : reference.items()) {
            if (!result.contains(key))
                return path_of(key) + " is missing, its reference has it";
            const std::string found = difference(value, result.at(key), path_of(key));
            if (!found.empty())
                return found;
        }
        for (const auto& [key, value] : result.items())
            if (!reference.contains(key))
                return path_of(key) + " is there, its reference has none";
        return "";
    } else if (reference.is_array() && result.is_array() && reference.size() == result.size()) {
        for (std::size_t i = 0; i < reference.size(); ++i) {
            const std::string found = difference(reference[i], result[i],
                                                 path + "[" + std::to_string(i) + "]");
            if (!found.empty())
                return found;
        }
        return "";
    } else if (reference == result) {
        return "";
    }
    return path + " is " + excerpt(result.dump()) + ", its reference's " +
           excerpt(reference.dump());
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
    return difference(geometry_of(*reference, with_render), geometry_of(*result, with_render), "");
}

} // namespace integral
