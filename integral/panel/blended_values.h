// SPDX-License-Identifier: AGPL-3.0-or-later
// The values that are blended in linear light for stored ones of 8 bits, and back.
#ifndef INTEGRAL_PANEL_BLENDED_VALUES_H
#define INTEGRAL_PANEL_BLENDED_VALUES_H

#include "integral/frame/image.h"

#include <cstdint>
#include <vector>

namespace integral {

/// Tables that convert opaque colours exactly as `converted` does.
struct BlendedValues {
    std::vector<std::uint16_t> light; ///< linear light of each stored value
    std::vector<std::uint8_t> stored; ///< the stored value of each value of linear light
};

BlendedValues blended_values(Encoding stored);

} // namespace integral

#endif
