// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/suite_summary.h"

#include "integral/base/folders.h"
#include "integral/base/number_text.h"
#include "integral/io/html_page.h"
#include "integral/io/image_file.h"
#include "integral/io/markup.h"

#include <filesystem>

namespace integral {
namespace {

constexpr int most_rows = 50;

/// Text within a cell of a Markdown table: no markup, no new cell.
std::string cell_text(const std::string& text)
{
    std::string escaped;
    for (const char c : markup_text(text)) {
        if (std::string("|\\`*_[]").find(c) != std::string::npos)
            escaped += '\\';
        escaped += c;
    }
    return escaped;
}

} // namespace

std::string thumbnail_name(const Suite& suite, const SuitePair& pair)
{
    return std::to_string(&pair - suite.pairs.data() + 1) + ".png";
}

std::string suite_markdown(const Suite& suite, const std::string& pictures)
{
    std::string text = std::string("### ") + (suite.passed() ? "✅" : "❌") +
                       " Pictures: " + suite_summary(suite) + "\n";
    for (const std::string& fault : suite.unused)
        text += "\n" + cell_text(suite.tolerances + ": " + fault) + "\n";
    int rows = 0, left_out = 0;
    for (const SuitePair& pair : suite.pairs) {
        if (pair.passed())
            continue;
        if (rows == most_rows) {
            ++left_out;
            continue;
        }
        if (rows++ == 0)
            text += "\n| Picture | Outcome | Reason | Reference, result, difference |\n"
                    "|---|---|---|---|\n";
        std::string reasons;
        for (const std::string& fault : pair.faults)
            reasons += (reasons.empty() ? "" : "<br>") + cell_text(fault);
        text += "| " + cell_text(pair.name) + " | " + name_of(pair.state) + " | " + reasons +
                " | " +
                (pair.thumbnail && !pictures.empty()
                     ? "![](" + link_to(pictures + "/" + thumbnail_name(suite, pair)) + ")"
                     : "") +
                " |\n";
    }
    if (left_out > 0)
        text += "\n" + counted(left_out, "more picture") + " failed.\n";
    return text;
}

void write_suite_summary(const Suite& suite, const std::string& path)
{
    namespace fs = std::filesystem;
    if (path == "-")
        return write_file(path, suite_markdown(suite, ""));
    const std::string folder = path + ".pictures";
    std::error_code ignored;
    fs::remove_all(folder, ignored); // pictures of an earlier run
    for (const SuitePair& pair : suite.pairs)
        if (pair.thumbnail) {
            make_folder(folder);
            write_frame(folder + "/" + thumbnail_name(suite, pair),
                        Frame{*pair.thumbnail, std::nullopt});
        }
    write_file(path, suite_markdown(suite, fs::path(folder).filename().string()));
}

} // namespace integral
