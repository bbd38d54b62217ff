// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/message_text.h"

#include <cstdio>
#include <new>
#include <unistd.h>

namespace integral {

std::string one_line(const std::string& text)
{
    std::string line = excerpt(text, 2000);
    const auto byte = [&](std::size_t i) {
        return i < line.size() ? static_cast<unsigned char>(line[i]) : 0;
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool two_bytes = byte(i) == 0xc2 && byte(i + 1) >= 0x80 && byte(i + 1) < 0xa0;
        if (byte(i) < 0x20 || byte(i) == 0x7f || two_bytes)
            line[i] = '?';
        if (two_bytes)
            line[++i] = '?';
    }
    return line;
}

std::string excerpt(const std::string& text, std::size_t most)
{
    if (text.size() <= most)
        return text;
    std::size_t end = most;
    while (end > 0 && end + 4 > most && (text[end] & 0xc0) == 0x80) // inside a UTF-8 character
        --end;
    return text.substr(0, end) + "...";
}

std::string reason_of(const std::exception& error)
{
    return dynamic_cast<const std::bad_alloc*>(&error) ? "it needs more memory than there is"
                                                       : error.what();
}

void say(const std::string& command, const std::string& text)
{
    // On a terminal, first erase a progress bar that may be on the line.
    const char* const line_start = isatty(STDERR_FILENO) ? "\r\033[K" : "";
    std::fprintf(stderr, "%sintegral %s: %s\n", line_start, command.c_str(),
                 one_line(text).c_str());
}

} // namespace integral
