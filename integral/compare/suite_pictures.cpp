// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/suite_pictures.h"

#include "integral/base/number_text.h"
#include "integral/compare/seen.h"
#include "integral/io/html_page.h"
#include "integral/io/markup.h"

#include <algorithm>
#include <cmath>

namespace integral {

const char suite_pictures_style[] = R"css(
.pictures { display: flex; flex-wrap: wrap; gap: 12px; margin: 8px 0 0; }
.detail { margin: 12px 0 0; color: var(--quiet); }
figure { margin: 0; max-width: 100%; }
figcaption { color: var(--quiet); font-size: 0.87rem; margin: 0 0 3px; }
.magnified img { image-rendering: pixelated; }
)css";

namespace {

// The longer sides, in pixels. Three pictures of shown_failed fit side by side.
constexpr int shown_failed = 376, shown_small = 176, magnified_side = 240;

struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

/// A square of `side` pixels around a pixel, moved and if need be cut to lie in the picture.
Rectangle around(const Image& picture, int x, int y, int side)
{
    Rectangle r;
    r.width = std::min(side, picture.width);
    r.height = std::min(side, picture.height);
    r.x = std::clamp(x - r.width / 2, 0, picture.width - r.width);
    r.y = std::clamp(y - r.height / 2, 0, picture.height - r.height);
    return r;
}

struct Detail {
    Rectangle where;
    std::string words;
};

/// The pixel that differs most, among the pixels for which counts(x, y) is true.
template <class Counts> Vec2 worst_pixel(const Image& difference, Counts counts)
{
    float most = -1;
    Vec2 worst{0, 0};
    for (int y = 0; y < difference.height; ++y)
        for (int x = 0; x < difference.width; ++x) {
            const Colour c = stored_pixel(difference, x, y);
            const float sum = c.r + c.g + c.b;
            if (sum > most && counts(x, y)) {
                most = sum;
                worst = {double(x), double(y)};
            }
        }
    return worst;
}

/// The part that is shown magnified: the worst micro-image with a quarter of each neighbour, or
/// without geometry the surroundings of the worst pixel.
Detail find_detail(const Image& difference, const Comparison& figures,
                   const FrameMetadata* geometry)
{
    const auto at = [](const Rectangle& r) {
        return "; pixels " + std::to_string(r.x) + " to " + std::to_string(r.x + r.width - 1) +
               " across, " + std::to_string(r.y) + " to " + std::to_string(r.y + r.height - 1) +
               " down";
    };
    if (!figures.worst || !geometry) {
        const Vec2 worst = worst_pixel(difference, [](int, int) { return true; });
        const Rectangle where = around(difference, int(worst.x), int(worst.y), 48);
        return {where, "Around the pixel " + std::to_string(int(worst.x)) + "," +
                           std::to_string(int(worst.y)) + ", which differs most" + at(where)};
    }
    const Film& film = geometry->film;
    const Lattice lattice(geometry->sheet);
    const LensIndex lens = figures.worst->lens;
    Vec2 centre = lattice.pole(lens);
    // A lenticular micro-image is as long as the film: show it where it differs most.
    if (lattice.arrangement() == Arrangement::lenticular) {
        const Vec2 worst = worst_pixel(difference, [&](int x, int y) {
            return lattice.nearest(film_from_pixel(film, {x + 0.5, y + 0.5})) == lens;
        });
        const Vec2 point = film_from_pixel(film, {worst.x + 0.5, worst.y + 0.5});
        centre = centre + dot(point - centre, lattice.along()) * lattice.along();
    }
    const Vec2 pixel = pixel_from_film(film, centre);
    const double across = lattice.pitch() / std::min(film.pixel_pitch.x, film.pixel_pitch.y);
    const Rectangle where = around(difference, int(std::clamp(pixel.x, 0.0, double(film.width))),
                                   int(std::clamp(pixel.y, 0.0, double(film.height))),
                                   int(std::clamp(1.5 * across, 16.0, 120.0)));
    return {where, "The worst micro-image: lens " + std::to_string(lens.i) + "," +
                       std::to_string(lens.j) + " at " + with_decimals(figures.worst->pole.x, 2) +
                       "," + with_decimals(figures.worst->pole.y, 2) + " mm, RMSE " +
                       with_digits(figures.worst->rmse, 4) + at(where)};
}

std::string figure(const std::string& caption, const std::string& picture)
{
    return "<figure><figcaption>" + markup_text(caption) + "</figcaption>" + picture +
           "</figure>\n";
}

/// HTML of a part of a picture, each of its pixels magnified to a whole number of pixels.
std::string magnified(const Image& picture, const Rectangle& r, const std::string& text)
{
    const int times = std::max(1, magnified_side / std::max(r.width, r.height));
    const Image part = scaled_down(part_of(picture, r.x, r.y, r.width, r.height), magnified_side);
    return "<img src=\"" + picture_uri(part) + "\" width=\"" + std::to_string(times * part.width) +
           "\" height=\"" + std::to_string(times * part.height) + "\" alt=\"" + markup_text(text) +
           "\">";
}

/// The gain with which the largest difference is full scale.
double full_scale_gain(const Comparison& figures)
{
    return figures.largest_difference > 0 ? 1 / figures.largest_difference : 1;
}

/// The place where the pictures differ most, magnified and in words. `times` is the caption of the
/// difference.
std::string magnified_detail(const Comparison& figures, const Frame& reference, const Frame& result,
                             const Image& difference, const std::string& times,
                             const PairDetails& details)
{
    const auto& metadata = reference.metadata ? reference.metadata : result.metadata;
    const Detail detail = find_detail(difference_picture(reference.image, result.image,
                                                         full_scale_gain(figures),
                                                         details.weights.get()),
                                      figures, metadata ? &*metadata : nullptr);
    return "<p class=\"detail\">" + markup_text(detail.words) +
           ".</p>\n<div class=\"pictures magnified\">\n" +
           figure("reference", magnified(reference.image, detail.where, "part of the reference")) +
           figure("result", magnified(result.image, detail.where, "part of the result")) +
           figure(times, magnified(difference, detail.where, "part of their difference")) +
           (details.flip_map ? figure("FLIP", magnified(*details.flip_map, detail.where,
                                                        "part of the map of FLIP"))
                             : "") +
           "</div>\n";
}

/// The worst eye's views, and a table of all eyes.
std::string seen_part(const SeenFigures& seen, int longest)
{
    const SeenByEye& worst = seen.eyes[seen.worst];
    const std::string eye = "the eye at " + eye_text(worst.eye) + " mm";
    Image difference = difference_picture(seen.reference, seen.result,
                                          full_scale_gain(worst.figures));
    difference.encoding = Encoding{};
    std::string html = "<p class=\"detail\">What " + eye + " sees, whose views differ most (at " +
                       with_decimals(seen.place.x, 2) + "," + with_decimals(seen.place.y, 2) +
                       " mm of the sheet)";
    if (seen.parallax)
        html += "; parallax differs by up to " + with_decimals(seen.parallax->greatest, 3) + " mm";
    html += ".</p>\n<div class=\"pictures\">\n" +
            figure("reference, seen",
                   picture_element(seen.reference, longest, "the reference as seen by " + eye)) +
            figure("result, seen",
                   picture_element(seen.result, longest, "the result as seen by " + eye)) +
            figure("difference × " + with_digits(full_scale_gain(worst.figures), 4),
                   picture_element(difference, longest, "the difference of the views",
                                   Scaling::greatest)) +
            "</div>\n<table>\n<thead><tr><th>Eye, mm</th><th class=\"number\">RMSE</th>"
            "<th class=\"number\">SSIM</th><th class=\"number\">FLIP</th></tr></thead>\n<tbody>\n";
    for (const SeenByEye& one : seen.eyes)
        html += "<tr><td>" + eye_text(one.eye) + "</td><td class=\"number\">" +
                with_digits(one.figures.rmse, 4) + "</td><td class=\"number\">" +
                with_digits(one.figures.ssim, 4) + "</td><td class=\"number\">" +
                (one.figures.flip ? with_digits(one.figures.flip->mean, 4) : "–") + "</td></tr>\n";
    return html + "</tbody>\n</table>\n";
}

} // namespace

std::string suite_pictures(const SuitePair& pair, const std::optional<Frame>& reference,
                           const std::optional<Frame>& result, double gain,
                           const PairDetails& details)
{
    const bool to_compare = pair.state == PairState::over_limit ||
                            pair.state == PairState::other_geometry ||
                            pair.state == PairState::other_size;
    const int longest = to_compare ? shown_failed : shown_small;
    std::string html = "<div class=\"pictures\">\n";
    if (pair.figures && !pair.figures->seen && pair.figures->largest_difference == 0 &&
        pair.figures->not_finite.unequal == 0)
        return html +
               figure(details.weights ? "reference and result, which are equal where they count"
                                      : "reference and result, which are equal",
                      picture_element(result->image, longest, "the result " + pair.name)) +
               "</div>\n";
    if (reference)
        html += figure("reference",
                       picture_element(reference->image, longest, "the reference of " + pair.name));
    if (result)
        html += figure("result",
                       picture_element(result->image, longest, "the result " + pair.name));
    if (!pair.figures)
        return html + "</div>\n";

    const double least = std::min(pair.figures->largest_difference, 8 * pair.figures->rmse);
    if (gain == 0) // a whole number, so that the caption can state it exactly
        gain = least > 0 ? std::clamp(std::floor(1 / least), 1.0, 65535.0) : 1;
    Image difference = difference_picture(reference->image, result->image, gain,
                                          details.weights.get());
    difference.encoding = Encoding{}; // so that the stored values are shown unchanged
    const std::string times = "difference × " + with_digits(gain, 6);
    html += figure(times,
                   picture_element(difference, longest, "their difference", Scaling::greatest));
    if (details.flip_map)
        html += figure("FLIP: black 0, light yellow 1",
                       picture_element(*details.flip_map, longest, "the map of FLIP"));
    html += "</div>\n";
    if (pair.figures->seen)
        html += seen_part(*pair.figures->seen, longest);
    return pair.passed() ? html
                         : html + magnified_detail(*pair.figures, *reference, *result, difference,
                                                   times, details);
}

std::optional<Image> suite_thumbnail(const SuitePair& pair, const std::optional<Frame>& reference,
                                     const std::optional<Frame>& result, const PairDetails& details)
{
    constexpr int side = 160, border = 4;
    if (!pair.figures) {
        if (!reference && !result)
            return std::nullopt;
        return scaled_down(result ? result->image : reference->image, side);
    }
    const SeenFigures* seen = pair.figures->seen.get();
    const Image &first = seen ? seen->reference : reference->image,
                &second = seen ? seen->result : result->image;
    const Comparison& figures = seen ? seen->eyes[seen->worst].figures : *pair.figures;
    Image difference = difference_picture(first, second, full_scale_gain(figures),
                                          seen ? nullptr : details.weights.get());
    difference.encoding = Encoding{};
    return tiled({scaled_down(first, side), scaled_down(second, side),
                  scaled_down(difference, side, Scaling::greatest)},
                 3, border);
}

} // namespace integral
