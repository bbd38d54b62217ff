// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the evaluation of pitch charts: simulated readings of known sheets (by Snell's law) give
// these sheets, and impossible readings are refused.
#include "integral/print/pitch_wizard.h"
#include "tests/unit/replay_frames.h"

#include <boost/test/unit_test.hpp>

#include <random>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(print_pitch_wizard)

namespace {

/// The pitch of lines that looks even to an eye on the axis: the distance between the film points
/// that the eye sees, by Snell's law, through the middle lens and through one close to it.
double even_pitch(const LensSheet& sheet, double distance)
{
    const Vec2 beside{1e-4, 0};
    return sheet.pitch * film_point(sheet, beside, beside, {0, 0, distance}).x / beside.x;
}

/// The reading for a pitch: the nearest bar, or two neighbouring bars if it is about half-way.
ChartReading reading_of(const PitchScale& scale, double pitch, double distance)
{
    const double place = 1 + (pitch - scale.first) / scale.step, low = std::floor(place);
    if (place - low > 0.3 && place - low < 0.7)
        return {{int(low), int(low) + 1}, distance};
    return {{int(std::lround(place))}, distance};
}

LensSheet sheet_of(double pitch, double thickness, double ior)
{
    LensSheet sheet;
    sheet.pitch = pitch;
    sheet.thickness = thickness;
    sheet.ior = ior;
    return sheet;
}

void refused(const PitchScale& scale, const std::vector<ChartReading>& readings,
             const std::string& words, bool keep_index = false)
{
    try {
        measured_sheet(sheet_of(1.27, 3.08, 1.6), scale, readings, keep_index);
        BOOST_ERROR("not refused: " << words);
    } catch (const std::invalid_argument& error) {
        BOOST_TEST((std::string(error.what()).find(words) != std::string::npos), error.what());
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(one_reading_gives_the_pitch)
{
    std::mt19937 random(7);
    const auto between = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random);
    };
    for (int k = 0; k < 1000; ++k) {
        const LensSheet truth = sheet_of(between(0.1, 5), between(0.1, 10), between(1, 4));
        const double distance = between(150, 3000), step = truth.pitch * between(0.0002, 0.005);
        const double even = even_pitch(truth, distance);
        const PitchScale scale{even - between(5, 20) * step, step, 40};
        LensSheet nominal = truth;
        nominal.pitch *= between(0.98, 1.02);
        const MeasuredSheet found = measured_sheet(nominal, scale,
                                                   {reading_of(scale, even, distance)});
        BOOST_TEST(!found.index_measured);
        BOOST_TEST(std::fabs(found.pitch.value - truth.pitch) <=
                   found.pitch.error * (1 + 1e-6) + 1e-9);
        BOOST_TEST(found.pitch.error <= step / 2 * (1 + 1e-9));
    }
}

BOOST_AUTO_TEST_CASE(readings_from_two_distances_give_pitch_and_index_of_a_fine_chart)
{
    // With so fine a scale readings are exact, and the result is the sheet itself.
    std::mt19937 random(8);
    const auto between = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random);
    };
    for (int k = 0; k < 1000; ++k) {
        const LensSheet truth = sheet_of(between(0.3, 3), between(0.5, 6), between(1.05, 3.9));
        const PitchScale scale{0.9 * truth.pitch, 1e-9 * truth.pitch, 200000000};
        std::vector<ChartReading> readings;
        for (const double distance : {between(150, 300), between(500, 900), between(1500, 3000)})
            readings.push_back(reading_of(scale, even_pitch(truth, distance), distance));
        if (k % 2)
            readings.pop_back();
        LensSheet nominal = truth;
        nominal.pitch = 1;
        nominal.ior = 2;
        const MeasuredSheet found = measured_sheet(nominal, scale, readings);
        BOOST_TEST(found.index_measured);
        BOOST_TEST(std::fabs(found.pitch.value / truth.pitch - 1) < 1e-8);
        BOOST_TEST(std::fabs(found.index.value / truth.ior - 1) < 1e-4);
        BOOST_TEST(found.index.error < 1e-4 * truth.ior);
    }
}

BOOST_AUTO_TEST_CASE(the_truth_is_within_the_stated_errors)
{
    std::mt19937 random(9);
    const auto between = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random);
    };
    int solved = 0;
    for (int k = 0; k < 2000; ++k) {
        const LensSheet truth = sheet_of(between(0.5, 2), between(2, 5), between(1.45, 1.7));
        const PitchScale scale{0.98 * truth.pitch, 0.0005 * truth.pitch, 200};
        std::vector<ChartReading> readings;
        for (const double distance : {between(150, 250), between(300, 500), between(1000, 3000)})
            readings.push_back(reading_of(scale, even_pitch(truth, distance), distance));
        const MeasuredSheet found = measured_sheet(truth, scale, readings);
        ++solved;
        BOOST_TEST(std::fabs(found.pitch.value - truth.pitch) <= found.pitch.error * (1 + 1e-6));
        BOOST_TEST(truth.ior >= found.least_index - 0.01 * found.index.error);
        BOOST_TEST((found.greatest_index == 0 ||
                    truth.ior <= found.greatest_index + 0.01 * found.index.error));
        const MeasuredSheet kept = measured_sheet(truth, scale, readings, true);
        BOOST_TEST(!kept.index_measured);
        BOOST_TEST(std::fabs(kept.pitch.value - truth.pitch) <= kept.pitch.error * (1 + 1e-6));
        BOOST_TEST(kept.pitch.error < found.pitch.error);
    }
    BOOST_TEST(solved == 2000);
}

BOOST_AUTO_TEST_CASE(readings_that_cannot_be_are_refused)
{
    const PitchScale scale{1.252, 0.002, 25};
    refused(scale, {}, "no reading");
    refused(scale, {{{}, 400}}, "no bar");
    refused(scale, {{{0}, 400}}, "bar 0 is not on a chart of 25");
    refused(scale, {{{51}, 400}}, "bar 51 is not on");
    refused(scale, {{{12, 15}, 400}}, "must be neighbours");
    refused(scale, {{{12}, 0}}, "distance");
    refused(scale, {{{12}, 400}, {{13}, 400}}, "all from 400 mm");
    refused(scale, {{{12}, 400}, {{13}, 900}}, "smaller pitch from farther away");
    refused(scale, {{{12}, 400}, {{12}, 900}}, "smaller pitch from farther away");
    refused(scale, {{{25}, 200}, {{2}, 900}}, "an index of 0.");
    refused(scale, {{{12}, 200}, {{11}, 210}}, "an index of 0.");
    refused(scale, {{{13}, 100}, {{11}, 900}}, "an index of 8.");
    refused(scale, {{{15}, 250}, {{5}, 400}, {{11}, 900}}, "contradict one another");
    refused(scale, {{{13}, 400}, {{20}, 400}}, "contradict one another", true);
    // The second direction repeats the bars of the first.
    const LensSheet sheet = sheet_of(1.27, 3.08, 1.6);
    BOOST_TEST(measured_sheet(sheet, scale, {{{13, 38}, 400}}).pitch.value ==
               measured_sheet(sheet, scale, {{{13}, 400}}).pitch.value);
}

BOOST_AUTO_TEST_SUITE_END()
