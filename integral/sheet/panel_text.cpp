// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/panel_text.h"

#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/sheet/camera_words.h"
#include "integral/sheet/sheet_report.h"

#include <algorithm>
#include <cstdio>

namespace integral {

Json panels_json()
{
    Json list = Json::array();
    for (const Panel& panel : known_panels())
        list.push_back({{"name", panel.name},
                        {"width", panel.film.width},
                        {"height", panel.film.height},
                        {"pixel_pitch_mm", panel.film.pixel_pitch.x},
                        {"lens_pitch_mm", panel.sheet.pitch},
                        {"slant_degrees", panel.sheet.slant},
                        {"viewing_distance_mm", panel.aperture.distance}});
    return list;
}

std::string panels_text()
{
    constexpr int longest_line = 200;
    char line[longest_line];
    std::snprintf(line, sizeof line, "%-28s %11s %9s %10s %8s %9s\n", "", "pixels", "pixel mm",
                  "lens mm", "slant", "from mm");
    std::string text = line;
    for (const Panel& panel : known_panels()) {
        const std::string size = size_text(panel.film.width, panel.film.height);
        std::snprintf(line, sizeof line, "%-28s %11s %9.4f %10.4f %8.2f %9.0f\n",
                      panel.name.c_str(), size.c_str(), panel.film.pixel_pitch.x, panel.sheet.pitch,
                      panel.sheet.slant, panel.aperture.distance);
        text += line;
    }
    return text;
}

std::string render_settings(const Panel& panel, const std::optional<PanelQuilt>& quilt)
{
    const FrameMetadata native = frame_geometry(panel);
    std::string words = camera_words(native), fit = fit_words();
    PixelSize size{panel.film.width, panel.film.height};
    if (quilt) {
        // The quilt's pixels have another depth budget than the panel's, which are seen.
        FrameMetadata geometry = native;
        geometry.film.pixel_pitch = {size_of(panel.film).x / quilt->width,
                                     size_of(panel.film).y / quilt->height};
        const auto budget = seen_budget(native), of_quilt = seen_budget(geometry);
        if (budget && of_quilt)
            fit = fit_words(*budget / *of_quilt);
        // The window keeps its size in mm whatever number of pixels is rendered.
        const Vec2 window = size_of(panel.film);
        const std::string film = film_words(panel.film);
        words.replace(words.find(film), film.size(),
                      "film { pixel_pitch <" + with_digits(window.x, 12) + "/image_width, " +
                          with_digits(window.y, 12) + "/image_height> }");
        size = {quilt->width, quilt->height};
    }
    return "Width=" + std::to_string(size.width) + "\nHeight=" + std::to_string(size.height) +
           "\nIntegral_Camera=\"" + words + " " + fit + "\"\n" +
           (quilt ? "Integral_Quilt=" + size_text(quilt->tiles.columns, quilt->tiles.rows) + "\n"
                  : "");
}

} // namespace integral
