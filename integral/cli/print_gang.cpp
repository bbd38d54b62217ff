// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/print_gang.h"

#include "integral/base/number_text.h"
#include "integral/cli/values.h"
#include "integral/print/gang.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace integral {
namespace {

std::unique_ptr<FrameReader> opened(const PrintOptions& o, std::size_t input)
{
    return std::make_unique<FrameReader>(o.inputs[input], o.start.value_or(""));
}

/// The frames' geometries, each as often as --repeat requires. Throws InputError if a frame has
/// none, or another sheet or film than the first.
std::vector<FrameMetadata> geometries(const PrintOptions& o, const Readers& frames)
{
    std::vector<FrameMetadata> all;
    const int repeats = std::max(1, repeats_of(o));
    for (std::size_t k = 0; k < frames.size(); ++k) {
        frames[k]->require_metadata();
        const FrameMetadata& metadata = *frames[k]->frame().metadata;
        all.insert(all.end(), std::size_t(repeats), metadata);
        const std::string difference = sheet_difference(all[0], metadata);
        if (!difference.empty())
            throw InputError(o.inputs[k] + ": its lens sheet is not that of " + o.inputs[0] + ": " +
                             difference +
                             "; print it on a page of its own, or render both for one sheet");
    }
    return all;
}

/// Arranges the frames on paper as it is fed, or throws std::invalid_argument.
Gang on_paper(const PrintOptions& o, const std::vector<FrameMetadata>& frames,
              const PrintSettings& settings)
{
    GangRequest request;
    request.room = room_on_paper(settings.pixel_pitch, settings.page);
    request.gap = gap_of(o);
    request.fill = repeats_of(o) == 0;
    return gang(frames, request);
}

/// Arranges the frames. A named paper is turned if only that gives room for all, or room for more.
Gang on_either_paper(const PrintOptions& o, const std::vector<FrameMetadata>& frames,
                     PrintSettings& settings)
{
    Paper& paper = *settings.page.paper;
    if (!paper_named(*o.paper) || o.orientation.value_or("auto") != "auto")
        return on_paper(o, frames, settings);
    if (paper.width > paper.height)
        std::swap(paper.width, paper.height);
    PrintSettings turned = settings;
    std::swap(turned.page.paper->width, turned.page.paper->height);
    const auto arranged = [&](const PrintSettings& s) -> std::optional<Gang> {
        try {
            return on_paper(o, frames, s);
        } catch (const std::invalid_argument&) {
            return std::nullopt;
        }
    };
    const auto upright_gang = arranged(settings), turned_gang = arranged(turned);
    if (turned_gang &&
        (!upright_gang || turned_gang->places.size() > upright_gang->places.size())) {
        settings = turned;
        return *turned_gang;
    }
    return upright_gang ? *upright_gang : on_paper(o, frames, settings);
}

/// A reader for each place. Copies of a frame whose rows stand level share one, and so do copies in
/// different rows of frames. Adds the readers that are needed to `frames`.
std::vector<FrameReader*> shared_readers(const PrintOptions& o, const Gang& gang,
                                         const std::vector<std::size_t>& inputs, Readers& frames)
{
    std::map<std::pair<std::size_t, int>, FrameReader*> by_level; // input, rows below its row's top
    std::set<std::size_t> used;                                   // of `frames`, at first
    std::vector<FrameReader*> readers;
    int top = 0, bottom = -1;
    for (std::size_t k = 0; k < gang.places.size(); ++k) {
        const PixelRectangle& place = gang.places[k];
        if (place.y >= bottom)
            top = place.y;
        bottom = std::max(bottom, place.y + place.height);
        FrameReader*& reader = by_level[{inputs[k], place.y - top}];
        if (!reader && used.insert(inputs[k]).second)
            reader = frames[inputs[k]].get();
        if (!reader) {
            frames.push_back(opened(o, inputs[k]));
            reader = frames.back().get();
        }
        readers.push_back(reader);
    }
    return readers;
}

/// Reports how well one lens sheet serves all frames.
void report(const Gang& gang, Vec2 pixel)
{
    const double pixels = gang.largest_error / std::min(pixel.x, pixel.y);
    std::cout << counted(int(gang.places.size()), "frame") << " in " << counted(gang.rows, "row")
              << " behind one lens sheet: its lenses are within "
              << with_decimals(gang.largest_error, 4) << " mm (" << with_decimals(pixels, 2)
              << " pixels) of each frame's\n";
}

} // namespace

Readers open_frames(const PrintOptions& o)
{
    Readers frames;
    for (std::size_t k = 0; k < o.inputs.size(); ++k) {
        if (o.inputs[k] == "-" && holds_several(o))
            throw UsageError("FRAME - is printed alone; several frames need files");
        frames.push_back(opened(o, k));
    }
    return frames;
}

FrameMetadata arrange(const PrintOptions& o, Readers& frames, PrintSettings& settings,
                      std::vector<FrameReader*>& readers)
{
    if (o.tile)
        throw UsageError("--tile is for one FRAME; print them one by one");
    if (!settings.page.paper)
        throw UsageError("several frames on one page need --paper");
    if (is_roll(*settings.page.paper) && repeats_of(o) == 0)
        throw UsageError("--repeat fill needs paper with a length; for a roll, give --repeat N");
    const std::vector<FrameMetadata> all = geometries(o, frames);
    const Gang gang = usage_checked("", [&] { return on_either_paper(o, all, settings); });
    const std::size_t copies = gang.places.size() / o.inputs.size();
    std::vector<std::size_t> inputs; // of the places
    for (std::size_t k = 0; k < gang.places.size(); ++k) {
        inputs.push_back(k / copies);
        const double trim = page_request(o, frames[inputs[k]]->frame().metadata->film).trim;
        settings.page.frames.push_back({gang.places[k], trim});
    }
    readers = shared_readers(o, gang, inputs, frames);
    settings.title += ", " + counted(int(gang.places.size()), "frame");
    if (o.strip)
        settings.page.strip = settings.title;
    if (o.output != "-")
        report(gang, gang.metadata.film.pixel_pitch);
    return gang.metadata;
}

} // namespace integral
