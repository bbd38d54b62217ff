// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/compare/seen.h"

#include "integral/base/message_text.h"
#include "integral/base/number_text.h"
#include "integral/compare/figures_text.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

/// Numbers with a separator between them; empty if the words are anything else.
std::vector<double> numbers_of(const std::string& words, char separator)
{
    std::vector<double> numbers;
    const char *at = words.data(), *const end = at + words.size();
    for (;;) {
        double value = 0;
        const auto read = std::from_chars(at, end, value);
        if (read.ec != std::errc() || !std::isfinite(value))
            return {};
        numbers.push_back(value);
        if (read.ptr == end)
            return numbers;
        if (*read.ptr != separator)
            return {};
        at = read.ptr + 1;
    }
}

constexpr int most_eyes_a_side = 16;
constexpr std::size_t most_eyes = 256;

} // namespace

SeenEyes seen_eyes_of(const std::vector<std::string>& words)
{
    SeenEyes eyes;
    const auto refuse = [](const std::string& word) {
        throw std::invalid_argument(
            "\"" + excerpt(word) +
            "\" are no eyes; give a grid CxR of up to 16x16, or X,Y,DISTANCE "
            "in mm for each of up to 256 eyes");
    };
    for (const std::string& word : words) {
        const auto grid = numbers_of(word, 'x'), place = numbers_of(word, ',');
        const auto is_side = [](double v) {
            return v >= 1 && v <= most_eyes_a_side && v == std::floor(v);
        };
        if (words.size() == 1 && grid.size() == 2 && is_side(grid[0]) && is_side(grid[1])) {
            eyes.columns = int(grid[0]);
            eyes.rows = int(grid[1]);
        } else if (place.size() == 3 && place[2] > 0 && eyes.places.size() < most_eyes) {
            eyes.places.push_back({place[0], place[1], place[2]});
        } else {
            refuse(word);
        }
    }
    if (words.empty())
        refuse("");
    return eyes;
}

std::string eye_text(const Vec3& eye)
{
    return with_digits(eye.x, 4) + "," + with_digits(eye.y, 4) + "," + with_digits(eye.z, 4);
}

std::string seen_text(const SeenFigures& seen)
{
    const SeenByEye& worst = seen.eyes[seen.worst];
    const auto place = [](Vec2 v) { return with_decimals(v.x, 2) + "," + with_decimals(v.y, 2); };
    std::string text = "seen by " + counted(int(seen.eyes.size()), "eye") +
                       ", the worst of each figure:\n" + figures_text(seen.overall) +
                       "worst eye           at " + eye_text(worst.eye) + " mm: " +
                       (worst.figures.flip
                            ? "FLIP " + with_digits(worst.figures.flip->mean, 6) + ", "
                            : "") +
                       "RMSE " + with_digits(worst.figures.rmse, 6) + "; most at " +
                       place(seen.place) + " mm of the sheet\n";
    if (seen.parallax)
        text += "parallax            differs by up to " +
                with_decimals(seen.parallax->greatest, 3) + " mm, at " +
                place(seen.parallax->place) + " mm; median " +
                with_decimals(seen.parallax->median, 3) + " mm of " +
                counted(seen.parallax->details, "detail") +
                "\n"
                "depth               differs by up to " +
                with_decimals(seen.parallax->greatest_depth, 2) + " mm; median " +
                with_decimals(std::fabs(seen.parallax->median_depth), 2) + " mm " +
                (seen.parallax->median_depth < 0 ? "nearer" : "farther back") + "\n";
    return text;
}

} // namespace integral
