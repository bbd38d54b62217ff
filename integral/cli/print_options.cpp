// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/print_options.h"

#include "integral/base/number_text.h"
#include "integral/cli/values.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace integral {

namespace {

constexpr double largest_paper = 5000; // mm

double parse_length(const options::variables_map& arguments, const char* option, double fallback)
{
    if (!given(arguments, option))
        return fallback;
    const double value = parse_number(option, text_of(arguments, option), "a number of mm");
    if (!(value >= 0 && value <= largest_paper))
        throw UsageError(std::string("--") + option + " " + text_of(arguments, option) +
                         ": 0 to 5000 mm is expected");
    return value;
}

/// The paper as it is fed.
std::optional<Paper> parse_paper(const options::variables_map& arguments, const Film& film)
{
    const std::string way = given(arguments, "orientation") ? text_of(arguments, "orientation")
                                                            : "auto";
    if (way != "auto" && way != "portrait" && way != "landscape")
        throw UsageError("--orientation " + way + ": portrait, landscape or auto is expected");
    if (!given(arguments, "paper")) {
        if (way != "auto")
            throw UsageError("--orientation needs --paper");
        return std::nullopt;
    }
    const std::string text = text_of(arguments, "paper");
    Paper paper = parse_paper_size(text);
    const bool named = paper_named(text).has_value();
    const bool wide = film.width * film.pixel_pitch.x > film.height * film.pixel_pitch.y;
    const bool turn = way == "auto" ? named && wide
                                    : (way == "landscape") != (paper.width > paper.height);
    if (turn)
        std::swap(paper.width, paper.height);
    return paper;
}

} // namespace

Paper parse_paper_size(const std::string& text)
{
    if (const std::optional<Paper> paper = paper_named(text))
        return *paper;
    double width = 0, height = 0;
    int read = 0;
    if (std::sscanf(text.c_str(), "%lfx%lf%n", &width, &height, &read) != 2 ||
        read != int(text.size()) || !(width >= 5 && height >= 5) ||
        !(width <= largest_paper && height <= largest_paper))
        throw UsageError("--paper " + text + ": " + paper_names() +
                         ", or WIDTHxHEIGHT of 5 to 5000 mm, is expected");
    return {width, height};
}

Vec2 printer_pitch(const options::variables_map& arguments, const Film& film)
{
    Vec2 feed{1, 1};
    if (given(arguments, "feed"))
        feed = parse_one_or_two("feed", text_of(arguments, "feed"), "X or X,Y");
    if (!(feed.x > 0.5 && feed.y > 0.5 && feed.x < 2 && feed.y < 2))
        throw UsageError("--feed " + text_of(arguments, "feed") + ": 0.5 to 2 is expected");
    const Vec2 made{film.pixel_pitch.x / feed.x, film.pixel_pitch.y / feed.y};
    if (!given(arguments, "dpi"))
        return made;
    const Vec2 dpi = parse_one_or_two("dpi", text_of(arguments, "dpi"), "D or D,D");
    if (!(dpi.x >= 1 && dpi.y >= 1 && dpi.x <= 100000 && dpi.y <= 100000))
        throw UsageError("--dpi " + text_of(arguments, "dpi") + ": 1 to 100000 is expected");
    const auto differs = [](double a, double b) { return std::fabs(a - b) > 1e-6 * b; };
    if (differs(mm_per_inch / made.x, dpi.x) || differs(mm_per_inch / made.y, dpi.y)) {
        const Vec2 pitch{mm_per_inch / dpi.x * feed.x, mm_per_inch / dpi.y * feed.y};
        throw UsageError("the frame has " + with_digits(mm_per_inch / film.pixel_pitch.x, 6) +
                         " x " + with_digits(mm_per_inch / film.pixel_pitch.y, 6) +
                         " pixels an inch, and is never resampled; for this printer render it with "
                         "film { pixel_pitch <" +
                         with_digits(pitch.x, 6) + ", " + with_digits(pitch.y, 6) +
                         "> }, or let it print at the frame's own resolution");
    }
    return {mm_per_inch / dpi.x, mm_per_inch / dpi.y};
}

PageRequest parse_request(const options::variables_map& arguments, const Film& film)
{
    PageRequest request;
    request.paper = parse_paper(arguments, film);
    const std::string centre = given(arguments, "centre") ? text_of(arguments, "centre") : "lens";
    if (centre != "lens" && centre != "picture")
        throw UsageError("--centre " + centre + ": lens or picture is expected");
    request.centre_on_lens = centre == "lens";
    request.trim = parse_length(arguments, "bleed", 0);
    request.overlap = parse_length(arguments, "overlap", request.overlap);
    request.tiles = arguments["tile"].as<bool>();
    if (given(arguments, "overlap") && !request.tiles)
        throw UsageError("--overlap is for --tile");
    if (request.tiles && !request.paper)
        throw UsageError("--tile needs --paper");
    request.mirrored = arguments["mirror"].as<bool>();
    std::string kinds = text_of(arguments, "marks");
    while (!kinds.empty()) {
        const std::string kind = kinds.substr(0, kinds.find(','));
        kinds.erase(0, kind.size() + 1);
        if (kind != "crop" && kind != "registration" && kind != "axis" && kind != "all")
            throw UsageError("--marks " + text_of(arguments, "marks") +
                             ": crop, registration, axis or all is expected");
        request.crop_marks |= kind == "crop" || kind == "all";
        request.registration_marks |= kind == "registration" || kind == "all";
        request.axis_marks |= kind == "axis" || kind == "all";
    }
    return request;
}

Intent parse_intent(const options::variables_map& arguments)
{
    const std::string word = given(arguments, "intent") ? text_of(arguments, "intent") : "relative";
    if (given(arguments, "intent") && !given(arguments, "icc"))
        throw UsageError("--intent needs --icc");
    for (const auto& [name, intent] :
         {std::pair("perceptual", Intent::perceptual), std::pair("relative", Intent::relative),
          std::pair("saturation", Intent::saturation), std::pair("absolute", Intent::absolute)})
        if (word == name)
            return intent;
    throw UsageError("--intent " + word +
                     ": perceptual, relative, saturation or absolute is expected");
}

} // namespace integral
