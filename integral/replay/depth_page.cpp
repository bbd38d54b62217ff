// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/depth_page.h"

#include "integral/io/html_page.h"
#include "integral/io/markup.h"
#include "integral/lightfield/sheet_figures.h"
#include "integral/lightfield/sheet_report.h"

#include <stdexcept>

namespace integral {

Image scene_picture(const DepthFrame& depths, const std::optional<Frame>& colours)
{
    const auto budget = depth_budget(depths.metadata.sheet, counted(depths.metadata).pixel);
    if (!budget)
        throw std::invalid_argument(
            "these lenses have no depth budget by which a picture could be tinted");
    return depth_picture(depths, *budget, colours);
}

std::string depth_page(const std::string& scene, const std::string& verdict, const Image& picture,
                       const std::string& tables)
{
    constexpr int longest = 800;
    return html_page("Depths of " + scene,
                     "img { max-width: 100%; } pre { overflow-x: auto; white-space: pre-wrap; }",
                     "<h1>Depths of " + markup_text(scene) + "</h1>\n<pre>" + markup_text(verdict) +
                         "</pre>\n<p>" +
                         picture_element(picture, longest, "the scene, tinted by sharpness") +
                         "</p>\n<p>Blue: sharp. Yellow: soft. Red: beyond. Black: no surface.</p>" +
                         "\n<pre>" + markup_text(tables) + "</pre>\n");
}

} // namespace integral
