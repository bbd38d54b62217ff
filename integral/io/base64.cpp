// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/base64.h"

#include <algorithm>
#include <cstdint>

namespace integral {

std::string base64(const std::string& bytes)
{
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t three = 0; // bytes, the first one highest
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (k < count ? std::uint8_t(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? digits[three >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

} // namespace integral
