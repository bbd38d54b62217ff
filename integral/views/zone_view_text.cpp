// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/json.h"
#include "integral/views/zone_view.h"

#include "integral/base/number_text.h"
#include "integral/base/text_columns.h"
#include "integral/io/html_page.h"
#include "integral/io/markup.h"
#include "integral/io/plot.h"
#include "integral/replay/replay.h"

#include <algorithm>
#include <cmath>

namespace integral {

double angle_of(const ZoneView& view, double place)
{
    return std::atan2(place, view.distance) * 180 / 3.14159265358979323846;
}

namespace {

std::string number(double value) { return with_decimals(value, 1); }

std::string range_text(const ZonePart& part) { return number(part.from) + " to " + number(part.to); }

std::string angles_text(const ZoneView& view, const ZonePart& part)
{
    return range_text({angle_of(view, part.from), angle_of(view, part.to)});
}

std::string alone_text(const ShareView& part)
{
    return part.alone ? range_text(*part.alone) : "nowhere";
}

/// The direction of positive places.
const char* direction(const ZoneView& view)
{
    return view.axis == ZoneAxis::upwards ? "upwards" : "to the right";
}

std::string head_text(const ZoneView& view)
{
    return "The viewing zone is " + number(view.width) + " mm wide at " + number(view.distance) +
           " mm (" + number(2 * angle_of(view, view.width / 2)) +
           " degrees). Places are from its middle, " + direction(view) + ".";
}

std::string ghost_text(const ZoneView& view)
{
    const bool any = std::any_of(view.parts.begin(), view.parts.end(),
                                 [](const ShareView& part) { return part.alone.has_value(); });
    const std::string without = view.lost_contrast > 0
                                    ? ", in place of " +
                                          with_decimals(100 * view.other_with_ghosts, 1) +
                                          "%, for " + with_digits(100 * view.lost_contrast, 3) +
                                          "% of the contrast"
                                    : "";
    return any ? "An eye that sees a picture alone sees at most " +
                     with_decimals(100 * view.greatest_other, 1) + "% of others" + without + " (" +
                     std::to_string(eyes_across_zone) + " eyes, by replay with the lenses' blur)."
               : "No eye sees a picture alone: the sheet blurs " + number(2 * view.blur) +
                     " mm at each change. Fewer pictures, or more pixels a lens, would help.";
}

} // namespace

std::string zone_view_text(const ZoneView& view, const std::vector<std::string>& names)
{
    std::size_t width = 7;
    for (const std::string& name : names)
        width = std::max(width, name.size());
    std::string text = head_text(view) + "\n\n  picture" + std::string(width - 7, ' ') +
                       right_aligned("seen at, mm", 18) + right_aligned("degrees", 18) +
                       right_aligned("alone at, mm", 18) + "\n";
    for (const ShareView& part : view.parts) {
        const std::string& name = names[part.picture];
        text += "  " + name + std::string(width - name.size(), ' ') +
                right_aligned(range_text(part.part), 18) +
                right_aligned(angles_text(view, part.part), 18) +
                right_aligned(alone_text(part), 18) + "\n";
    }
    return text + "\n" + ghost_text(view) + "\n";
}

std::string zone_view_json(const ZoneView& view, const std::vector<std::string>& names)
{
    const auto range = [](const ZonePart& part) { return Json::array({part.from, part.to}); };
    Json parts = Json::array(), eyes = Json::array();
    for (const ShareView& part : view.parts)
        parts.push_back({{"picture", names[part.picture]},
                         {"seen_mm", range(part.part)},
                         {"seen_degrees",
                          range({angle_of(view, part.part.from), angle_of(view, part.part.to)})},
                         {"alone_mm", part.alone ? range(*part.alone) : Json(nullptr)}});
    for (const EyeShares& eye : view.eyes)
        eyes.push_back({{"place_mm", eye.place},
                        {"alone", eye.picture ? Json(names[*eye.picture]) : Json(nullptr)},
                        {"shares", eye.shares}});
    const Json all = {{"zone",
                       {{"width_mm", view.width},
                        {"distance_mm", view.distance},
                        {"direction", view.axis == ZoneAxis::upwards ? "upwards" : "sideways"},
                        {"blur_mm", view.blur},
                        {"greatest_other", view.greatest_other},
                        {"other_with_ghosts", view.other_with_ghosts},
                        {"lost_contrast", view.lost_contrast}}},
                      {"pictures", parts},
                      {"eyes", eyes}};
    return all.dump(2) + "\n";
}

namespace {

std::string shares_plot(const ZoneView& view, const std::vector<std::string>& names)
{
    Plot plot;
    plot.title = "What each eye sees";
    plot.subtitle = "eyes " + number(view.distance) + " mm from the sheet";
    plot.x.label = std::string("place of the eye, ") + direction(view) + " (mm)";
    plot.x.low = -view.width / 2;
    plot.x.high = view.width / 2;
    plot.y.label = "share of the light (%)";
    plot.y.low = 0;
    plot.y.high = 100;
    for (std::size_t k = 0; k < names.size(); ++k) {
        PlotSeries series;
        series.label = names.size() <= 7 ? names[k] : "";
        for (const EyeShares& eye : view.eyes) {
            series.x.push_back(eye.place);
            series.y.push_back(100 * eye.shares[k]);
        }
        series.colour = int(k % 7);
        plot.series.push_back(series);
    }
    plot.height = 420;
    const std::string svg = plot_bytes(plot, PlotFormat::svg);
    return svg.substr(svg.find("<svg"));
}

/// The view of an eye in the middle of a share.
Image seen_in_middle(const ZoneView& view, const ShareView& part, const Frame& frame, int threads)
{
    const double place = (part.part.from + part.part.to) / 2;
    View eye;
    eye.eye = view.axis == ZoneAxis::upwards ? Eye{0, place, view.distance}
                                             : Eye{place, 0, view.distance};
    set_view_size(eye, frame.metadata->film, 320);
    set_as_seen(eye, *frame.metadata);
    return *replay(frame, eye, threads);
}

} // namespace

std::string zone_view_page(const ZoneView& view, const std::vector<std::string>& names,
                           const Frame& frame, int threads)
{
    const auto cell = [](const std::string& label, const std::string& text) {
        return "<td data-label=\"" + label + "\">" + text + "</td>";
    };
    std::string rows;
    for (const ShareView& part : view.parts) {
        const std::string name = markup_text(names[part.picture]);
        rows += "<tr>" + cell("picture", name) +
                cell("seen",
                     picture_element(seen_in_middle(view, part, frame, threads), 320,
                                     "what an eye in the middle of the share sees")) +
                cell("at, mm", range_text(part.part)) +
                cell("degrees", angles_text(view, part.part)) +
                cell("alone at, mm", alone_text(part)) + "</tr>\n";
    }
    return html_page("What each eye sees", "svg { max-width: 100%; height: auto }",
                     "<h1>What each eye sees</h1>\n<p>" + markup_text(head_text(view)) +
                         "</p>\n<table class=\"cards\"><thead><tr><th>picture</th><th>seen</th>"
                         "<th>at, mm</th><th>degrees</th><th>alone at, mm</th></tr></thead>"
                         "<tbody>\n" +
                         rows + "</tbody></table>\n<p>" + markup_text(ghost_text(view)) +
                         "</p>\n" + shares_plot(view, names) + "\n");
}

} // namespace integral
