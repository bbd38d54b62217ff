// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must always be the first POV file included within base *.cpp files
#include "configbase.h"
#include "base/wordstream.h"

#include <cstdint>
#include <cstring>

// this must be the last file included
#include "base/povdebug.h"

namespace pov_base
{

bool Copy_Words(const void *from, void *to, int count, const int order[4], int *left)
{
    bool same = true, turned = true;
    for (int k = 0; k < 4; k++)
    {
        same = same && order[k] == k;
        turned = turned && order[k] == 3 - k;
    }
    if (!(same || turned) || count < 0 || *left / 4 < count)
        return false;
    const unsigned char *source = static_cast<const unsigned char *>(from);
    unsigned char *target = static_cast<unsigned char *>(to);
    if (same)
        std::memcpy(target, source, 4 * std::size_t(count));
    else
        for (int k = 0; k < count; k++)
        {
            std::uint32_t word;
            std::memcpy(&word, source + 4 * std::size_t(k), 4);
            word = word << 24 | (word & 0xff00) << 8 | (word >> 8 & 0xff00) | word >> 24;
            std::memcpy(target + 4 * std::size_t(k), &word, 4);
        }
    *left -= 4 * count;
    return true;
}

}
