// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the JSON document of a frame: what is written can be read back, and invalid documents are
// refused.
#include "integral/frame/frame.h"
#include "integral/frame/names.h"
#include "integral/frame/recorded_camera.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(frame_metadata)

namespace {

/// A document with every field, in which tests replace one piece of text.
const char complete[] =
    R"({"sheet": {"arrangement": "hexagonal", "pitch_mm": 1.5, "thickness_mm": 3.25, "ior": 1.6,)"
    R"( "slant_degrees": -12.5, "offset_mm": [0.25, -0.5]},)"
    R"( "film": {"width": 640, "height": 480, "pixel_pitch_mm": [0.1, 0.2], "subpixels": "bgr"},)"
    R"( "aperture": {"distance_mm": 300, "width_mm": null, "height_mm": 40, "shape": "ellipse"},)"
    R"( "camera": {"origin": [1, 2, 3], "x": [1, 0, 0], "y": [0, 1, 0], "z": [0, 0, 1], "units_per_mm": 0.5},)"
    R"( "encoding": {"kind": "power", "gamma": 1.8},)"
    R"( "render": {"program": "p 1", "scene": "s.pov", "model": "full", "mapping": "accurate",)"
    R"( "pixel_samples": 4, "beam_samples": 16, "draft": 4, "pseudoscopic": true,)"
    R"( "display_prefilter": true, "seconds": 7,)"
    R"( "error": {"rms": 0.01, "low": 0.005, "high": 0.02, "confidence": 0.95, "method": "audit", "pixels": 1000,)"
    R"( "lit_pixels": 19200, "samples": 17, "seconds": 0.5}}})";

std::string with(const std::string& old_text, const std::string& new_text)
{
    std::string text = complete;
    const auto at = text.find(old_text);
    BOOST_REQUIRE_MESSAGE(at != std::string::npos, old_text);
    return text.replace(at, old_text.size(), new_text);
}

/// The message with which a document is refused; "" if it is not.
std::string refusal(const std::string& text)
{
    try {
        frame_metadata_from_json(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

void check_equal(Vec2 a, Vec2 b)
{
    BOOST_TEST(a.x == b.x);
    BOOST_TEST(a.y == b.y);
}

void check_equal(Vec3 a, Vec3 b)
{
    BOOST_TEST(a.x == b.x);
    BOOST_TEST(a.y == b.y);
    BOOST_TEST(a.z == b.z);
}

} // namespace

BOOST_AUTO_TEST_CASE(reads_every_field)
{
    const FrameMetadata m = frame_metadata_from_json(complete);
    BOOST_CHECK(m.sheet.arrangement == Arrangement::hexagonal);
    BOOST_TEST(m.sheet.pitch == 1.5);
    BOOST_TEST(m.sheet.thickness == 3.25);
    BOOST_TEST(m.sheet.ior == 1.6);
    BOOST_TEST(m.sheet.slant == -12.5);
    check_equal(m.sheet.offset, {0.25, -0.5});
    BOOST_TEST(m.film.width == 640);
    BOOST_TEST(m.film.height == 480);
    check_equal(m.film.pixel_pitch, {0.1, 0.2});
    BOOST_TEST(m.aperture.distance == 300);
    BOOST_TEST(std::isinf(m.aperture.width));
    BOOST_TEST(m.aperture.height == 40);
    BOOST_CHECK(m.aperture.shape == ApertureShape::ellipse);
    BOOST_REQUIRE(m.placement);
    check_equal(m.placement->origin, {1, 2, 3});
    BOOST_TEST(m.placement->units_per_mm == 0.5);
    BOOST_CHECK(m.encoding.kind == Encoding::Kind::power);
    BOOST_TEST(m.encoding.gamma == 1.8);
    BOOST_REQUIRE(m.render);
    BOOST_TEST(m.render->program == "p 1");
    BOOST_TEST(m.render->scene == "s.pov");
    BOOST_CHECK(m.render->mapping == LensMapping::accurate);
    BOOST_TEST(m.render->seconds == 7);
    BOOST_CHECK(m.film.subpixels == Subpixels::bgr);
    BOOST_CHECK(m.render->model == LensModel::full);
    BOOST_TEST(m.render->pixel_samples == 4);
    BOOST_TEST(m.render->beam_samples == 16);
    BOOST_TEST(m.render->draft == 4);
    BOOST_TEST(m.render->pseudoscopic);
    BOOST_TEST(m.render->display_prefilter);
    BOOST_REQUIRE(m.render->error);
    BOOST_TEST(m.render->error->rms == 0.01);
    BOOST_TEST(m.render->error->low == 0.005);
    BOOST_TEST(m.render->error->high == 0.02);
    BOOST_TEST(m.render->error->confidence == 0.95);
    BOOST_CHECK(m.render->error->method == ErrorMethod::audit);
    BOOST_TEST(m.render->error->pixels == 1000);
    BOOST_TEST(m.render->error->lit_pixels == 19200);
    BOOST_TEST(m.render->error->samples == 17);
    BOOST_TEST(m.render->error->seconds == 0.5);
}

BOOST_AUTO_TEST_CASE(views_say_which_they_are)
{
    const std::string frame = complete;
    const std::string text = frame.substr(0, frame.rfind('}')) +
                             R"(, "quilt": {"columns": 5, "rows": 9, "view": 44,
        "eyes": {"distance_mm": 350, "width_mm": 120.5, "height_mm": 0}}})";
    const auto read = frame_metadata_from_json(
        frame_metadata_from_json(text).quilt ? to_json(frame_metadata_from_json(text)) : "");
    BOOST_REQUIRE(read.quilt);
    BOOST_TEST(read.quilt->grid.columns == 5);
    BOOST_TEST(read.quilt->grid.rows == 9);
    BOOST_TEST(*read.quilt->view == 44);
    BOOST_REQUIRE(read.quilt->eyes);
    BOOST_TEST(read.quilt->eyes->distance == 350);
    check_equal(read.quilt->eyes->zone, {120.5, 0});
    BOOST_TEST(!frame_metadata_from_json(frame).quilt);
    const struct {
        const char *old_text, *new_text, *named;
    } cases[] = {{"\"view\": 44", "\"view\": 45", "quilt.view is 45"},
                 {"\"columns\": 5", "\"columns\": 0", "quilt.columns is 0"},
                 {"\"rows\": 9", "\"rows\": 9.5", "quilt.rows must be a whole"},
                 {"350", "0", "quilt.eyes.distance_mm is 0"},
                 {"120.5", "-1", "quilt.eyes.width_mm is -1"},
                 {"\"rows\": 9,", "", "quilt.rows is missing"}};
    for (const auto& c : cases) {
        std::string bad = text;
        bad.replace(bad.find(c.old_text, bad.find("quilt")), std::string(c.old_text).size(),
                    c.new_text);
        try {
            frame_metadata_from_json(bad);
            BOOST_ERROR(std::string(c.new_text) + " was read");
        } catch (const std::invalid_argument& error) {
            BOOST_TEST(std::string(error.what()).find(c.named) != std::string::npos, error.what());
        }
    }
}

/// The subpixel layout with this number: the orders of stripes come first, then the cell patterns,
/// with random places.
template <class Place> static Subpixels subpixels_numbered(int number, Place place)
{
    if (number < 5)
        return static_cast<Subpixels::Order>(number);
    Subpixels subpixels;
    subpixels.order = Subpixels::cells;
    subpixels.pattern = static_cast<CellPattern>(number - 4);
    subpixels.number = number - 4;
    for (int k = 0; k < subpixels.number; ++k)
        for (Vec2& at : subpixels.cell[k])
            at = {place(), place()};
    return subpixels;
}

BOOST_AUTO_TEST_CASE(random_documents_read_back_to_the_same_doubles)
{
    std::mt19937_64 random(1);
    const auto between = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random);
    };
    for (int i = 0; i < 2000; ++i) {
        FrameMetadata m;
        m.sheet.arrangement = static_cast<Arrangement>(i % 3);
        m.sheet.pitch = std::pow(10, between(-4, 3));
        m.sheet.thickness = std::pow(10, between(-6, 6));
        m.sheet.ior = between(1, 4);
        m.sheet.slant = between(-90, 90);
        m.sheet.offset = {between(-1e6, 1e6), between(-1, 1)};
        m.film = {1 + i,
                  1000000 - i,
                  {std::pow(10, between(-6, 4)), between(0.001, 1)},
                  subpixels_numbered(i % 9, [&] { return between(-1, 1); })};
        m.aperture.distance = std::pow(10, between(-2, 9));
        m.aperture.width = i % 5 ? std::pow(10, between(-9, 15))
                                 : std::numeric_limits<double>::infinity();
        // Only the slit of upright lenses may have no height.
        const bool is_slit = m.sheet.arrangement == Arrangement::lenticular &&
                             slit_is_horizontal(m.sheet);
        m.aperture.height = i % 7 || !is_slit ? between(1e-6, 1) : 0;
        m.aperture.shape = static_cast<ApertureShape>(i % 2);
        m.encoding.kind = static_cast<Encoding::Kind>(i % 3);
        m.encoding.gamma = between(1, 3);
        if (i % 2) {
            const auto v = [&] {
                return Vec3{between(-1, 1) * 1e-9, between(-1e9, 1e9), between(-1, 1)};
            };
            m.placement = Placement{v(), v(), v(), v(), between(1e-6, 1e6)};
        }
        if (i % 3) {
            RenderRecord record;
            record.program = "povray-integral \"1\"\n\xc3\xa9";
            record.scene = "a\\b.pov";
            record.mapping = static_cast<LensMapping>(i % 4);
            record.model = static_cast<LensModel>(i % 4);
            record.pixel_samples = 1 + i;
            record.beam_samples = 65536 - i;
            record.pseudoscopic = i % 5 == 0;
            record.draft = 1 + i % 7;
            record.display_prefilter = i % 7 == 0;
            record.seconds = between(0, 1e6);
            if (i % 2)
                record.error = ErrorEstimate{between(0, 1),
                                             between(0, 1),
                                             between(0, 1),
                                             between(0, 1),
                                             i % 4 == 1 ? ErrorMethod::audit
                                                        : ErrorMethod::split_halves,
                                             1000LL * i,
                                             1000000LL * i,
                                             i,
                                             between(0, 1e6)};
            m.render = record;
        }

        const FrameMetadata n = frame_metadata_from_json(to_json(m));
        BOOST_CHECK(n.sheet.arrangement == m.sheet.arrangement);
        BOOST_TEST(n.sheet.pitch == m.sheet.pitch);
        BOOST_TEST(n.sheet.thickness == m.sheet.thickness);
        BOOST_TEST(n.sheet.ior == m.sheet.ior);
        BOOST_TEST(n.sheet.slant == m.sheet.slant);
        check_equal(n.sheet.offset, m.sheet.offset);
        BOOST_TEST(n.film.width == m.film.width);
        BOOST_TEST(n.film.height == m.film.height);
        check_equal(n.film.pixel_pitch, m.film.pixel_pitch);
        BOOST_CHECK(same_layout(n.film.subpixels, m.film.subpixels));
        BOOST_TEST(n.aperture.distance == m.aperture.distance);
        BOOST_TEST(n.aperture.width == m.aperture.width);
        BOOST_TEST(n.aperture.height == m.aperture.height);
        BOOST_CHECK(n.aperture.shape == m.aperture.shape);
        BOOST_CHECK(n.encoding.kind == m.encoding.kind);
        if (m.encoding.kind == Encoding::Kind::power)
            BOOST_TEST(n.encoding.gamma == m.encoding.gamma);
        BOOST_REQUIRE(n.placement.has_value() == m.placement.has_value());
        if (m.placement) {
            check_equal(n.placement->origin, m.placement->origin);
            check_equal(n.placement->x, m.placement->x);
            check_equal(n.placement->y, m.placement->y);
            check_equal(n.placement->z, m.placement->z);
            BOOST_TEST(n.placement->units_per_mm == m.placement->units_per_mm);
        }
        BOOST_REQUIRE(n.render.has_value() == m.render.has_value());
        if (m.render) {
            BOOST_TEST(n.render->program == m.render->program);
            BOOST_TEST(n.render->scene == m.render->scene);
            BOOST_CHECK(n.render->mapping == m.render->mapping);
            BOOST_TEST(n.render->seconds == m.render->seconds);
            BOOST_CHECK(n.render->model == m.render->model);
            BOOST_TEST(n.render->pixel_samples == m.render->pixel_samples);
            BOOST_TEST(n.render->beam_samples == m.render->beam_samples);
            BOOST_TEST(n.render->pseudoscopic == m.render->pseudoscopic);
            BOOST_TEST(n.render->draft == m.render->draft);
            BOOST_TEST(n.render->display_prefilter == m.render->display_prefilter);
            BOOST_REQUIRE(n.render->error.has_value() == m.render->error.has_value());
            if (m.render->error) {
                BOOST_TEST(n.render->error->rms == m.render->error->rms);
                BOOST_TEST(n.render->error->low == m.render->error->low);
                BOOST_TEST(n.render->error->high == m.render->error->high);
                BOOST_TEST(n.render->error->confidence == m.render->error->confidence);
                BOOST_CHECK(n.render->error->method == m.render->error->method);
                BOOST_TEST(n.render->error->pixels == m.render->error->pixels);
                BOOST_TEST(n.render->error->lit_pixels == m.render->error->lit_pixels);
                BOOST_TEST(n.render->error->samples == m.render->error->samples);
                BOOST_TEST(n.render->error->seconds == m.render->error->seconds);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(what_may_be_absent)
{
    const FrameMetadata m = frame_metadata_from_json(
        R"({"sheet": {"arrangement": "square", "pitch_mm": 1.27, "thickness_mm": 3.08, "ior": 1.6},)"
        R"( "film": {"pixel_pitch_mm": [0.1, 0.1]}, "aperture": {"distance_mm": 300}, "new": {"a": [1]}})");
    BOOST_TEST(m.film.width == 0);
    BOOST_TEST(m.film.height == 0);
    BOOST_TEST(m.sheet.slant == 0);
    BOOST_CHECK(m.encoding.kind == Encoding::Kind::srgb);
    BOOST_CHECK(!m.placement && !m.render);
    BOOST_TEST(m.aperture.width == 204.8295, boost::test_tools::tolerance(1e-6)); // fills the lens
    BOOST_TEST(m.aperture.height == m.aperture.width);
}

BOOST_AUTO_TEST_CASE(a_panel_s_own_viewing_distance_replaces_the_nominal_one)
{
    const std::string sheet =
        R"({"sheet": {"arrangement": "lenticular", "pitch_mm": 1, "thickness_mm": 3, "ior": 1.5})";
    const std::string panel = R"(, "panel": {"width": 300, "height": 400, "pixel_pitch_mm": 0.1})";
    BOOST_TEST(frame_metadata_from_json(sheet + panel + R"(, "viewing_distance_mm": 350})")
                   .aperture.distance == 350);
    // 2.5 diagonals of 30 mm x 40 mm
    BOOST_TEST(frame_metadata_from_json(sheet + panel + "}").aperture.distance == 125,
               boost::test_tools::tolerance(1e-12));
    // A print has no nominal distance.
    BOOST_TEST(refusal(sheet + R"(, "film": {"pixel_pitch_mm": [0.1, 0.1]}})") ==
               "aperture is missing");
}

BOOST_AUTO_TEST_CASE(a_recorded_camera_stands_in_its_sheet_s_space_or_in_the_scene)
{
    FrameMetadata m = frame_metadata_from_json(complete);
    m.parallax = Parallax{0.5, 200};
    const IntegralCamera in_scene = recorded_camera(m, CameraSpace::scene);
    check_equal(in_scene.placement.origin, {1, 2, 3});
    BOOST_TEST(in_scene.placement.units_per_mm == 0.5);
    BOOST_REQUIRE(in_scene.parallax);
    BOOST_TEST(in_scene.parallax->factor == 0.5);
    BOOST_TEST(in_scene.relief.depth == relief_of(m).depth);
    BOOST_TEST(in_scene.relief.depth != 1);
    const IntegralCamera in_sheet = recorded_camera(m);
    check_equal(scene_from_sheet(in_sheet.placement, {10, 20, 30}), {10, 20, 30});
    BOOST_TEST(in_sheet.placement.units_per_mm == 1);
    BOOST_CHECK(!in_sheet.parallax);
    BOOST_TEST(in_sheet.relief.depth == 1);
    BOOST_TEST(in_sheet.pseudoscopic);
}

BOOST_AUTO_TEST_CASE(each_bad_value_is_refused_by_name)
{
    const struct {
        const char *old_text, *new_text, *named;
    } cases[] = {
        {R"("hexagonal")", R"("round")",
         "sheet.arrangement must be lenticular, square or hexagonal"},
        {R"("hexagonal")", "3", "sheet.arrangement must be a string"},
        {R"("pitch_mm": 1.5)", R"("pitch": 1.5)", "sheet.pitch_mm is missing"},
        {"1.5", "\"1.5\"", "sheet.pitch_mm must be a number"},
        {"1.5", "0", "pitch"},
        {"1.5", "-1.5", "sheet.pitch_mm"},
        {"1.5", "1e9", "pitch"},
        {"1.5", "null", "sheet.pitch_mm"},
        {"1.5", "true", "sheet.pitch_mm"},
        {"3.25", "0", "thickness"},
        {"3.25", "1e300", "sheet.thickness_mm"},
        {"1.6,", "0.9,", "ior"},
        {"1.6,", "5,", "ior"},
        {"-12.5", "90.01", "slant"},
        {"-12.5", "-91", "slant"},
        {"[0.25, -0.5]", "[0.25]", "sheet.offset_mm must be a list of 2 numbers"},
        {"[0.25, -0.5]", "[0.25, null]", "sheet.offset_mm[1]"},
        {"[0.25, -0.5]", "0", "sheet.offset_mm"},
        {"640", "0", "film.width"},
        {"640", "-1", "film.width"},
        {"640", "640.5", "film.width must be a whole number"},
        {"640", "1e3", "film.width must be a whole number"},
        {"640", "99999999999999999999", "film.width"},
        {"480", "1000001", "film.height"},
        {R"("height": 480, )", "", "film.height is missing"},
        {"[0.1, 0.2]", "[0, 0.2]", "pixel pitch"},
        {"[0.1, 0.2]", "[0.1, 0.2, 0.3]", "film.pixel_pitch_mm"},
        {R"("distance_mm": 300)", R"("distance_mm": 0)", "aperture.distance_mm"},
        {R"("distance_mm": 300)", R"("distance_mm": 1e10)", "aperture.distance_mm"},
        {R"("distance_mm": 300, )", "", "aperture.distance_mm is missing"},
        {R"("height_mm": 40)", R"("height_mm": -1)", "aperture.height_mm"},
        {"\"ellipse\"", "\"star\"", "aperture.shape must be rectangle or ellipse"},
        {"[1, 2, 3]", "[1, 2]", "camera.origin"},
        {"[1, 2, 3]", "[1, 2, \"3\"]", "camera.origin[2]"},
        {R"("units_per_mm": 0.5)", R"("units_per_mm": 0)", "camera.units_per_mm"},
        {"\"power\"", "\"log\"", "encoding.kind must be linear, srgb or power"},
        {"1.8", "0", "encoding.gamma"},
        {"\"accurate\"", "\"best\"",
         "render.mapping must be auto, closest, accurate or exhaustive"},
        {"\"s.pov\"", "7", "render.scene must be a string"},
        {"\"seconds\": 7", "\"seconds\": -7", "render.seconds"},
        {"0.01", "\"small\"", "render.error.rms"},
        {"\"audit\"", "\"guess\"", "render.error.method must be audit or split halves"},
        {"19200", "-1", "render.error.lit_pixels"},
        {"\"full\"", "\"thin\"", "render.model must be extended_pinhole, pinhole, hybrid or full"},
        {"\"beam_samples\": 16", "\"beam_samples\": 0", "render.beam_samples"},
        {"true", "1", "render.pseudoscopic must be true or false"},
        {"\"bgr\"", "\"brg\"", "film.subpixels must be rgb, bgr, vrgb, vbgr, cells or none"},
        {"\"bgr\"", "\"cells\"", "film.subpixels must be an object of pattern and cells"},
        {"\"bgr\"", "{\"cells\": []}", "film.subpixels.pattern is missing"},
        {"\"bgr\"", "{\"pattern\": \"rows\", \"cells\": []}",
         "film.subpixels.cells must be a list of 1 to 4 cells"},
        {"\"bgr\"", "{\"pattern\": \"row\", \"cells\": []}",
         "film.subpixels.pattern must be same, checkerboard, columns, rows or staggered"},
        {"\"bgr\"", "{\"pattern\": \"rows\", \"cells\": [[[0,0],[0,0]]]}",
         "film.subpixels.cells[0] must be a list of three places"},
        {"\"bgr\"", "{\"pattern\": \"rows\", \"cells\": [[[0,0],[0,0],[0,1.5]]]}",
         "film.subpixels.cells[0][2][1] is 1.5"},
        {"\"sheet\"", "\"sheets\"", "sheet is missing"},
        {"\"film\": {", "\"film\": 3, \"fil\": {", "film must be an object"},
        {"1.5", "1e999", "out of range"},
        {"1.5", "NaN", "no JSON"},
        {"{", "", "no JSON"},
    };
    for (const auto& c : cases) {
        const std::string message = refusal(with(c.old_text, c.new_text));
        BOOST_TEST(message.find(c.named) != std::string::npos,
                   c.old_text << " -> " << c.new_text << ": " << message);
        BOOST_TEST(message.find('\n') == std::string::npos);
    }
    for (const char* text : {"", "[]", "3", "\"sheet\"", "null", "{}", "\xff\xfe", "{\"sheet\":"})
        BOOST_TEST(!refusal(text).empty(), text);
}

BOOST_AUTO_TEST_CASE(every_truncation_and_flipped_bit_is_refused_or_read)
{
    const std::string text = complete;
    for (std::size_t n = 0; n < text.size(); ++n)
        BOOST_TEST(!refusal(text.substr(0, n)).empty(), n);
    std::mt19937 random(2);
    for (int i = 0; i < 20000; ++i) {
        std::string flipped = text;
        flipped[random() % text.size()] ^= char(1 << random() % 8);
        refusal(flipped); // must neither crash nor throw anything else
    }
    refusal(std::string(100000, '['));
}

BOOST_AUTO_TEST_CASE(geometry_must_fit_the_image)
{
    Frame frame;
    frame.image = make_image<std::uint8_t>(640, 480, 3, Encoding{Encoding::Kind::linear, 1});
    FrameMetadata metadata = frame_metadata_from_json(complete);
    set_metadata(frame, metadata);
    BOOST_CHECK(frame.metadata->encoding.kind == Encoding::Kind::linear);
    metadata.film.width = metadata.film.height = 0;
    set_metadata(frame, metadata);
    BOOST_TEST(frame.metadata->film.width == 640);
    BOOST_TEST(frame.metadata->film.height == 480);
    metadata.film.width = 641;
    metadata.film.height = 480;
    BOOST_CHECK_THROW(set_metadata(frame, metadata), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(names_read_back)
{
    for (const auto kind : {LensMapping::automatic, LensMapping::closest, LensMapping::accurate,
                            LensMapping::exhaustive})
        BOOST_CHECK(kind_named<LensMapping>(name_of(kind)) == kind);
    BOOST_CHECK(!kind_named<LensMapping>("automatic"));
    BOOST_CHECK(!kind_named<Arrangement>("Lenticular"));
}

BOOST_AUTO_TEST_SUITE_END()
