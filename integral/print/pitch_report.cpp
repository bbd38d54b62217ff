// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/pitch_report.h"

#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/optics/film.h"

#include <stdexcept>

namespace integral {
namespace {

constexpr double vague_index = 0.1; // the report notes an index with a larger error

std::string plus_minus(const Measured& figure, int count)
{
    return with_decimals(figure.value, count) + " +- " + with_decimals(figure.error, count);
}

} // namespace

std::string pitch_report_text(const LensSheet& nominal, const PitchScale& scale,
                              const std::vector<ChartReading>& readings, const MeasuredSheet& found)
{
    std::string text;
    for (const ChartReading& reading : readings) {
        text += "even at " + with_digits(reading.distance, 9) + " mm: film pitch " +
                plus_minus(film_pitch_of(scale, reading), 5) + " mm, bar";
        for (const int bar : reading.bars)
            text += " " + std::to_string(bar);
        text += "\n";
    }
    text += "mechanical pitch    " + plus_minus(found.pitch, 5) + " mm, " +
            with_decimals(mm_per_inch / found.pitch.value, 4) + " lenses per inch\n";
    if (!found.index_measured)
        return text + "index               " + with_digits(nominal.ior, 9) +
               ", as the sheet has it\n";
    text += "index               " + plus_minus(found.index, 3) + " for a thickness of " +
            with_digits(nominal.thickness, 9) + " mm: " + with_decimals(found.least_index, 3) +
            (found.greatest_index > 0 ? " to " + with_decimals(found.greatest_index, 3)
                                      : " or more") +
            "\n";
    if (found.greatest_index > 0 && found.greatest_index - found.least_index < 2 * vague_index)
        return text;
    text += "these readings hardly tell the index: read from nearer and from farther, or a chart "
            "of finer steps\n";
    try {
        text += "with --keep-index   " +
                plus_minus(measured_sheet(nominal, scale, readings, true).pitch, 5) +
                " mm, by an index of " + with_digits(nominal.ior, 9) + "\n";
    } catch (const std::invalid_argument&) {
        text += "with --keep-index the readings contradict the index of " +
                with_digits(nominal.ior, 9) + "\n";
    }
    return text;
}

Json pitch_report_json(const PitchScale& scale, const std::vector<ChartReading>& readings,
                       const MeasuredSheet& found)
{
    Json json, list = Json::array();
    for (const ChartReading& reading : readings) {
        const Measured film = film_pitch_of(scale, reading);
        list.push_back({{"bars", reading.bars},
                        {"distance_mm", reading.distance},
                        {"film_pitch_mm", film.value},
                        {"error_mm", film.error}});
    }
    json["readings"] = list;
    json["pitch_mm"] = found.pitch.value;
    json["pitch_error_mm"] = found.pitch.error;
    json["ior"] = found.index.value;
    json["ior_measured"] = found.index_measured;
    json["ior_least"] = found.least_index;
    json["ior_greatest"] = found.greatest_index > 0 ? Json(found.greatest_index) : Json(nullptr);
    return json;
}

} // namespace integral
