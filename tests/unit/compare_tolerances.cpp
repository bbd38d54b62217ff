// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the tolerances of a suite (the document, the entries that apply to a name, and the check of
// figures against limits), and the comparison of geometry.
#include "integral/compare/compare_geometry.h"
#include "integral/compare/tolerances.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(compare_tolerances)

namespace {

enum { rmse, psnr, ssim, difference, micro_image }; // the order of limit_kinds

std::string refusal(const std::string& text)
{
    try {
        tolerances_from_json(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

const std::string
    kinds = "; there are: max_rmse, min_psnr, min_ssim, max_difference, max_micro_image_rmse, "
            "max_differing, max_flip, channel_tolerance, ppd, ignore, weights, mask, seen, eyes";

} // namespace

BOOST_AUTO_TEST_CASE(limits_of_names)
{
    const Tolerances tolerances = tolerances_from_json(R"({
        "defaults": { "max_rmse": 0.002, "min_ssim": 0.99 },
        "files": {
            "glass/*": { "max_rmse": 0.01, "max_micro_image_rmse": 0.3 },
            "glass/ball.png": { "max_rmse": 0.03, "min_ssim": null },
            "?.exr": { "max_rmse": null, "min_ssim": null }
        } })");
    const Limits plain = limits_for(tolerances, "plain.png");
    BOOST_TEST(*plain[rmse] == 0.002);
    BOOST_TEST(*plain[ssim] == 0.99);
    BOOST_TEST(!plain[psnr]);
    BOOST_TEST(!plain[difference]);
    const Limits deep = limits_for(tolerances, "glass/deep/er.tiff");
    BOOST_TEST(*deep[rmse] == 0.01);
    BOOST_TEST(*deep[ssim] == 0.99);
    BOOST_TEST(*deep[micro_image] == 0.3);
    const Limits ball = limits_for(tolerances, "glass/ball.png");
    BOOST_TEST(*ball[rmse] == 0.03);
    BOOST_TEST(!ball[ssim]);
    BOOST_TEST(*ball[micro_image] == 0.3);
    // No limit is left, so the pictures must be equal.
    const Limits equal = limits_for(tolerances, "a.exr");
    BOOST_TEST(*equal[difference] == 0);
    BOOST_TEST(!equal[rmse]);
    BOOST_TEST(*limits_for(Tolerances(), "x.png")[difference] == 0);
    BOOST_TEST(tolerances.entries[1].line == 5);
}

BOOST_AUTO_TEST_CASE(names_and_globs)
{
    BOOST_TEST(matches("a.png", "a.png"));
    BOOST_TEST(!matches("a.png", "b/a.png"));
    BOOST_TEST(matches("*.png", "b/c/a.png"));
    BOOST_TEST(matches("b/*", "b/c/a.png"));
    BOOST_TEST(!matches("*.png", "a.PNG"));
    BOOST_TEST(matches("[ab].png", "b.png"));
    BOOST_TEST(!matches("[ab].png", "c.png"));
    BOOST_TEST(matches("[ab].png", "[ab].png")); // by its exact name
    BOOST_TEST(!matches("", "a.png"));
}

BOOST_AUTO_TEST_CASE(what_is_refused)
{
    BOOST_TEST(refusal("{}") == "");
    BOOST_TEST(refusal("{\n\n\"defaults\": {\n\"max_rms\": 1}}") ==
               "line 4: \"max_rms\" in \"defaults\" is unknown" + kinds);
    BOOST_TEST(refusal("{\"files\": {\n\"a\": {\"min_rmse\": 1}}}") ==
               "line 2: \"min_rmse\" in \"a\" is unknown" + kinds);
    BOOST_TEST(refusal("{\"files\": {},\n\"default\": {}}") ==
               "line 2: \"default\" is unknown; there are: defaults, files");
    BOOST_TEST(refusal("{\n\"files\": []}") == "line 2: \"files\" must be an object, { ... }");
    BOOST_TEST(refusal("{\"files\": {\n\n\"a\": 1}}") ==
               "line 3: \"a\" must be an object, { ... }");
    BOOST_TEST(refusal("[1]") == "line 1: the document must be an object, { ... }");
    const std::string number = " must be a number from 0 to 1e+06, or null for no limit";
    for (const char* bad : {"-0.1", "\"1\"", "true", "[]", "{}", "1e7"})
        BOOST_TEST(refusal(std::string("{\"defaults\":\n{\"max_rmse\": ") + bad + "}}") ==
                   "line 2: \"max_rmse\"" + number);
    BOOST_TEST(refusal("{\"defaults\": {\"min_ssim\": 1.01}}") ==
               "line 1: \"min_ssim\" must be a number from -1 to 1, or null for no limit");
    BOOST_TEST(refusal("{\"files\": {\"a\": {},\n\"b\": {},\n\"a\": {}}}") ==
               "line 3: the field a stands twice in one object");
    BOOST_TEST(refusal("{\"files\": {\"a\": {\"max_rmse\": 1,\n\"max_rmse\": 2}}}") ==
               "line 2: the field max_rmse stands twice in one object");
    BOOST_TEST(refusal("{\"files\": {\"a\": {\"max_rmse\": 1}, \"b\": {\"max_rmse\": 1}}}") == "");
    BOOST_TEST(refusal("{\n\n\"files\": {,}\n}\n") ==
               "line 3: this is no JSON: unexpected ','; expected string literal");
    BOOST_TEST(refusal("") == "line 1: this is no JSON: it is empty");
    BOOST_TEST(refusal("{\n\"defaults\": {\"max_rmse\": 1e999}}") ==
               "line 2: a number is out of range");
    BOOST_TEST(refusal(std::string(100000, '[')) ==
               "line 1: objects and lists are nested more than 64 deep; nest them less");
}

BOOST_AUTO_TEST_CASE(figures_against_limits)
{
    Comparison figures;
    figures.rmse = 0.2;
    figures.psnr = std::numeric_limits<double>::infinity();
    figures.ssim = 0.5;
    figures.largest_difference = std::nan("");
    Limits limits;
    BOOST_TEST(missed_limits(limits, figures).empty());
    // A figure equal to its limit is accepted, and so is a limit for a figure that does not exist.
    limits = {0.2, 1e6, 0.5, std::nullopt, 0};
    BOOST_TEST(missed_limits(limits, figures).empty());
    limits = {0.19, 40, 0.51, 1, 0.1};
    figures.worst = WorstMicroImage{{}, {}, 0.11};
    const std::vector<std::string> requested = {
        "RMSE 0.2 is greater than 0.19", "SSIM 0.5 is less than 0.51",
        "largest difference nan is greater than 1",
        "the worst micro-image's RMSE 0.11 is greater than 0.1"};
    BOOST_TEST(missed_limits(limits, figures) == requested, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(geometry)
{
    FrameMetadata reference;
    reference.film = {300, 200, {0.1, 0.1}, Subpixels::none};
    reference.aperture.distance = 300;
    reference.aperture.width = std::numeric_limits<double>::infinity();
    reference.render = RenderRecord();
    BOOST_TEST(geometry_difference_text({}, {}) == "");
    BOOST_TEST(geometry_difference_text(reference, reference) == "");
    BOOST_TEST(geometry_difference_text(reference, {}) == "it has no geometry, its reference has");
    BOOST_TEST(geometry_difference_text({}, reference) ==
               "it has geometry, its reference has none");

    FrameMetadata other = reference;
    other.render->seconds = 7;
    other.render->scene = "other.pov";
    other.render->mapping = LensMapping::closest;
    other.sheet.pitch = 1.27 * (1 + 1e-12);
    BOOST_TEST(geometry_difference_text(reference, other) == "");
    other.render->pseudoscopic = true;
    BOOST_TEST(geometry_difference_text(reference, other) ==
               "render.pseudoscopic is there, its reference has none");
    other.render.reset(); // unknown values are not compared
    BOOST_TEST(geometry_difference_text(reference, other) == "");
    other.film.pixel_pitch.y = 0.2;
    BOOST_TEST(geometry_difference_text(reference, other) ==
               "film.pixel_pitch_mm[1] is 0.2, its reference's 0.1");
    other.sheet.arrangement = Arrangement::square;
    BOOST_TEST(geometry_difference_text(reference, other) ==
               "sheet.arrangement is \"square\", its reference's \"lenticular\"");
    other = reference;
    other.aperture.width = 50;
    BOOST_TEST(geometry_difference_text(reference, other) ==
               "aperture.width_mm is 50.0, its reference's null");
    other = reference;
    other.quilt = QuiltRecord();
    BOOST_TEST(geometry_difference_text(other, reference) ==
               "quilt is missing, its reference has it");
}

BOOST_AUTO_TEST_SUITE_END()
