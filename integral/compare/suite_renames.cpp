// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/suite_renames.h"

#include "integral/base/interrupt.h"
#include "integral/io/image_file.h"

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace integral {
namespace {

/// Size, form and a hash of the samples (FNV-1a) of a picture; two with equal keys are the same.
using PictureKey = std::tuple<int, int, int, int, std::uint64_t>;

/// The key of a file; empty where it cannot be read.
std::optional<PictureKey> key_of(const std::string& path)
{
    try {
        FrameReader reader(path);
        const Image& form = reader.frame().image;
        std::uint64_t hash = 14695981039346656037u;
        Image row = blank_like(form, form.width, 1);
        const auto bytes = std::size_t(size_in_bytes(row));
        for (int y = 0; y < form.height; ++y) {
            stop_if_interrupted();
            reader.read(row);
            const unsigned char* at = row_bytes(row, 0);
            for (std::size_t k = 0; k < bytes; ++k)
                hash = (hash ^ at[k]) * 1099511628211u;
        }
        return PictureKey(form.width, form.height, form.channels, sample_bits(form), hash);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

} // namespace

void note_renames(Suite& suite)
{
    std::map<PictureKey, SuitePair*> gone;
    for (SuitePair& pair : suite.pairs)
        if (!pair.has_result)
            if (const auto key = key_of(suite.folders.reference(pair.name)))
                gone.emplace(*key, &pair);
    if (gone.empty())
        return;
    for (SuitePair& pair : suite.pairs) {
        if (pair.has_reference)
            continue;
        const auto key = key_of(suite.folders.result(pair.name));
        const auto found = key ? gone.find(*key) : gone.end();
        if (found == gone.end())
            continue;
        SuitePair& old = *found->second;
        pair.faults.push_back("it has the pixels of the reference " + old.name +
                              "; if it was renamed, --accept " + pair.name + " " + old.name);
        old.faults.push_back("the result " + pair.name + " has its pixels");
        gone.erase(found);
    }
}

} // namespace integral
