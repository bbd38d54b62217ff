// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/geometry_difference.h"

#include "integral/frame/geometry_json.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

bool same_value(const Json& a, const Json& b)
{
    constexpr double rounding = 1e-9;
    if (a.is_number() && b.is_number()) {
        const double x = a.get<double>(), y = b.get<double>();
        return std::fabs(x - y) <= rounding * std::max({1.0, std::fabs(x), std::fabs(y)});
    }
    if (a.is_array() && b.is_array())
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_value);
    return a == b;
}

std::optional<GeometryDifference> difference(const std::string& name, const Json& a, const Json& b)
{
    const auto text = [](const Json& object, const std::string& field) {
        return object.contains(field) ? object[field].dump() : std::string("not given");
    };
    for (const Json* object : {&a, &b})
        for (const auto& item : object->items())
            if (const std::string& field = item.key();
                !a.contains(field) || !b.contains(field) || !same_value(a[field], b[field]))
                return GeometryDifference{name + "." + field, text(a, field), text(b, field)};
    return std::nullopt;
}

/// The fields of `render` that the lines of sight depend on.
Json rays_of(const FrameMetadata& metadata)
{
    const RenderRecord render = metadata.render.value_or(RenderRecord());
    return {{"model", name_of(render.model)}, {"pseudoscopic", render.pseudoscopic}};
}

} // namespace

std::optional<GeometryDifference> geometry_difference(const FrameMetadata& a,
                                                      const FrameMetadata& b)
{
    if (auto found = difference("sheet", json_of(a.sheet), json_of(b.sheet)))
        return found;
    if (auto found = difference("film", json_of(a.film), json_of(b.film)))
        return found;
    if (auto found = difference("aperture", json_of(a.aperture), json_of(b.aperture)))
        return found;
    return difference("render", rays_of(a), rays_of(b));
}

} // namespace integral
