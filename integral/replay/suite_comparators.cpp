// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/replay/suite_comparators.h"

#include "build/generated/page_texts.h" // report_comparator_js
#include "integral/base/interrupt.h"
#include "integral/base/json.h"
#include "integral/io/image_file.h"
#include "integral/io/markup.h"
#include "integral/replay/replay_page.h"

namespace integral {
namespace {

constexpr char style[] = R"css(
button { font: inherit; color: inherit; background: var(--ground); border: 1px solid var(--quiet);
  border-radius: 4px; padding: 6px 12px; cursor: pointer; }
#comparator { width: min(1160px, 100vw); max-width: none; height: 100vh; height: 100dvh;
  max-height: none; padding: 0; border: 0; background: #18191b; }
#comparator[open] { display: flex; flex-direction: column; }
#comparator button { margin: 8px; align-self: flex-end; color: #e8e8e6; background: #33363a; }
#comparator iframe { flex: 1; width: 100%; border: 0; }
)css";

constexpr char dialog[] = R"html(<dialog id="comparator" aria-label="Comparison">
<button type="button">Close (Esc)</button>
<iframe title="Both pictures, compared"></iframe>
</dialog>
)html";

/// Text in a <script> that holds data.
std::string data_element(const std::string& id, const std::string& json)
{
    return "<script type=\"application/json\" id=\"" + id + "\">" + json_within_html(json) +
           "</script>\n";
}

/// The pieces of a pair's comparison as JSON; empty if one of the files cannot be read.
std::string pieces_of(const SuitePair& pair, const SuiteFolders& folders)
{
    try {
        const Frame reference = read_frame(folders.reference(pair.name)),
                    result = read_frame(folders.result(pair.name));
        ComparedPictures pictures{&reference, &result, "", std::nullopt};
        if (pair.figures)
            pictures = compared_pictures(reference, result, *pair.figures);
        pictures.title = pair.name;
        Json json = Json::object();
        for (const auto& [name, piece] : comparison_pieces(pictures))
            json[name] = piece;
        return json.dump(-1, ' ', false, Json::error_handler_t::replace);
    } catch (const InputError&) { // the comparison has noted this as a fault
        return "";
    }
}

} // namespace

void add_comparators(Suite& suite, std::size_t limit)
{
    std::size_t number = 0, used = 0;
    bool is_full = false; // from the first pair on that does not fit
    for (SuitePair& pair : suite.pairs) {
        if (pair.passed() || pair.missing() || pair.state == PairState::damaged)
            continue;
        stop_if_interrupted();
        const std::string pieces = is_full ? "" : pieces_of(pair, suite.folders);
        if (pieces.empty() && !is_full)
            continue;
        is_full = is_full || used + pieces.size() > limit;
        if (is_full) {
            pair.comparator = "<p class=\"quiet\">To compare both as an eye sees them: "
                              "<code>integral compare " +
                              markup_text(for_shell(suite.folders.reference(pair.name)) + " " +
                                          for_shell(suite.folders.result(pair.name))) +
                              " --html page.html</code> (this report holds at most " +
                              std::to_string(limit >> 20) + " MB of such pictures)</p>\n";
            continue;
        }
        used += pieces.size();
        const std::string id = "comparison-" + std::to_string(++number);
        pair.comparator =
            "<p><button type=\"button\" data-comparison=\"" + id +
            "\" hidden>Compare both: move the eye, blink, side by side</button></p>\n" +
            data_element(id, pieces);
    }
    if (number == 0)
        return;
    suite.comparator = dialog + data_element("comparison-shell", Json(comparison_shell()).dump());
    suite.comparator_style = style;
    suite.comparator_script = report_comparator_js;
}

} // namespace integral
