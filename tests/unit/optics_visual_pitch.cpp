// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the conversion between the lenses' pitch and the pitch that a pitch test finds from a
// distance, in documents of sheets and of panels.
#include "integral/frame/frame_metadata.h"
#include "integral/optics/visual_pitch.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(optics_visual_pitch)

namespace {

std::string document(const std::string& pitch, const std::string& rest)
{
    return R"({"sheet": {"arrangement": "lenticular", )" + pitch +
           R"(, "thickness_mm": 4, "ior": 1.6}, )" + rest + "}";
}

std::string refusal(const std::string& text)
{
    try {
        frame_metadata_from_json(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

const std::string film = R"("film": {"pixel_pitch_mm": [0.1, 0.1]})",
                  seen = R"("micro_image_pitch_mm": 1.5)";

} // namespace

BOOST_AUTO_TEST_CASE(visual_pitch_and_its_inverse)
{
    for (const double ior : {1.0, 1.49, 1.6, 4.0})
        for (const double distance : {0.01, 300.0, 1e9})
            for (const double place : {0.0, 1.0, 150.0, 1e6}) {
                const LensSheet sheet{Arrangement::square, 0.6, 2.65, ior, 0, {}};
                const double visual = visual_pitch(0.6, sheet, distance, place);
                BOOST_TEST(pitch_of_visual(visual, sheet, distance, place) == 0.6,
                           boost::test_tools::tolerance(1e-15));
                // A lens at `place` images the eye so far beyond its own axis.
                const double beyond = place * sheet.thickness /
                                      std::sqrt(ior * ior * distance * distance +
                                                (ior * ior - 1) * place * place);
                BOOST_TEST(visual / 0.6 * place == place + beyond,
                           boost::test_tools::tolerance(1e-14));
            }
}

BOOST_AUTO_TEST_CASE(a_sheet_is_described_by_the_pitch_that_is_seen)
{
    // Seen from 800 mm, p (1 + 4/(1.6 800)) is 1.5 mm.
    const auto near = boost::test_tools::tolerance(1e-14);
    for (const char* const from :
         {R"("aperture": {"distance_mm": 800})", R"("viewing_distance_mm": 800)"}) {
        const FrameMetadata m = frame_metadata_from_json(document(seen, film + ", " + from));
        BOOST_TEST(m.sheet.pitch == 1.5 / 1.003125, near);
        BOOST_TEST(visual_pitch(m.sheet.pitch, m.sheet, 800) == 1.5, near);
        BOOST_TEST(m.aperture.distance == 800);
        BOOST_TEST(m.aperture.width == filling_aperture(m.sheet, 800)->width);
    }
    BOOST_TEST(
        refusal(
            document(seen + R"(, "pitch_mm": 1.5)", film + R"(, "viewing_distance_mm": 800)")) ==
        "sheet.micro_image_pitch_mm cannot stand beside pitch_mm: one follows from the other");
    BOOST_TEST(refusal(document(seen, film)) ==
               "sheet.micro_image_pitch_mm needs aperture.distance_mm, from where it is seen");
}

BOOST_AUTO_TEST_CASE(a_panel_description_is_a_geometry)
{
    const std::string panel =
        R"("panel": {"name": "mine", "width": 1920, "height": 1080, "pixel_pitch_mm": 0.25, "subpixels": "bgr"})";
    const FrameMetadata m = frame_metadata_from_json(
        document(seen, panel + R"(, "viewing_distance_mm": 800)"));
    BOOST_TEST(m.film.width == 1920);
    BOOST_TEST(m.film.pixel_pitch.y == 0.25);
    BOOST_CHECK(m.film.subpixels == Subpixels::bgr);
    BOOST_TEST(m.sheet.pitch == 1.5 / 1.003125, boost::test_tools::tolerance(1e-14));
    // Without a distance, two and a half times the diagonal of 480 x 270 mm.
    BOOST_TEST(frame_metadata_from_json(document(R"("pitch_mm": 1.5)", panel)).aperture.distance ==
                   2.5 * std::hypot(480, 270),
               boost::test_tools::tolerance(1e-12));
    for (const char* const calibration :
         {R"({"pitch": {"value": 52}, "DPI": {"value": 324}})", R"({"calibration": {}})",
          R"({"lineNumber": 19.6, "obliquity": 0.1, "deviation": 0})"})
        BOOST_TEST(refusal(calibration) ==
                   "it is a display's calibration; integral lcd --panel FILE --describe -o "
                   "PANEL.json makes the description that is read here");
}

BOOST_AUTO_TEST_SUITE_END()
