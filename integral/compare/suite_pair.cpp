// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/suite_pair.h"

#include "integral/compare/compare_geometry.h"
#include "integral/compare/suite_pictures.h"
#include "integral/io/image_file.h"

#include <algorithm>

namespace integral {
namespace {

/// Reads one of the two pictures. If that fails, notes the fault and returns nothing.
std::optional<Frame> read(SuitePair& pair, const std::string& path, const char* which)
{
    try {
        return read_frame(path);
    } catch (const InputError& error) {
        std::string reason = error.what();
        if (reason.compare(0, path.size() + 2, path + ": ") == 0)
            reason.erase(0, path.size() + 2);
        pair.faults.push_back(which + (": " + reason));
        pair.state = std::max(pair.state, PairState::damaged);
        return std::nullopt;
    }
}

std::string size_of(const Image& image)
{
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

} // namespace

const char* name_of(PairState state)
{
    switch (state) {
    case PairState::passed: return "passed";
    case PairState::over_limit: return "limit";
    case PairState::other_geometry: return "geometry";
    case PairState::other_size: return "size";
    case PairState::damaged: return "damaged";
    case PairState::no_reference: return "no reference";
    case PairState::no_result: break;
    }
    return "no result";
}

void compare_pair(SuitePair& pair, const SuiteFolders& folders, const SuitePictures& pictures)
{
    if (!pair.has_result) {
        pair.state = PairState::no_result;
        pair.faults.push_back("there is no result, only its reference");
    } else if (!pair.has_reference) {
        pair.state = PairState::no_reference;
        pair.faults.push_back("there is no reference; --accept " + pair.name + " makes it one");
    }
    if (pair.missing() && !pictures.wanted)
        return;
    std::optional<Frame> reference, result;
    if (pair.has_reference)
        reference = read(pair, folders.reference(pair.name), "the reference");
    if (pair.has_result)
        result = read(pair, folders.result(pair.name), "the result");
    if (reference && result) {
        if (size_of(reference->image) != size_of(result->image)) {
            pair.state = PairState::other_size;
            pair.faults.push_back("it has " + size_of(result->image) +
                                  " pixels, its reference has " + size_of(reference->image));
        } else {
            pair.figures = compare(*reference, *result);
            const std::string other = geometry_difference(reference->metadata, result->metadata);
            if (!other.empty())
                pair.faults.push_back(other);
            const auto missed = missed_limits(pair.limits, *pair.figures);
            pair.faults.insert(pair.faults.end(), missed.begin(), missed.end());
            pair.state = !other.empty()    ? PairState::other_geometry
                         : !missed.empty() ? PairState::over_limit
                                           : PairState::passed;
        }
    }
    if (pictures.wanted)
        pair.pictures = suite_pictures(pair, reference, result, pictures.gain);
}

} // namespace integral
