// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/screen/screen_text.h"

#include "integral/base/number_text.h"

#include <cstdio>

namespace integral {

std::string screens_text(const std::vector<Screen>& screens)
{
    std::string text;
    int number = 0;
    for (const Screen& screen : screens)
        text += std::to_string(++number) + "  " + screen.name + "  " +
                size_text(screen.width, screen.height) +
                (screen.rate > 0 ? "  " + with_decimals(screen.rate, 2) + " Hz" : "") + "  at " +
                std::to_string(screen.x) + "," + std::to_string(screen.y) + "  " +
                (screen.scaled.empty() ? "pixel for pixel" : screen.scaled) + "\n";
    return text;
}

Json screens_json(const std::vector<Screen>& screens)
{
    Json list = Json::array();
    for (const Screen& screen : screens)
        list.push_back({{"number", list.size() + 1},
                        {"name", screen.name},
                        {"width", screen.width},
                        {"height", screen.height},
                        {"rate", screen.rate},
                        {"x", screen.x},
                        {"y", screen.y},
                        {"scaled", screen.scaled}});
    return list;
}

std::string play_text(const PlayReport& report)
{
    char text[300];
    std::snprintf(text, sizeof text,
                  "shown               %lld\n"
                  "dropped             %lld\n"
                  "rate                %.3f a second\n"
                  "worst lateness      %.1f ms\n",
                  report.shown, report.dropped, report.rate, 1000 * report.worst_lateness);
    return text;
}

Json play_json(const PlayReport& report)
{
    return {{"shown", report.shown},
            {"dropped", report.dropped},
            {"seconds", report.seconds},
            {"rate", report.rate},
            {"worst_lateness_ms", 1000 * report.worst_lateness}};
}

} // namespace integral
