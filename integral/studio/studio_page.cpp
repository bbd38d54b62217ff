// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/studio.h"

#include "build/generated/page_texts.h"
#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/frame/geometry_json.h"
#include "integral/io/markup.h"
#include "integral/sheet/known_sheets.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// The list's text for a sheet: "60 lenses per inch, lenticular", with the pitch of sheets that are
/// not sold by their lenses per inch.
std::string label_of(const KnownSheet& known)
{
    const std::string lenses = with_digits(mm_per_inch / known.sheet.pitch, 3);
    return lenses + " lenses per inch, " + name_of(known.sheet.arrangement) +
           (known.of_thesis ? ", " + with_digits(known.sheet.pitch, 4) + " mm (thesis)" : "");
}

bool are_equal(const LensSheet& a, const LensSheet& b) { return json_of(a) == json_of(b); }

Json choice_of(const Panel& panel)
{
    return {{"name", panel.name},
            {"label", panel.name + ", " + std::to_string(panel.film.width) + " x " +
                          std::to_string(panel.film.height)},
            {"sheet", json_of(panel.sheet)},
            {"word", for_shell(panel.name)},
            {"panel", parse_json(to_json(panel))}};
}

/// The page's list: the sheet to begin with, unless it is known, then the known ones, lenticular
/// ones first, from coarse to fine; then panels in the same way.
Json choices_with(const PlacementSettings& first)
{
    const LensSheet& own = first.sheet;
    std::vector<KnownSheet> sheets = known_sheets();
    std::stable_sort(sheets.begin(), sheets.end(), [](const KnownSheet& a, const KnownSheet& b) {
        return a.sheet.arrangement != b.sheet.arrangement
                   ? a.sheet.arrangement < b.sheet.arrangement
                   : a.sheet.pitch > b.sheet.pitch;
    });
    Json choices = Json::array();
    if (std::none_of(sheets.begin(), sheets.end(),
                     [&](const KnownSheet& known) { return are_equal(known.sheet, own); }))
        choices.push_back({{"name", "own"},
                           {"label", "own, " + label_of({"own", own})},
                           {"sheet", json_of(own)}});
    for (const KnownSheet& known : sheets)
        choices.push_back(
            {{"name", known.name}, {"label", label_of(known)}, {"sheet", json_of(known.sheet)}});
    if (first.panel && !panel_named(first.panel->name))
        choices.push_back(choice_of(*first.panel));
    for (const Panel& panel : known_panels())
        choices.push_back(choice_of(panel));
    return choices;
}

} // namespace

std::string studio_page(const StudioInput& input, const PlacementSettings& first,
                        const ServerRequest& request)
{
    const std::string title = markup_text(input.name());
    return filled_template(studio_page_html,
                           {{"TITLE", title},
                            {"STYLE_NONCE", request.nonce},
                            {"INPUT", input.kind()},
                            {"INPUT", input.kind()},
                            {"INPUT", input.kind()},
                            {"TITLE", title},
                            {"INPUT", input.kind()},
                            {"INPUT", input.kind()},
                            {"UNIT", input.unit()},
                            {"SHEETS", json_within_html(choices_with(first).dump())},
                            {"REPLAY_SHADER", std::string(sheet_optics_glsl) + replay_page_glsl},
                            {"LIVE_SHADER", std::string(sheet_optics_glsl) + live_view_glsl},
                            {"SCRIPT_NONCE", request.nonce},
                            {"SCRIPT", std::string(replay_drawing_js) + live_view_js +
                                           studio_page_js + studio_controls_js}});
}

} // namespace integral
