// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/replay_page.h"

#include "build/generated/replay_page_text.h" // replay_page_html and its like
#include "integral/compare/compare.h"
#include "integral/compare/compare_geometry.h"
#include "integral/io/codecs.h"
#include "integral/io/markup.h"
#include "integral/lightfield/names.h"
#include "integral/replay/arrange.h"

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <vector>

namespace integral {
namespace {

/// JSON for use inside HTML: `<`, which occurs only in strings, is escaped, so that an HTML parser
/// finds no markup.
std::string within_html(const std::string& json)
{
    std::string text;
    for (const char c : json)
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text;
}

std::string json_of(const View& start, Vec2 zone)
{
    return nlohmann::ordered_json{
        {"eye", {start.eye.x, start.eye.y, start.eye.distance}},
        {"size", {start.width, start.height}},
        {"samples", start.samples},
        {"pupil", start.pupil},
        {"focus", start.focus},
        {"film_gap", start.film_gap},
        {"blur", start.blur},
        {"model", name_of(start.model)},
        {"part", {start.part.middle.x, start.part.middle.y, start.part.width, start.part.height}},
        {"zone", {zone.x, zone.y}}}
        .dump();
}

struct Blank {
    std::string mark, text;
};

/// The template `page` with each mark replaced by its text. The marks must occur in the order of
/// `blanks`.
std::string filled_in(const std::string& page, const std::vector<Blank>& blanks)
{
    std::string text;
    std::size_t done = 0;
    for (const Blank& blank : blanks) {
        const auto at = page.find(blank.mark, done);
        if (at == std::string::npos)
            throw std::logic_error("replay_page.html has no " + blank.mark);
        text += page.substr(done, at - done) + blank.text;
        done = at + blank.mark.size();
    }
    return text + page.substr(done);
}

/// A frame's picture as the page's scripts read it.
std::string page_picture(const Frame& frame)
{
    DecodedImage picture;
    picture.image = converted(frame.image, 8, Encoding{}, false);
    return base64(encode_png(picture));
}

/// The page; `comparison`: the HTML of a second frame, or none.
std::string page_of(const Frame& frame, const View& start, const std::string& comparison)
{
    const FrameMetadata& metadata = *frame.metadata;
    const Subpixels& subpixels = metadata.film.subpixels;
    if (subpixels != Subpixels::none && subpixels != Subpixels::rgb && subpixels != Subpixels::bgr)
        throw std::invalid_argument(std::string("--html shows panels of upright stripes, rgb or "
                                                "bgr, and this frame's subpixels are ") +
                                    name_of(subpixels.order) +
                                    "; integral replay without --html shows it");
    const Vec2 zone = viewing_zone(metadata, metadata.aperture.distance);
    return filled_in(replay_page_html, {{"@FRAME@", page_picture(frame)},
                                        {"@COMPARISON@", comparison},
                                        {"@GEOMETRY@", within_html(to_json(metadata))},
                                        {"@START@", within_html(json_of(start, zone))},
                                        {"@SHADER@", replay_page_glsl},
                                        {"@SCRIPT@", replay_page_js}});
}

} // namespace

std::string replay_page(const Frame& frame, const View& start) { return page_of(frame, start, ""); }

std::string comparison_page(const Frame& reference, const Frame& result, const View& start)
{
    require_same_size(reference.image, result.image);
    const std::string other = geometry_difference(reference.metadata, result.metadata);
    if (!other.empty())
        throw std::invalid_argument("--html shows two frames of one geometry, and " + other);
    return page_of(reference, start,
                   filled_in(comparison_part_html, {{"@SECOND@", page_picture(result)}}));
}

} // namespace integral
