// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/panel_text.h"

#include "integral/base/number_text.h"
#include "integral/sheet/panel.h"

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

} // namespace integral
