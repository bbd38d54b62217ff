// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the table of known sheets against include/integral.inc, and geometries written as the
// camera's words.
#include "integral/sheet/known_sheets.h"

#include "integral/optics/film.h"
#include "integral/sheet/camera_words.h"

#include <boost/test/unit_test.hpp>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

using namespace integral;

BOOST_AUTO_TEST_SUITE(sheet_known_sheets)

namespace {

std::string include_file()
{
    const char* const top = std::getenv("TOP");
    BOOST_REQUIRE_MESSAGE(top, "TOP is not set: run this by tests/run");
    std::ifstream file(std::string(top) + "/include/integral.inc");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A number of the include file: 1.27 or 25.4/60.
double number(const std::string& text)
{
    const auto slash = text.find('/');
    return std::stod(text) / (slash == std::string::npos ? 1 : std::stod(text.substr(slash + 1)));
}

} // namespace

BOOST_AUTO_TEST_CASE(the_include_file_has_the_same_sheets)
{
    const std::string text = include_file();
    const std::regex macro(
        "#macro Integral_Sheet_(\\w+)\\(\\) +lens_sheet \\{ (\\w+) pitch ([0-9./]+) "
        "+thickness ([0-9.]+) ior ([0-9.]+) \\} #end");
    std::set<std::string> names;
    for (std::sregex_iterator at(text.begin(), text.end(), macro), end; at != end; ++at) {
        names.insert((*at)[1]);
        for (const KnownSheet& known : known_sheets()) {
            if (known.name != (*at)[1])
                continue;
            const bool lenticular = known.sheet.arrangement == Arrangement::lenticular;
            BOOST_TEST((*at)[2] == (lenticular ? "lenticular" : "square"), known.name);
            BOOST_TEST(number((*at)[3]) == known.sheet.pitch, known.name);
            BOOST_TEST(number((*at)[4]) == known.sheet.thickness, known.name);
            BOOST_TEST(number((*at)[5]) == known.sheet.ior, known.name);
        }
    }
    for (const KnownSheet& known : known_sheets())
        BOOST_TEST(names.erase(known.name) == 1, known.name << " is not in include/integral.inc");
    BOOST_TEST(names.empty(), "include/integral.inc has " << *names.begin() << " besides");
}

BOOST_AUTO_TEST_CASE(commercial_sheets_are_found_by_their_lenses_per_inch)
{
    BOOST_TEST(sheet_of_lpi(60)->thickness == 1.28);
    BOOST_TEST(sheet_of_lpi(60.2)->thickness == 1.28); // as measured
    BOOST_TEST(!sheet_of_lpi(61).has_value());
    BOOST_TEST(!sheet_of_lpi(25.4 / 0.6).has_value()); // the thesis's are not sold
}

BOOST_AUTO_TEST_CASE(films_are_written_by_whole_dpi_or_by_their_pixel_pitch)
{
    const auto words = [](double x, double y) { return film_words({0, 0, {x, y}}); };
    BOOST_TEST(words(25.4 / 720, 25.4 / 720) == "film { dpi 720 }");
    BOOST_TEST(words(25.4 / 300, 25.4 / 600) == "film { dpi <300, 600> }");
    BOOST_TEST(words(0.207, 0.207) == "film { pixel_pitch <0.207, 0.207> }");
    // A feed error of 0.2% is no whole dpi, and is not rounded away.
    BOOST_TEST(words(0.035, 25.4 / 720 * 1.002).find("film { pixel_pitch <0.035, 0.03534") == 0);
}

BOOST_AUTO_TEST_SUITE_END()
