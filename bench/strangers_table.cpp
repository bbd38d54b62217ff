// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/strangers.h"

#include "integral/base/file_bytes.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace integral::bench {

namespace {

/// Marks of lines about a whole scene, in the sheet's place. The setting's place contains the
/// reason why the scene is left out, or its kind.
constexpr const char *left_out_mark = "left out", *kind_mark = "kind";

/// Replaces characters that would end a field or a line by blanks.
std::string plain(std::string text)
{
    for (char& c : text)
        if (c == ',' || c == '\n' || c == '\r' || c == '|')
            c = ' ';
    return text;
}

std::string number(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

} // namespace

StrangersTable::StrangersTable(const std::string& file) : file_(file)
{
    if (!std::filesystem::exists(file)) {
        append("scene,sheet,setting,cpu_seconds,error,reference_error,estimate,low,high");
        return;
    }
    std::istringstream lines(read_file(file));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line))
        read_line(line);
}

void StrangersTable::read_line(const std::string& line)
{
    std::vector<std::string> fields(1);
    for (const char c : line) {
        if (c == ',')
            fields.emplace_back();
        else
            fields.back() += c;
    }
    if (fields.size() == 3 && fields[1] == left_out_mark) {
        left_out_[fields[0]] = fields[2];
        return;
    }
    if (fields.size() == 3 && fields[1] == kind_mark) {
        kinds_[fields[0]] = fields[2];
        return;
    }
    try {
        const auto value = [&](std::size_t k) { return std::stod(fields.at(k)); };
        StrangersRow row{value(3), value(4), value(5), std::nullopt};
        if (!fields.at(6).empty()) {
            row.estimate.emplace();
            row.estimate->rms = value(6);
            row.estimate->low = value(7);
            row.estimate->high = value(8);
        }
        panels_[{fields[0], fields[1]}][fields[2]] = row;
        left_out_.erase(fields[0]);
    } catch (const std::logic_error&) {
        throw std::runtime_error(file_ + ": not a line of this program: " + line);
    }
}

void StrangersTable::append(const std::string& line) const
{
    std::ofstream to(file_, std::ios::app);
    to << line << '\n';
    if (!to.flush())
        throw OutputError(file_ + ": cannot be written");
}

const StrangersRow* StrangersTable::find(const Key& panel, const std::string& setting) const
{
    const auto rows = panels_.find(panel);
    if (rows == panels_.end())
        return nullptr;
    const auto row = rows->second.find(setting);
    return row == rows->second.end() ? nullptr : &row->second;
}

void StrangersTable::add(const Key& panel, const std::string& setting, const StrangersRow& row)
{
    std::string estimate = ",,";
    if (row.estimate)
        estimate = number(row.estimate->rms) + "," + number(row.estimate->low) + "," +
                   number(row.estimate->high);
    append(panel.first + "," + panel.second + "," + setting + "," + number(row.cpu_seconds) + "," +
           number(row.error) + "," + number(row.floor) + "," + estimate);
    panels_[panel][setting] = row;
    left_out_.erase(panel.first);
}

const std::string* StrangersTable::kind(const std::string& scene) const
{
    const auto found = kinds_.find(scene);
    return found == kinds_.end() ? nullptr : &found->second;
}

void StrangersTable::set_kind(const std::string& scene, const std::string& kind)
{
    kinds_[scene] = plain(kind);
    append(scene + "," + kind_mark + "," + kinds_[scene]);
}

void StrangersTable::leave_out(const std::string& scene, const std::string& reason)
{
    std::string words = plain(reason);
    constexpr std::size_t most = 300;
    if (words.size() > most)
        words = "... " + words.substr(words.size() - most);
    append(scene + "," + left_out_mark + "," + words);
    left_out_[scene] = words;
}

} // namespace integral::bench
