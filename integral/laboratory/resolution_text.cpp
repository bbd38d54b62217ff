// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/laboratory/resolution_text.h"

#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/base/text_columns.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr std::size_t label_width = 24, cell_width = 7;

std::string line(const std::string& label, const std::vector<std::string>& cells)
{
    std::string text = label + std::string(label_width - std::min(label_width, label.size()), ' ');
    for (const std::string& cell : cells)
        text += right_aligned(cell, cell_width);
    return text + "\n";
}

/// The column of a frequency; the table's size if it is not there.
std::size_t column_of(const std::vector<double>& frequencies, double frequency)
{
    return std::size_t(std::find_if(frequencies.begin(), frequencies.end(),
                                    [&](double f) { return std::fabs(f / frequency - 1) < 1e-6; }) -
                       frequencies.begin());
}

using Figure = double ResolutionCell::*;

std::vector<std::string> figures(const std::vector<ResolutionCell>& row, Figure figure,
                                 const std::vector<std::size_t>& columns)
{
    std::vector<std::string> cells;
    for (const std::size_t column : columns)
        cells.push_back(column < row.size() ? with_decimals(row[column].*figure, 2) : "");
    return cells;
}

/// The number of frequencies that are resolved, from the lowest up to the first unresolved one.
int resolved(const std::vector<std::string>& cells)
{
    int count = 0;
    for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell, ++count)
        if (*cell == "x" || *cell == "" || (*cell != "v" && std::stod(*cell) < resolved_modulation))
            break;
    return count;
}

/// The tables, if one of the thesis's lines is `cycles_a_line` pairs of bars: 1 or 1/2.
std::string reading(const ResolutionRequest& request, const ResolutionTable& table,
                    const ThesisTable& thesis, double cycles_a_line)
{
    std::vector<std::size_t> columns;
    std::vector<std::string> heads;
    for (const double lines : thesis.frequencies) {
        columns.push_back(column_of(request.frequencies, lines * cycles_a_line));
        heads.push_back(with_digits(lines, 4));
    }
    std::string text = line("lines per mm", heads);
    for (std::size_t k = 0; k < table.size(); ++k) {
        const std::size_t row = column_of(thesis.depths, request.depths[k] + 1e-300);
        const auto screen = figures(table[k], &ResolutionCell::screen, columns);
        const std::string at = with_digits(request.depths[k], 4) + " mm ";
        const std::size_t depth = request.depths[k] == 0 ? 0 : row;
        if (depth < thesis.cells.size()) {
            const int steps = resolved(screen) - resolved(thesis.cells[depth]);
            text += line(at + thesis.name, thesis.cells[depth]);
            text += line("     screen", screen);
            text.insert(text.size() - 1, "   " + std::string(steps > 0 ? "+" : "") +
                                             std::to_string(steps) + " steps");
        } else
            text += line(at + "screen", screen);
        text += line("     lens and pixel", figures(table[k], &ResolutionCell::expected, columns));
        text += line("     eye", figures(table[k], &ResolutionCell::observer, columns));
    }
    return text;
}

} // namespace

const std::vector<ThesisTable>& thesis_tables()
{
    const std::vector<double> lines = {10, 5, 2, 1, 0.666, 0.5},
                              depths = {0, 5, 10, 15, 25, 30, 35};
    static const std::vector<ThesisTable> tables = {{"table 4-2",
                                                     1.27,
                                                     3.08,
                                                     1.6,
                                                     lines,
                                                     depths,
                                                     {{"x", "x", "x", "0.71", "v", "v"},
                                                      {"x", "x", "x", "x", "0.64", "v"},
                                                      {"x", "x", "x", "x", "0.43", "v"},
                                                      {"x", "x", "x", "x", "0.21", "v"},
                                                      {"x", "x", "x", "x", "x", "0.43"},
                                                      {"x", "x", "x", "x", "x", "0.18"},
                                                      {"x", "x", "x", "x", "x", "x"}}},
                                                    {"table 4-3",
                                                     0.6,
                                                     2.65,
                                                     1.52,
                                                     lines,
                                                     depths,
                                                     {{"x", "x", "0.54", "v", "v", "v"},
                                                      {"x", "0.07", "0.32", "v", "v", "v"},
                                                      {"x", "x", "0.11", "0.68", "v", "v"},
                                                      {"x", "x", "x", "0.39", "v", "v"},
                                                      {"x", "x", "x", "x", "0.65", "v"},
                                                      {"x", "x", "x", "x", "0.42", "v"},
                                                      {"x", "x", "x", "x", "x", "0.47"}}}};
    return tables;
}

std::string resolution_text(const ResolutionRequest& request, const ResolutionTable& table,
                            const ThesisTable* thesis)
{
    const LensSheet& sheet = request.sheet;
    std::string text = "Sheet of " + with_digits(sheet.pitch, 6) + " mm, " +
                       with_digits(25.4 / request.pixel_pitch.x, 4) + " dpi: modulation of bars " +
                       "in front of it (0.5 is resolved)\n";
    if (thesis)
        return text + "\nA line read as a bright and a dark bar:\n" +
               reading(request, table, *thesis, 1) + "\nA line read as one bar:\n" +
               reading(request, table, *thesis, 0.5);
    ThesisTable none{"", 0, 0, 0, request.frequencies, {}, {}};
    return text + "A line is a bright and a dark bar.\n" + reading(request, table, none, 1);
}

Json resolution_json(const ResolutionRequest& request, const ResolutionTable& table)
{
    Json cells = Json::array();
    for (std::size_t k = 0; k < table.size(); ++k)
        for (std::size_t j = 0; j < table[k].size(); ++j)
            cells.push_back({{"depth_mm", request.depths[k]},
                             {"cycles_per_mm", request.frequencies[j]},
                             {"screen", table[k][j].screen},
                             {"eye", table[k][j].observer},
                             {"lens_and_pixel", table[k][j].expected}});
    return {{"pitch_mm", request.sheet.pitch}, {"thickness_mm", request.sheet.thickness},
            {"ior", request.sheet.ior},        {"dpi", 25.4 / request.pixel_pitch.x},
            {"camera", request.camera_words},  {"cells", cells}};
}

ResolutionReport resolution_report(ResolutionRequest request, bool beside_thesis, int threads,
                                   const Progress& progress)
{
    const auto& thesis = thesis_tables();
    const int count = beside_thesis ? int(thesis.size()) : 1;
    ResolutionReport report;
    for (int k = 0; k < count; ++k) {
        const ThesisTable* beside = beside_thesis ? &thesis[std::size_t(k)] : nullptr;
        if (beside) {
            request.sheet.pitch = beside->pitch;
            request.sheet.thickness = beside->thickness;
            request.sheet.ior = beside->ior;
        }
        const ResolutionTable table = measured_resolution(request, threads,
                                                          piece_of(progress, k, count));
        report.text += (k > 0 ? "\n" : "") + resolution_text(request, table, beside);
        report.json.push_back(resolution_json(request, table));
    }
    return report;
}

} // namespace integral
