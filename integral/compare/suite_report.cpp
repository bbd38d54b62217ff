// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/suite_report.h"

#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/compare/figures_json.h"
#include "integral/compare/suite_pictures.h"
#include "integral/io/html_page.h"
#include "integral/io/junit_xml.h"
#include "integral/io/markup.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace integral {
namespace {

struct Counts {
    int compared = 0, failed = 0, missing = 0;
};

Counts counts_of(const Suite& suite)
{
    Counts counts;
    for (const SuitePair& pair : suite.pairs) {
        (pair.missing() ? counts.missing : counts.compared) += 1;
        counts.failed += !pair.missing() && !pair.passed();
    }
    return counts;
}

/// A fault of the tolerances with the name of their file: "suite.json: line 3: ...".
std::string unused_fault(const Suite& suite, const std::string& fault)
{
    return suite.tolerances + ": " + fault;
}

/// The pairs in the page's order: failed ones first.
std::vector<const SuitePair*> failed_first(const Suite& suite)
{
    std::vector<const SuitePair*> pairs;
    for (const SuitePair& pair : suite.pairs)
        pairs.push_back(&pair);
    std::stable_partition(pairs.begin(), pairs.end(),
                          [](const SuitePair* pair) { return !pair->passed(); });
    return pairs;
}

constexpr const char* column_names[limit_count] = {
    "RMSE", "PSNR, dB", "SSIM", "Largest difference", "Worst micro-image", "Differing", "FLIP"};

std::string figure_text(double figure, std::size_t kind)
{
    return std::isinf(figure) ? "∞"
           : kind == 1        ? with_decimals(figure, 2)
                              : limit_text(kind, figure, 4);
}

/// Whether any pair has this figure, so that the table has its column.
bool has_column(const Suite& suite, std::size_t kind)
{
    return kind < 4 || std::any_of(suite.pairs.begin(), suite.pairs.end(), [&](const SuitePair& p) {
               return p.figures && figure_of(*p.figures, kind) && (kind != 5 || p.limits[kind]);
           });
}

/// A cell of the table: a figure, and its limit below it.
std::string figure_cell(const SuitePair& pair, std::size_t kind)
{
    std::optional<double> figure;
    if (pair.figures)
        figure = figure_of(*pair.figures, kind);
    const std::string head = std::string("\" data-label=\"") + column_names[kind] + "\"><span>";
    if (!figure)
        return "<td class=\"number none" + head + "–</span></td>";
    const auto limit = pair.limits[kind];
    const bool bad = limit && !keeps(*figure, kind, *limit);
    std::string html = std::string("<td class=\"number") + (bad ? " bad" : "") + head +
                       figure_text(*figure, kind);
    if (limit)
        html += std::string("<span class=\"limit\">") + (limit_kinds[kind].is_most ? "≤ " : "≥ ") +
                limit_text(kind, *limit, 4) + "</span>";
    return html + "</span></td>";
}

std::string anchor_of(const Suite& suite, const SuitePair& pair)
{
    return "pair-" + std::to_string(&pair - suite.pairs.data() + 1);
}

std::string table(const Suite& suite, const std::vector<const SuitePair*>& pairs)
{
    std::string html = "<table class=\"cards\">\n<thead><tr><th>File</th><th>Outcome</th>";
    for (std::size_t kind = 0; kind < limit_count; ++kind)
        if (has_column(suite, kind))
            html += std::string("<th class=\"number\">") + column_names[kind] + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const SuitePair* pair : pairs) {
        html += std::string("<tr") + (pair->passed() ? "" : " class=\"failed\"") +
                "><td data-label=\"File\"><span><a href=\"#" + anchor_of(suite, *pair) + "\">" +
                markup_text(pair->name) + "</a></span></td><td data-label=\"Outcome\" class=\"" +
                (pair->passed() ? "good" : "bad") + "\">" + name_of(pair->state) + "</td>";
        for (std::size_t kind = 0; kind < limit_count; ++kind)
            if (has_column(suite, kind))
                html += figure_cell(*pair, kind);
        html += "</tr>\n";
    }
    return html + "</tbody>\n</table>\n";
}

/// "reference · result", each a link to its file.
std::string links(const Suite& suite, const SuitePair& pair, const std::string& folder)
{
    namespace fs = std::filesystem;
    if (folder.empty())
        return "";
    std::string html;
    const auto add = [&](bool is_there, const std::string& path, const char* name) {
        std::error_code ignored;
        const std::string relative = fs::proximate(fs::path(path), fs::path(folder), ignored)
                                         .string();
        if (is_there && !ignored)
            html += std::string(html.empty() ? "" : " · ") + "<a href=\"" + link_to(relative) +
                    "\">" + name + "</a>";
    };
    add(pair.has_reference, suite.folders.reference(pair.name), "reference");
    add(pair.has_result, suite.folders.result(pair.name), "result");
    return "<p class=\"quiet\">Files: " + html + "</p>\n";
}

constexpr char style[] = R"css(
.fault { margin: 0 0 2px; color: var(--bad); overflow-wrap: anywhere; }
.outcome { font-size: 1.1rem; font-weight: 600; }
.limit { display: block; color: var(--quiet); font-size: 0.87rem; font-weight: 400; }
tr.failed > td:first-child { box-shadow: inset 4px 0 var(--bad); }
td.bad { font-weight: 600; }
@media (max-width: 760px) {
  tr.failed > td:first-child { box-shadow: none; }
  tr.failed { box-shadow: inset 4px 0 var(--bad); }
  td.none { display: none !important; }
}
)css";

} // namespace

bool Suite::passed() const
{
    return unused.empty() && std::all_of(pairs.begin(), pairs.end(),
                                         [](const SuitePair& pair) { return pair.passed(); });
}

std::string suite_summary(const Suite& suite)
{
    const Counts counts = counts_of(suite);
    std::string text = std::to_string(counts.compared) + " compared, " +
                       std::to_string(counts.failed) + " failed, " +
                       std::to_string(counts.missing) + " missing";
    if (!suite.unused.empty())
        text += ", " + counted(int(suite.unused.size()), "tolerance") + " for no file";
    return text;
}

std::string fault_lines(const std::vector<std::string>& faults)
{
    std::string html;
    for (const std::string& fault : faults)
        html += "<p class=\"fault\">" + markup_text(fault) + "</p>\n";
    return html;
}

std::string suite_page(const Suite& suite, const std::string& folder)
{
    const auto pairs = failed_first(suite);
    std::string body = "<h1>" + markup_text(suite.folders.results) + " against " +
                       markup_text(suite.folders.references) + "</h1>\n";
    body += std::string("<p class=\"outcome ") + (suite.passed() ? "good" : "bad") + "\">" +
            (suite.passed() ? "Passed" : "Failed") + ": " + suite_summary(suite) + "</p>\n";
    std::vector<std::string> unused;
    for (const std::string& fault : suite.unused)
        unused.push_back(unused_fault(suite, fault));
    body += fault_lines(unused) + table(suite, pairs);
    const auto section = [&](const SuitePair& pair) {
        return "<section id=\"" + anchor_of(suite, pair) + "\">\n<h2>" + markup_text(pair.name) +
               "</h2>\n" + fault_lines(pair.faults) + links(suite, pair, folder) + pair.comparator +
               pair.pictures + "</section>\n";
    };
    std::string passed;
    for (const SuitePair* pair : pairs)
        (pair->passed() ? passed : body) += section(*pair);
    body += passed + suite.comparator;
    return html_page("integral compare: " + suite_summary(suite),
                     std::string(suite_pictures_style) + style + suite.comparator_style, body,
                     {suite.comparator_script, ""});
}

std::string suite_json(const Suite& suite)
{
    const Counts counts = counts_of(suite);
    Json json = {{"compared", counts.compared},       {"failed", counts.failed},
                 {"missing", counts.missing},         {"passed", suite.passed()},
                 {"unused_tolerances", suite.unused}, {"files", Json::array()}};
    for (const SuitePair& pair : suite.pairs) {
        Json file = {{"name", pair.name},
                     {"outcome", name_of(pair.state)},
                     {"faults", pair.faults},
                     {"limits", Json::object()},
                     {"figures", nullptr}};
        for (std::size_t kind = 0; kind < limit_count; ++kind)
            if (pair.limits[kind])
                file["limits"][limit_kinds[kind].word] = *pair.limits[kind];
        if (pair.figures)
            file["figures"] = figures_json(*pair.figures);
        json["files"].push_back(file);
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) +
           "\n"; // replaces bytes of names that are not UTF-8
}

std::string suite_junit(const Suite& suite)
{
    std::vector<JUnitCase> cases;
    const auto add = [&](const std::string& name, JUnitOutcome outcome, const std::string& type,
                         const std::vector<std::string>& faults) {
        cases.push_back({"integral.compare", name, outcome, type, faults, std::nullopt, ""});
    };
    for (const SuitePair& pair : suite.pairs)
        add(pair.name,
            pair.faults.empty()                ? JUnitOutcome::passed
            : pair.state == PairState::damaged ? JUnitOutcome::error
                                               : JUnitOutcome::failure,
            name_of(pair.state), pair.faults);
    for (const std::string& fault : suite.unused)
        add(unused_fault(suite, fault), JUnitOutcome::failure, "tolerance", {fault});
    return junit_xml(suite.folders.results, cases);
}

} // namespace integral
