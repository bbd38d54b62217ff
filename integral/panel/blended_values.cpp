// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/blended_values.h"

namespace integral {
namespace {

constexpr int channels = 3;

/// `From` and `To`: the types of the values and of those that they become.
template <class From, class To> std::vector<To> table(Encoding from, Encoding to)
{
    constexpr int count = std::numeric_limits<From>::max() + 1;
    Image ramp = make_image<From>(count, 1, channels, from);
    auto& values = std::get<std::vector<From>>(ramp.samples);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = From(i / channels);
    ramp = converted(ramp, 8 * int(sizeof(To)), to, false);
    std::vector<To> table(count);
    for (int value = 0; value < count; ++value)
        table[std::size_t(value)] = std::get<std::vector<To>>(
            ramp.samples)[std::size_t(value) * channels];
    return table;
}

} // namespace

BlendedValues blended_values(Encoding stored)
{
    const Encoding linear{Encoding::Kind::linear, 1};
    return {table<std::uint8_t, std::uint16_t>(stored, linear),
            table<std::uint16_t, std::uint8_t>(linear, stored)};
}

} // namespace integral
