// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/base/text_columns.h"
#include "integral/sheet/depth_advice.h"
#include "integral/views/layers.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// The text at the right of a column, after at least one blank.
std::string column(const std::string& text, std::size_t width)
{
    return " " + right_aligned(text, width - 1);
}

std::string place_text(double distance)
{
    return distance == 0 ? "on the sheet"
                         : with_digits(std::fabs(distance), 6) + " mm " +
                               (distance > 0 ? "behind" : "before");
}

std::string range_text(const std::optional<LayerEnds>& range)
{
    return range ? ", " + with_digits(range->nearest, 4) + " to " +
                       with_digits(range->farthest, 4) + " mm"
                 : "";
}

const char* name_of(LayerSharpness sharpness)
{
    switch (sharpness) {
    case LayerSharpness::sharp: return "sharp";
    case LayerSharpness::soft: return "soft";
    case LayerSharpness::beyond: return "beyond";
    case LayerSharpness::unknown: break;
    }
    return "-";
}

} // namespace

std::string layers_text(const LayersView& view)
{
    std::size_t width = 5;
    for (const LayerFigures& layer : view.layers)
        width = std::max(width, layer.name.size());
    std::string text = "  layer" + std::string(width - 5, ' ') + column("distance", 18) +
                       column("size there, mm", 18) + column("shift, mm", 12) + "  depth\n";
    for (const LayerFigures& layer : view.layers)
        text += "  " + layer.name + std::string(width - layer.name.size(), ' ') +
                column(place_text(layer.distance), 18) +
                column(with_decimals(layer.size.x, 1) + " x " + with_decimals(layer.size.y, 1),
                       18) +
                column(with_decimals(layer.shift, 2), 12) + "  " + name_of(layer.sharpness) +
                range_text(layer.tilted) + "\n";
    text += "\nShift: how far the layer moves on the sheet, with the eye (negative: against it), "
            "while the\neye crosses the viewing zone.\n";
    text += view.budget ? "Depth: sharp up to " + with_digits(*view.budget, 3) +
                              " mm before and behind the sheet, soft up to " +
                              with_digits(soft_budgets * *view.budget, 3) + " mm.\n"
                        : "The lenses are too wide for the sheet's thickness to have a depth "
                          "budget.\n";
    const auto up = [](double mm) { return with_decimals(std::ceil(10 * mm) / 10, 1); };
    if (view.bare)
        text += view.bare->name + " leaves up to " + with_decimals(view.bare->margin, 1) +
                " mm of the film bare for an eye at the zone's edge; with width=" +
                up(view.bare->width) +
                (view.bare->stretched ? ",height=" + up(view.bare->height) : "") +
                " it fills the film for all eyes.\n";
    return text;
}

std::string layers_json(const LayersView& view)
{
    Json json = {{"budget_mm", view.budget ? Json(*view.budget) : Json(nullptr)},
                 {"layers", Json::array()}};
    for (const LayerFigures& layer : view.layers) {
        Json of_layer = {{"picture", layer.name},
                         {"distance_mm", layer.distance},
                         {"width_mm", layer.size.x},
                         {"height_mm", layer.size.y},
                         {"shift_mm", layer.shift},
                         {"depth", layer.sharpness == LayerSharpness::unknown
                                       ? Json(nullptr)
                                       : Json(name_of(layer.sharpness))}};
        if (layer.tilted) {
            of_layer["nearest_mm"] = layer.tilted->nearest;
            of_layer["farthest_mm"] = layer.tilted->farthest;
        }
        json["layers"].push_back(of_layer);
    }
    if (view.bare)
        json["bare"] = {{"picture", view.bare->name},
                        {"margin_mm", view.bare->margin},
                        {"filling_width_mm", view.bare->width},
                        {"filling_height_mm", view.bare->height}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace integral
