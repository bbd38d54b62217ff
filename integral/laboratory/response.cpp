// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/laboratory/response.h"

#include "integral/base/file_bytes.h"
#include "integral/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

namespace integral {
namespace {

using Sample = Response::Sample;

double between(double at, double a, double b, double value_a, double value_b)
{
    return b > a ? value_a + (at - a) / (b - a) * (value_b - value_a) : value_a;
}

/// Reads the numbers of a line, separated by blanks or commas. False if it has anything else.
bool read_numbers(const std::string& line, std::vector<double>& numbers)
{
    numbers.clear();
    const char *at = line.data(), *end = at + line.size();
    while (true) {
        while (at != end && (*at == ' ' || *at == '\t' || *at == ',' || *at == '\r'))
            ++at;
        if (at == end)
            return true;
        double value = 0;
        const auto read = std::from_chars(at, end, value);
        if (read.ec != std::errc() || !std::isfinite(value))
            return false;
        numbers.push_back(value);
        at = read.ptr;
    }
}

/// The profile that the process sculpts for a ramp, and the greys of the mask, made by `assumed`.
std::vector<Sample> sculpted_ramp(const Response& process, const Response& assumed, int grey_levels,
                                  int places)
{
    std::vector<Sample> profile;
    const double least = process.least_depth(), most = process.deepest();
    for (int k = 0; k < places; ++k) {
        const double requested = least + (most - least) * k / (places - 1);
        const double grey = std::round(assumed.grey(requested) * (grey_levels - 1)) /
                            (grey_levels - 1);
        profile.push_back({grey, process.depth(grey)});
    }
    return profile;
}

} // namespace

Response Response::linear(double deepest) { return Response({{0, 0}, {1, deepest}}); }

Response::Response(std::vector<Sample> samples) : samples_(std::move(samples))
{
    if (samples_.size() < 2)
        throw std::invalid_argument("a response needs two greys or more, with their depths");
    for (std::size_t k = 0; k < samples_.size(); ++k) {
        const Sample& s = samples_[k];
        if (!(s.grey >= 0 && s.grey <= 1))
            throw std::invalid_argument("grey " + with_digits(s.grey, 6) + " is not from 0 to 1");
        if (k > 0 && !(s.grey > samples_[k - 1].grey && s.depth >= samples_[k - 1].depth))
            throw std::invalid_argument("after grey " + with_digits(samples_[k - 1].grey, 6) +
                                        ", greys must rise and depths must not fall");
    }
    if (!(deepest() > least_depth()))
        throw std::invalid_argument("all greys give the same depth");
}

double Response::depth(double grey) const
{
    const auto above = std::lower_bound(samples_.begin(), samples_.end(), grey,
                                        [](const Sample& s, double g) { return s.grey < g; });
    if (above == samples_.begin())
        return samples_.front().depth;
    if (above == samples_.end())
        return samples_.back().depth;
    const Sample& below = *(above - 1);
    return between(grey, below.grey, above->grey, below.depth, above->depth);
}

double Response::grey(double depth) const
{
    const auto above = std::lower_bound(samples_.begin(), samples_.end(), depth,
                                        [](const Sample& s, double d) { return s.depth < d; });
    if (above == samples_.begin())
        return samples_.front().grey;
    if (above == samples_.end())
        return samples_.back().grey;
    const Sample& below = *(above - 1);
    return between(depth, below.depth, above->depth, below.grey, above->grey);
}

Response read_response(const std::string& path)
{
    const std::string name = display_name(path, "standard input");
    std::istringstream text(read_file(path));
    std::vector<Sample> samples;
    std::vector<double> numbers;
    std::string line;
    for (int number = 1; std::getline(text, line); ++number) {
        if (!read_numbers(line.substr(0, line.find('#')), numbers) ||
            (!numbers.empty() && numbers.size() != 2))
            throw InputError(name + ": line " + std::to_string(number) +
                             ": a grey from 0 to 1 and a depth in mm are expected");
        if (!numbers.empty())
            samples.push_back({numbers[0], numbers[1]});
    }
    try {
        return Response(std::move(samples));
    } catch (const std::invalid_argument& error) {
        throw InputError(name + ": " + error.what());
    }
}

std::string response_text(const Response& response)
{
    std::string text = "# grey (0 to 1), depth (mm)\n";
    for (const Sample& s : response.samples())
        text += with_digits(s.grey, 9) + ", " + with_digits(s.depth, 9) + "\n";
    return text;
}

Calibration calibrate(const Response& process, int grey_levels)
{
    constexpr int places = 4001; // on the ramp
    const double least = process.least_depth(), most = process.deepest();
    Response assumed({{0, least}, {1, most}});
    std::map<double, double> measured; // depths by grey, of all rounds
    std::vector<CalibrationRound> rounds;
    do {
        const auto profile = sculpted_ramp(process, assumed, grey_levels, places);
        CalibrationRound round;
        double squares = 0;
        for (int k = 0; k < places; ++k) {
            const double off = profile[std::size_t(k)].depth -
                               (least + (most - least) * k / (places - 1));
            round.greatest = std::max(round.greatest, std::fabs(off));
            squares += off * off;
            measured[profile[std::size_t(k)].grey] = profile[std::size_t(k)].depth;
        }
        round.rms = std::sqrt(squares / places);
        rounds.push_back(round);
        std::vector<Sample> samples;
        for (const auto& [grey, depth] : measured)
            samples.push_back({grey, depth});
        assumed = Response(std::move(samples));
    } while (rounds.size() < 2 || rounds.back().rms < 0.999 * rounds[rounds.size() - 2].rms);
    return {std::move(rounds), std::move(assumed)};
}

std::string rounds_text(const Calibration& calibration)
{
    std::string table = "round   greatest error (mm)   rms (mm)\n";
    for (std::size_t k = 0; k < calibration.rounds.size(); ++k) {
        const std::string number = std::to_string(k + 1);
        table += std::string(5 - number.size(), ' ') + number + "   " +
                 with_decimals(calibration.rounds[k].greatest, 6) + "              " +
                 with_decimals(calibration.rounds[k].rms, 6) + "\n";
    }
    return table;
}

} // namespace integral
