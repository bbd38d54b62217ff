// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/json_difference.h"

#include <algorithm>
#include <cmath>

namespace integral {

std::optional<JsonDifference> json_difference(const Json& first, const Json& second,
                                              double least_magnitude, const std::string& path)
{
    constexpr double rounding = 1e-9;
    if (first.is_number() && second.is_number()) {
        const double a = first.get<double>(), b = second.get<double>();
        if (std::fabs(a - b) <= rounding * std::max({std::fabs(a), std::fabs(b), least_magnitude}))
            return std::nullopt;
    } else if (first.is_object() && second.is_object()) {
        const auto path_of = [&](const std::string& key) {
            return path.empty() ? key : path + "." + key;
        };
        for (const auto& [key, value] : first.items()) {
            if (!second.contains(key))
                return JsonDifference{path_of(key), value.dump(), ""};
            if (auto difference = json_difference(value, second.at(key), least_magnitude,
                                                  path_of(key)))
                return difference;
        }
        for (const auto& [key, value] : second.items())
            if (!first.contains(key))
                return JsonDifference{path_of(key), "", value.dump()};
        return std::nullopt;
    } else if (first.is_array() && second.is_array() && first.size() == second.size()) {
        for (std::size_t i = 0; i < first.size(); ++i)
            if (auto difference = json_difference(first[i], second[i], least_magnitude,
                                                  path + "[" + std::to_string(i) + "]"))
                return difference;
        return std::nullopt;
    } else if (first == second) {
        return std::nullopt;
    }
    return JsonDifference{path, first.dump(), second.dump()};
}

} // namespace integral
