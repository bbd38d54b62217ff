// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/depth_page.h"

#include "integral/io/html_page.h"
#include "integral/io/markup.h"
#include "integral/sheet/sheet_report.h"

#include <stdexcept>

namespace integral {

Image scene_picture(const DepthFrame& depths, const std::optional<Frame>& colours)
{
    const auto budget = seen_budget(depths.metadata);
    if (!budget)
        throw std::invalid_argument(
            "these lenses have no depth budget by which a picture could be tinted");
    return depth_picture(depths, *budget, colours);
}

namespace {

std::string figure(const Image& picture, const std::string& caption)
{
    return "<figure>" + picture_element(picture, picture.width, caption) + "<figcaption>" +
           markup_text(caption) + "</figcaption></figure>\n";
}

std::string looks_element(const SceneLooks& looks)
{
    return "<div class=\"looks\">\n" +
           figure(looks.as_it_is, "As it is, seen from the middle through the sheet (a draft)") +
           figure(looks.fitted, "With Integral_Fit=" + looks.fit) + "</div>\n";
}

} // namespace

std::string depth_page(const std::string& scene, const std::string& verdict, const Image& picture,
                       const std::optional<SceneLooks>& looks, const std::string& tables)
{
    constexpr int longest = 800;
    return html_page("Depths of " + scene,
                     "img { max-width: 100%; } pre { overflow-x: auto; white-space: pre-wrap; } "
                     ".looks { display: flex; flex-wrap: wrap; gap: 1em; } figure { margin: 0; }",
                     "<h1>Depths of " + markup_text(scene) + "</h1>\n<pre>" + markup_text(verdict) +
                         "</pre>\n" + (looks ? looks_element(*looks) : "") + "<p>" +
                         picture_element(picture, longest, "the scene, tinted by sharpness") +
                         "</p>\n<p>Blue: sharp. Yellow: soft. Red: beyond. Black: no surface.</p>" +
                         "\n<pre>" + markup_text(tables) + "</pre>\n");
}

} // namespace integral
