// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/replay_page.h"

#include "build/generated/page_texts.h" // replay_page_html and its like
#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/compare/compare_geometry.h"
#include "integral/compare/seen.h"
#include "integral/frame/names.h"
#include "integral/io/codecs.h"
#include "integral/io/markup.h"
#include "integral/replay/arrange.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

/// Data of the first view for the page's script.
Json start_of(const View& start, const FrameMetadata& metadata)
{
    const Vec2 zone = viewing_zone(metadata, metadata.aperture.distance);
    return {
        {"eye", {start.eye.x, start.eye.y, start.eye.distance}},
        {"size", {start.width, start.height}},
        {"samples", start.samples},
        {"pupil", start.pupil},
        {"focus", start.focus},
        {"film_gap", start.film_gap},
        {"blur", start.blur},
        {"model", name_of(start.model)},
        {"part", {start.part.middle.x, start.part.middle.y, start.part.width, start.part.height}},
        {"zone", {zone.x, zone.y}}};
}

/// A frame's picture as the page's scripts read it.
std::string page_picture(const Frame& frame)
{
    DecodedImage picture;
    picture.image = converted(frame.image, 8, Encoding{}, false);
    return base64(encode_png(picture));
}

/// A small picture of the first view, as HTML, which the page shows while it decodes the frame.
std::string still_picture(const Frame& frame, View view)
{
    constexpr int longer_side = 640, quality = 85;
    set_view_size(view, frame.metadata->film, longer_side);
    const Image still = converted(*replay(frame, view), 8, Encoding{}, false);
    return "<img id=\"still\" alt=\"\" src=\"data:image/jpeg;base64," +
           base64(encode_jpeg(still, quality)) + "\">\n";
}

/// The page without the pieces of its frames. `with_comparison`: with the script for two frames.
std::string page_shell(bool with_comparison, const PageAdditions& additions)
{
    const auto mark = [](const char* name) {
        return std::pair<std::string, std::string>(name, std::string("@") + name + "@");
    };
    return filled_template(
        replay_page_html,
        {{"STYLE_NONCE", additions.nonce},
         {"HEAD", additions.head},
         mark("STILL"),
         mark("FRAME"),
         mark("COMPARISON"),
         mark("GEOMETRY"),
         mark("START"),
         {"SHADER", std::string(sheet_optics_glsl) + replay_page_glsl},
         {"SCRIPT_NONCE", additions.nonce},
         {"SCRIPT", std::string(replay_drawing_js) + (with_comparison ? comparison_page_js : "") +
                        replay_page_js},
         {"END", additions.end}});
}

/// The pieces of a frame's page. `still`: see still_picture.
TemplatePieces pieces_of(const Frame& frame, const std::string& still,
                         const std::string& comparison, const Json& start)
{
    return {{"STILL", still},
            {"FRAME", page_picture(frame)},
            {"COMPARISON", comparison},
            {"GEOMETRY", json_within_html(to_json(*frame.metadata))},
            {"START", json_within_html(start.dump())}};
}

/// A picture as a film without lenses: the page shows its pixels, which are 1 mm wide.
Frame as_film(const Frame& picture)
{
    Frame frame{picture.image, std::nullopt};
    FrameMetadata metadata;
    metadata.film = {picture.image.width, picture.image.height, {1, 1}};
    metadata.aperture = {350, 0, 0};
    metadata.encoding = picture.image.encoding;
    set_metadata(frame, metadata);
    return frame;
}

/// The part that shows both films whole; empty if their sizes differ by at most half a pixel.
SheetPart part_of_both(const Film& a, const Film& b)
{
    const Vec2 size_a = size_of(a), size_b = size_of(b);
    const bool as_large = std::fabs(size_a.x - size_b.x) <= 0.5 * a.pixel_pitch.x &&
                          std::fabs(size_a.y - size_b.y) <= 0.5 * a.pixel_pitch.y;
    if (as_large)
        return {};
    return {{0, 0}, std::max(size_a.x, size_b.x), std::max(size_a.y, size_b.y)};
}

} // namespace

std::string page_obstacle(const Frame& frame)
{
    if (!frame.metadata)
        return "a picture has no geometry of a lens sheet";
    if (frame.metadata->projection)
        return "the page shows no frames for replay through a projection lens; integral replay "
               "without --html does";
    const Subpixels& subpixels = frame.metadata->film.subpixels;
    if (subpixels != Subpixels::none && subpixels != Subpixels::rgb && subpixels != Subpixels::bgr)
        return std::string("the page shows panels of upright stripes, rgb or bgr, and this "
                           "frame's subpixels are ") +
               name_of(subpixels.order) + "; integral replay without --html shows it";
    return "";
}

std::string replay_page(const Frame& frame, const View& start)
{
    const std::string obstacle = page_obstacle(frame);
    if (!obstacle.empty())
        throw std::invalid_argument("--html: " + obstacle);
    return filled_template(page_shell(false, {}), pieces_of(frame, still_picture(frame, start), "",
                                                            start_of(start, *frame.metadata)));
}

ComparedPictures compared_pictures(const Frame& reference, const Frame& result,
                                   const Comparison& comparison)
{
    ComparedPictures pictures{&reference, &result, "", std::nullopt};
    if (!comparison.seen)
        return pictures;
    const SeenFigures& seen = *comparison.seen;
    const SeenByEye& worst = seen.eyes[seen.worst];
    pictures.worst = {{worst.eye.x, worst.eye.y, worst.eye.z},
                      seen.place,
                      "Of " + counted(int(seen.eyes.size()), "eye") + " that at " +
                          eye_text(worst.eye) + " mm sees the greatest difference, RMSE " +
                          with_digits(worst.figures.rmse, 4) + ", most at " +
                          with_decimals(seen.place.x, 1) + "," + with_decimals(seen.place.y, 1) +
                          " mm of the sheet."};
    return pictures;
}

std::string comparison_shell(const PageAdditions& additions) { return page_shell(true, additions); }

TemplatePieces comparison_pieces(const ComparedPictures& pictures, bool keys_for_pages)
{
    const Frame *first = pictures.reference ? pictures.reference : pictures.result,
                *second = pictures.reference && pictures.result ? pictures.result : nullptr;
    std::string obstacle = page_obstacle(*first);
    if (obstacle.empty() && second)
        obstacle = page_obstacle(*second);
    std::optional<Frame> first_film, second_film;
    if (!obstacle.empty()) {
        first_film = as_film(*first);
        first = &*first_film;
        if (second) {
            second_film = as_film(*second);
            second = &*second_film;
        }
    }

    View view;
    view.eye = centre_eye(*first->metadata);
    if (obstacle.empty())
        set_as_seen(view, *first->metadata);
    view.samples = default_samples(view);
    if (second)
        view.part = part_of_both(first->metadata->film, second->metadata->film);
    Json start = start_of(view, *first->metadata);
    start["keys_for_pages"] = keys_for_pages;
    if (!pictures.title.empty())
        start["title"] = pictures.title;
    if (!obstacle.empty())
        start["flat"] = "Without lenses, as " + obstacle + ".";
    if (!second)
        return pieces_of(*first, "", "", start);

    View second_view = view;
    if (obstacle.empty()) {
        second_view.blur = 0;
        set_as_seen(second_view, *second->metadata);
        const std::string other = geometry_difference_text(first->metadata, second->metadata);
        if (!other.empty())
            start["note"] = "The result's geometry differs: " + other + ".";
        if (const auto& worst = pictures.worst)
            start["worst"] = {{"eye", {worst->eye.x, worst->eye.y, worst->eye.distance}},
                              {"place", {worst->place.x, worst->place.y}},
                              {"words", worst->words}};
    }
    start["second_blur"] = second_view.blur;
    return pieces_of(
        *first, "",
        filled_template(comparison_part_html,
                        {{"SECOND", page_picture(*second)},
                         {"SECOND_GEOMETRY", json_within_html(to_json(*second->metadata))}}),
        start);
}

std::string comparison_page(const ComparedPictures& pictures, const PageAdditions& additions)
{
    return filled_template(comparison_shell(additions),
                           comparison_pieces(pictures, additions.keys_for_pages));
}

} // namespace integral
