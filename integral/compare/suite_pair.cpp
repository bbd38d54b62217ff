// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/suite_pair.h"

#include "integral/compare/compare_geometry.h"
#include "integral/compare/flip_map.h"
#include "integral/compare/suite_pictures.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cstring>

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

/// Compares frames of one size by the pair's rules. `with_map`: keeps the FLIP map.
void compare_frames(SuitePair& pair, const Frame& reference, const Frame& result, bool with_map,
                    const CompareSeen& compare_seen, PairDetails& details)
{
    ComparisonSettings settings;
    try {
        settings = settings_in_memory(pair.rules, reference, result);
    } catch (const InputError& error) { // the mask
        pair.faults.push_back(error.what());
    } catch (const std::invalid_argument& error) {
        pair.faults.push_back(std::string("its tolerances: ") + error.what());
    }
    if (!pair.faults.empty()) {
        pair.state = PairState::no_tolerances;
        return;
    }
    details.weights = settings.weights;
    const int width = reference.image.width;
    if (settings.flip && with_map) {
        details.flip_map = blank_like(flip_map_form(width, reference.image.height, false), width,
                                      reference.image.height);
        settings.take_map = [&](int first, int rows, const float* map) {
            const Image band = flip_map_rows(map, width, rows, false);
            std::memcpy(row_bytes(*details.flip_map, first), row_bytes(band, 0),
                        std::size_t(size_in_bytes(band)));
        };
    }
    pair.figures = compare(reference, result, settings);
    if (pair.rules.seen && reference.metadata && result.metadata)
        pair.figures->seen = std::make_shared<SeenFigures>(
            compare_seen(reference, result, pair.rules));
    const std::string other = geometry_difference_text(reference.metadata, result.metadata);
    if (!other.empty())
        pair.faults.push_back(other);
    const auto missed = missed_limits(pair.limits, *pair.figures);
    pair.faults.insert(pair.faults.end(), missed.begin(), missed.end());
    pair.state = !other.empty()    ? PairState::other_geometry
                 : !missed.empty() ? PairState::over_limit
                                   : PairState::passed;
}

} // namespace

const char* name_of(PairState state)
{
    switch (state) {
    case PairState::passed: return "passed";
    case PairState::over_limit: return "limit";
    case PairState::other_geometry: return "geometry";
    case PairState::other_size: return "size";
    case PairState::no_tolerances: return "tolerances";
    case PairState::damaged: return "damaged";
    case PairState::no_reference: return "no reference";
    case PairState::no_result: break;
    }
    return "no result";
}

void compare_pair(SuitePair& pair, const SuiteFolders& folders, const SuitePictures& pictures,
                  const CompareSeen& compare_seen)
{
    if (!pair.has_result) {
        pair.state = PairState::no_result;
        pair.faults.push_back("there is no result, only its reference; --accept " + pair.name +
                              " removes that");
    } else if (!pair.has_reference) {
        pair.state = PairState::no_reference;
        pair.faults.push_back("there is no reference; --accept " + pair.name + " makes it one");
    }
    if (pair.missing() && !pictures.requested && !pictures.thumbnails)
        return;
    std::optional<Frame> reference, result;
    if (pair.has_reference)
        reference = read(pair, folders.reference(pair.name), "the reference");
    if (pair.has_result)
        result = read(pair, folders.result(pair.name), "the result");
    PairDetails details;
    if (reference && result) {
        if (size_of(reference->image) != size_of(result->image)) {
            pair.state = PairState::other_size;
            pair.faults.push_back("it has " + size_of(result->image) +
                                  " pixels, its reference has " + size_of(reference->image));
        } else {
            compare_frames(pair, *reference, *result, pictures.requested, compare_seen, details);
        }
    }
    if (pictures.requested)
        pair.pictures = suite_pictures(pair, reference, result, pictures.gain, details);
    if (pictures.thumbnails && !pair.passed())
        pair.thumbnail = suite_thumbnail(pair, reference, result, details);
}

} // namespace integral
