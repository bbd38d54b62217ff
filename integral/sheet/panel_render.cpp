// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/panel_render.h"

#include "integral/base/number_text.h"
#include "integral/frame/picture_fit.h"
#include "integral/sheet/camera_words.h"
#include "integral/sheet/sheet_report.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

std::string text_of(PixelSize size) { return size_text(size.width, size.height); }

/// The given sides as options: "+W640 +H480".
std::string options_text(const std::optional<int>& width, const std::optional<int>& height)
{
    return (width ? "+W" + std::to_string(*width) : "") + (width && height ? " " : "") +
           (height ? "+H" + std::to_string(*height) : "");
}

/// Throws if a given size is not the panel's.
void check_own_size(const PanelRequest& request, PixelSize panel)
{
    if (request.width.value_or(panel.width) == panel.width &&
        request.height.value_or(panel.height) == panel.height)
        return;
    throw std::invalid_argument("Integral_Panel=" + request.panel + ": " +
                                options_text(request.width, request.height) +
                                " differs from the panel's " + text_of(panel) +
                                " pixels; leave +W and +H out (Integral_Draft=4 makes a draft), or "
                                "give Integral_Quilt=good "
                                "for a quilt");
}

/// The quilt with the given size. Throws if its views have another shape than the panel.
PanelQuilt with_size(const PanelRequest& request, const Panel& panel, PanelQuilt quilt)
{
    if (!request.width && !request.height)
        return quilt;
    const PixelSize recommended{quilt.width, quilt.height};
    const ViewGrid tiles = quilt.tiles;
    const double of_maker = double(quilt.width / tiles.columns) / (quilt.height / tiles.rows),
                 of_panel = shape_of(panel.film);
    const auto side = [](int tile_number, double pixels) {
        return tile_number * std::max(1, int(std::lround(pixels)));
    };
    const int height = request.width ? side(tiles.rows, *request.width / tiles.columns / of_maker)
                                     : *request.height;
    quilt.width = request.width ? *request.width
                                : side(tiles.columns, *request.height / tiles.rows * of_maker);
    quilt.height = request.height.value_or(height);
    const PixelSize tile{quilt.width / tiles.columns, quilt.height / tiles.rows};
    const double shape = double(tile.width) / std::max(1, tile.height);
    if (tile.width > 0 && tile.height > 0 && shape > 0.9 * std::min(of_maker, of_panel) &&
        shape < 1.1 * std::max(of_maker, of_panel))
        return quilt;
    throw std::invalid_argument(
        "Integral_Panel=" + request.panel + " with Integral_Quilt=" +
        size_text(tiles.columns, tiles.rows) + ": " + options_text(request.width, request.height) +
        " makes views of " + text_of(tile) + " pixels, another shape than the panel's " +
        size_text(panel.film.width, panel.film.height) + "; leave +W and +H out for " +
        text_of(recommended) + ", or give +W" + std::to_string(quilt.width) + " +H" +
        std::to_string(height));
}

PanelQuilt requested_quilt(const PanelRequest& request, const Panel& panel)
{
    if (const auto size = quilt_size(request.quilt))
        return quilt_for(panel, {}, *size);
    const auto tiles = views_in(request.quilt);
    if (!tiles)
        throw std::invalid_argument("Integral_Quilt=" + request.quilt +
                                    " is neither draft, good nor best, nor the views across and "
                                    "up, each from 1 to " +
                                    std::to_string(most_views_of_quilt) + ", as in 8x6");
    return quilt_for(panel, tiles);
}

} // namespace

PanelRender panel_render(const Panel& panel, const std::optional<PanelQuilt>& quilt)
{
    const FrameMetadata native = frame_geometry(panel);
    std::string words = camera_words(native), fit = fit_words();
    if (!quilt)
        return {{panel.film.width, panel.film.height}, words, fit, std::nullopt};
    constexpr double most_part = 50; // of fit_words, for the greatest fit that the camera takes
    // The quilt's pixels have another depth budget than the panel's, which are seen.
    const Vec2 window = size_of(panel.film);
    FrameMetadata geometry = native;
    geometry.film.pixel_pitch = {window.x / quilt->width, window.y / quilt->height};
    const auto budget = seen_budget(native), of_quilt = seen_budget(geometry);
    if (budget && of_quilt)
        fit = fit_words(std::min(most_part, *budget / *of_quilt));
    // The window keeps its size in mm whatever number of pixels is rendered.
    const std::string film = film_words(panel.film);
    words.replace(words.find(film), film.size(),
                  "film { pixel_pitch <" + with_digits(window.x, 12) + "/image_width, " +
                      with_digits(window.y, 12) + "/image_height> }");
    return {{quilt->width, quilt->height}, words, fit, quilt->tiles};
}

std::string ini_text(const PanelRender& render)
{
    return "Width=" + std::to_string(render.size.width) +
           "\nHeight=" + std::to_string(render.size.height) + "\nIntegral_Camera=\"" +
           render.camera + " " + render.fit + "\"\n" +
           (render.quilt
                ? "Integral_Quilt=" + size_text(render.quilt->columns, render.quilt->rows) + "\n"
                : "");
}

PanelRender panel_render(const PanelRequest& request)
{
    if (request.panel.empty())
        throw std::invalid_argument("Integral_Quilt=" + request.quilt +
                                    " is a size of a panel's quilt; name the panel, as in "
                                    "Integral_Panel=looking-glass-go, or give the views, as in "
                                    "Integral_Quilt=8x6");
    if (request.width.value_or(1) < 1 || request.height.value_or(1) < 1)
        throw std::invalid_argument("Integral_Panel=" + request.panel + ": " +
                                    options_text(request.width, request.height) +
                                    " is no size; leave +W and +H out");
    Panel panel;
    try {
        panel = find_panel(request.panel);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("Integral_Panel=" + request.panel + ": " + error.what());
    }
    if (!request.quilt.empty())
        return panel_render(panel, with_size(request, panel, requested_quilt(request, panel)));
    check_own_size(request, {panel.film.width, panel.film.height});
    return panel_render(panel, std::nullopt);
}

} // namespace integral
