// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/markup.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

namespace integral {
namespace {

/// Length of the UTF-8 character of XML 1.0 that begins at `at`; 0 if there is none.
std::size_t character_length(const std::string& text, std::size_t at)
{
    const auto byte = [&](std::size_t i) {
        return at + i < text.size() ? std::uint8_t(text[at + i]) : 0u;
    };
    const std::uint32_t first = byte(0);
    if (first < 0x80)
        return first >= 0x20 && first != 0x7f                    ? 1
               : first == '\t' || first == '\n' || first == '\r' ? 1
                                                                 : 0;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    std::uint32_t code = first & (0xffu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (byte(i) & 0x3f);
    }
    const std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_character = first >= 0xc0 && first < 0xf8 && code >= least[length] &&
                              code <= 0x10ffff && !(code >= 0xd800 && code < 0xe000) &&
                              code != 0xfffe && code != 0xffff;
    return is_character ? length : 0;
}

} // namespace

std::string markup_text(const std::string& text)
{
    std::string markup;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = character_length(text, at);
        switch (length == 0 ? '\0' : text[at]) {
        case '\0': markup += "\xef\xbf\xbd"; break;
        case '&': markup += "&amp;"; break;
        case '<': markup += "&lt;"; break;
        case '>': markup += "&gt;"; break;
        case '"': markup += "&quot;"; break;
        case '\'': markup += "&#39;"; break;
        case '\t': markup += "&#9;"; break;
        case '\n': markup += "&#10;"; break;
        case '\r': markup += "&#13;"; break;
        default: markup.append(text, at, length);
        }
        at += std::max<std::size_t>(1, length);
    }
    return markup;
}

std::string json_within_html(const std::string& json)
{
    std::string text;
    for (const char c : json)
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text;
}

std::string for_shell(const std::string& text)
{
    constexpr char
        plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./+-=,:@";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos)
        return text;
    std::string safe = "'";
    for (const char c : text)
        safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return safe + "'";
}

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

std::string filled_template(const std::string& page, const TemplatePieces& pieces)
{
    std::string text;
    std::size_t done = 0;
    for (const auto& [name, piece] : pieces) {
        const std::string mark = "@" + name + "@";
        const auto at = page.find(mark, done);
        if (at == std::string::npos)
            throw std::logic_error("the page has no " + mark);
        text += page.substr(done, at - done) + piece;
        done = at + mark.size();
    }
    return text + page.substr(done);
}

} // namespace integral
