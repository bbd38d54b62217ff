// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/approval_page.h"

#include "integral/io/html_page.h"
#include "integral/io/image_file.h"
#include "integral/io/markup.h"
#include "integral/replay/replay_page.h"

namespace integral {
namespace {

constexpr char list_style[] = R"css(
form { margin: 0 0 16px; }
button { font: inherit; padding: 6px 14px; cursor: pointer; }
)css";

// Uses the colours of the replay page.
constexpr char bar_style[] = R"css(
#approval { background: var(--panel); border-bottom: 1px solid var(--line); padding: 8px 16px; }
#approval .row { display: flex; flex-wrap: wrap; gap: 8px 12px; align-items: center;
  max-width: 1088px; margin: 0 auto; }
#approval form { margin: 0; }
#approval a { color: inherit; }
#approval .accept { background: #1f4d2c; border-color: #3c8a55; }
#approval .reject { background: #5a2722; border-color: #a3554c; }
#approval p { flex-basis: 100%; margin: 0; overflow-wrap: anywhere; }
#approval .fault { color: #ff8f85; }
#approval .keys { color: var(--quiet); }
)css";

// Arrow keys act on the picture or slider that has the focus. Repeats of a held key are ignored, so
// that one keypress decides about one picture only.
constexpr char key_script[] = R"js(
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey || event.repeat)
    return;
  if (event.key === "Escape")
    document.activeElement?.blur();
  const is_arrow = event.key.startsWith("Arrow");
  const own = event.target.closest("input, body:not(.no-lenses) canvas");
  const keys = { a: "accept", r: "reject", ArrowLeft: "previous", ArrowRight: "next" };
  const target = is_arrow && own ? null : document.querySelector(`[data-key="${keys[event.key]}"]`);
  if (target) {
    event.preventDefault();
    target.click();
  }
});
)js";

const char* decision_text(Decision decision)
{
    return decision == Decision::accepted   ? "accepted"
           : decision == Decision::rejected ? "rejected"
                                            : "–";
}

std::string picture_link(std::size_t index, const ServerRequest& request)
{
    return request.base + "/picture/" + std::to_string(index + 1);
}

std::string link(const std::string& to, const char* key, const std::string& text)
{
    return "<a href=\"" + to + "\"" + (*key ? std::string(" data-key=\"") + key + "\"" : "") + ">" +
           text + "</a>";
}

std::string post_button(const std::string& to, const char* key, const std::string& text)
{
    return "<form method=\"post\" action=\"" + to + "\"><button class=\"" + key + "\" data-key=\"" +
           key + "\">" + text + "</button></form>";
}

/// The button's text: the effect of accepting on the reference.
std::string accept_words(const SuitePair& pair)
{
    return !pair.has_result      ? "Accept that it is gone (a)"
           : !pair.has_reference ? "Accept as a new reference (a)"
                                 : "Accept (a)";
}

/// The bar above the picture.
std::string bar(const ApprovalItem& item, std::size_t index, std::size_t count,
                const ServerRequest& request)
{
    const SuitePair& pair = *item.pair;
    const std::string own = picture_link(index, request);
    std::string html = "<nav id=\"approval\" aria-label=\"Approval\">\n<div class=\"row\">\n";
    if (item.decision != Decision::accepted)
        html += post_button(own + "/accept", "accept", accept_words(pair)) +
                post_button(own + "/reject", "reject", "Reject (r)");
    if (index > 0)
        html += link(picture_link(index - 1, request), "previous", "← Previous");
    if (index + 1 < count)
        html += link(picture_link(index + 1, request), "next", "Next →");
    html += link(request.base + "/", "", "All pictures") + "<span>" + std::to_string(index + 1) +
            " of " + std::to_string(count) + ": " + name_of(pair.state) +
            (item.decision == Decision::none ? ""
                                             : std::string(", ") + decision_text(item.decision)) +
            "</span>\n";
    if (item.decision != Decision::accepted)
        html += fault_lines(pair.faults);
    html +=
        "<p class=\"keys\">Left and right arrow: the pictures; on the picture itself (click, or "
        "Tab) they move the eye, until Escape.</p>\n";
    return html + "</div>\n</nav>\n";
}

/// A picture of a pair, if it can be read.
std::optional<Frame> read_if_there(bool is_there, const std::string& path)
{
    try {
        return is_there ? std::optional(read_frame(path)) : std::nullopt;
    } catch (const InputError&) { // noted as a fault by the comparison
        return std::nullopt;
    }
}

} // namespace

std::string approval_summary(const ApprovalCounts& counts)
{
    return std::to_string(counts.accepted) + " accepted, " + std::to_string(counts.rejected) +
           " rejected, " + std::to_string(counts.undecided) + " undecided";
}

std::string approval_list(const Suite& suite, const std::vector<ApprovalItem>& items,
                          const ServerRequest& request)
{
    const ApprovalCounts counts = counts_of(items);
    std::string rows, first;
    for (std::size_t k = 0; k < items.size(); ++k) {
        const ApprovalItem& item = items[k];
        if (item.decision == Decision::none && first.empty())
            first = link(picture_link(k, request), "next", "Look at the pictures →");
        std::string faults;
        for (const std::string& fault : item.pair->faults)
            faults += (faults.empty() ? "" : "<br>") + markup_text(fault);
        rows += "<tr><td data-label=\"File\"><span><a href=\"" + picture_link(k, request) + "\">" +
                markup_text(item.pair->name) + "</a></span></td><td data-label=\"Outcome\">" +
                name_of(item.pair->state) + "</td><td data-label=\"Reason\"><span>" + faults +
                "</span></td><td data-label=\"Decision\">" + decision_text(item.decision) +
                "</td></tr>\n";
    }
    const std::string
        body = "<h1>" + markup_text(suite.folders.results) + " against " +
               markup_text(suite.folders.references) + "</h1>\n<p>" + approval_summary(counts) +
               ". Accepting makes a result the reference at once.</p>\n<p>" + first + "</p>\n" +
               post_button(request.base + "/finish", "finish", "Finish") +
               "\n<table class=\"cards\">\n<thead><tr><th>File</th><th>Outcome</th><th>Reason</th>"
               "<th>Decision</th></tr></thead>\n<tbody>\n" +
               rows + "</tbody>\n</table>\n";
    return html_page("Approval: " + approval_summary(counts), list_style, body,
                     {key_script, request.nonce});
}

std::string approval_picture(const SuiteFolders& folders, const ApprovalItem& item,
                             std::size_t index, std::size_t count, const ServerRequest& request)
{
    const SuitePair& pair = *item.pair;
    const auto reference = read_if_there(pair.has_reference, folders.reference(pair.name)),
               result = read_if_there(pair.has_result, folders.result(pair.name));
    if (!reference && !result)
        return html_page(pair.name, std::string(list_style) + bar_style,
                         bar(item, index, count, request) + "<h1>" + markup_text(pair.name) +
                             "</h1>\n<p>There is no picture to show.</p>\n",
                         {key_script, request.nonce});
    ComparedPictures pictures;
    if (reference && result && pair.figures && item.decision != Decision::accepted)
        pictures = compared_pictures(*reference, *result, *pair.figures);
    pictures.reference = reference ? &*reference : nullptr;
    pictures.result = result ? &*result : nullptr;
    pictures.title = pair.name;
    PageAdditions additions;
    additions.head = "<style nonce=\"" + request.nonce + "\">" + bar_style + "</style>\n" +
                     bar(item, index, count, request);
    additions.end = "<script nonce=\"" + request.nonce + "\">" + key_script + "</script>\n";
    additions.nonce = request.nonce;
    additions.keys_for_pages = true;
    return comparison_page(pictures, additions);
}

std::string approval_refusal(const std::string& name, const std::string& why, std::size_t index,
                             const ServerRequest& request)
{
    return html_page(name, list_style,
                     "<h1>" + markup_text(name) + " was not accepted</h1>\n<p class=\"bad\">" +
                         markup_text(why) + "</p>\n<p>" +
                         link(picture_link(index, request), "next", "Look at it again →") +
                         "</p>\n",
                     {key_script, request.nonce});
}

std::string approval_end(const ApprovalCounts& counts, const ServerRequest& request)
{
    return html_page("Approval finished", list_style,
                     "<h1>Finished</h1>\n<p>" + approval_summary(counts) +
                         ". integral compare has ended; this page can be closed.</p>\n",
                     {"", request.nonce});
}

} // namespace integral
