// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests frames rendered in strips of rows: where they are cut, which rows around a strip are
// needed, and the merged frame.
#include "integral/base/file_bytes.h"
#include "integral/batch/strips.h"
#include "integral/io/codecs.h"
#include "integral/reconstruction/light_field_image.h"
#include "tests/unit/pixel_origins.h"

#include <cstdlib>
#include <filesystem>
#include <random>

using namespace pixel_origins;

namespace {

/// A temporary folder, removed by the destructor.
struct Folder {
    Folder()
    {
        const char* place = std::getenv("TMPDIR");
        path = std::string(place && *place ? place : "/tmp") + "/integral-strips.XXXXXX";
        BOOST_REQUIRE(mkdtemp(path.data()));
    }
    ~Folder() { std::filesystem::remove_all(path); }
    std::string operator/(const std::string& name) const { return path + "/" + name; }
    std::string path;
};

FrameMetadata metadata_of(int width, int height, double seconds)
{
    FrameMetadata metadata;
    metadata.film.width = width;
    metadata.film.height = height;
    metadata.film.pixel_pitch = {25.4 / 300, 25.4 / 300};
    metadata.aperture.distance = 300;
    metadata.aperture.width = metadata.aperture.height = 100;
    metadata.render = RenderRecord();
    metadata.render->program = "a test";
    metadata.render->scene = "scene.pov";
    metadata.render->seconds = seconds;
    return metadata;
}

/// A picture of noise.
template <class Sample> DecodedImage noise(int width, int height, int channels)
{
    DecodedImage picture;
    picture.image = make_image<Sample>(
        width, height, channels,
        std::is_same<Sample, float>::value ? Encoding{Encoding::Kind::linear, 1} : Encoding{});
    std::mt19937 random(7);
    for (Sample& sample : std::get<std::vector<Sample>>(picture.image.samples))
        sample = std::is_same<Sample, float>::value ? Sample(random() * 0x1p-31f)
                                                    : Sample(random());
    picture.image.premultiplied = std::is_same<Sample, float>::value;
    picture.pixel_pitch = Vec2{25.4 / 300, 25.4 / 300};
    FrameMetadata metadata = metadata_of(width, height, 1);
    metadata.encoding = picture.image.encoding;
    picture.document = to_json(metadata);
    return picture;
}

std::string encoded(const DecodedImage& picture)
{
    return picture.image.samples.index() == 2 ? encode_exr(picture) : encode_png(picture);
}

/// Cuts the frame into strips as the renderer writes them: black except for their own rows, and
/// each rendered in `seconds`. Returns the strips' files.
template <class Sample>
std::vector<std::string> cut(const Folder& folder, const DecodedImage& frame,
                             const std::vector<RowStrip>& strips)
{
    std::vector<std::string> files;
    for (const RowStrip& strip : strips) {
        DecodedImage part = frame;
        auto& samples = std::get<std::vector<Sample>>(part.image.samples);
        const std::size_t row = std::size_t(frame.image.width) * frame.image.channels;
        std::fill_n(samples.begin(), row * (strip.first - strip.above), Sample(0));
        std::fill(samples.begin() + row * (strip.first + strip.rows + strip.below), samples.end(),
                  Sample(0));
        write_file(folder / "rendered", encoded(part));
        files.push_back(folder / ("strip-" + std::to_string(files.size())));
        cut_strip(folder / "rendered", strip, files.back());
    }
    return files;
}

template <class Sample> void is_whole_again(int width, int height, int channels, int number)
{
    const Folder folder;
    const DecodedImage frame = noise<Sample>(width, height, channels);
    const auto strips = row_strips(height, number, 32, 15);
    const auto files = cut<Sample>(folder, frame, strips);
    merge_strips(files, folder / "whole");
    const std::string bytes = read_file(folder / "whole");
    const DecodedImage whole = std::is_same<Sample, float>::value ? decode_exr(bytes)
                                                                  : decode_png(bytes);
    BOOST_TEST(whole.image.height == height);
    BOOST_TEST((whole.image.samples == frame.image.samples));
    FrameMetadata requested = frame_metadata_from_json(frame.document);
    requested.render->seconds = double(strips.size());
    BOOST_TEST(whole.document == to_json(requested));
    BOOST_TEST(whole.pixel_pitch->x ==
                   (std::is_same<Sample, float>::value ? 25.4 / float(300) : 1000. / 11811),
               boost::test_tools::tolerance(1e-6));
}

/// The message of the InputError that merging these files throws; empty if it throws none.
std::string refusal(const std::vector<std::string>& files, const std::string& output)
{
    try {
        merge_strips(files, output);
    } catch (const InputError& error) {
        BOOST_TEST(!std::filesystem::exists(output));
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

BOOST_AUTO_TEST_SUITE(batch_strips)

BOOST_AUTO_TEST_CASE(strips_hold_every_row_once)
{
    for (int height = 1; height < 700; height += 13)
        for (const int side : {1, 8, 32})
            for (int number = 1; number < 50; number += 4)
                for (const int reach : {0, 1, 15, 40}) {
                    int next = 0, least = height, most = 0;
                    for (const RowStrip& strip : row_strips(height, number, side, reach)) {
                        BOOST_REQUIRE(strip.first == next);
                        BOOST_REQUIRE(strip.rows > 0);
                        BOOST_REQUIRE(strip.first % side == 0);
                        BOOST_REQUIRE((strip.first - strip.above) % side == 0); // frame's blocks
                        BOOST_REQUIRE(strip.above >= std::min(strip.first, reach));
                        next = strip.first + strip.rows;
                        BOOST_REQUIRE(strip.below >= std::min(height - next, reach));
                        BOOST_REQUIRE(next + strip.below <= height);
                        least = std::min(least, next == height ? least : strip.rows);
                        most = std::max(most, strip.rows);
                    }
                    BOOST_REQUIRE(next == height);
                    BOOST_REQUIRE(most <= least + side);
                }
}

BOOST_AUTO_TEST_CASE(options_name_rows_from_one)
{
    BOOST_TEST(options_of({0, 64, 0, 15}, 100) ==
                   (std::vector<std::string>{"End_Row=79", "Integral_Rows=1,64"}),
               boost::test_tools::per_element());
    BOOST_TEST(options_of({64, 36, 32, 0}, 100) ==
                   (std::vector<std::string>{"Start_Row=33", "Integral_Rows=65,100"}),
               boost::test_tools::per_element());
    BOOST_TEST(options_of({32, 32, 0, 0}, 100) ==
                   (std::vector<std::string>{"Start_Row=33", "End_Row=64"}),
               boost::test_tools::per_element());
    BOOST_TEST(options_of({0, 100, 0, 0}, 100).empty());
}

BOOST_AUTO_TEST_CASE(anti_aliasing_looks_no_further)
{
    // The margin must equal the distance in rows of the farthest neighbour that anti-aliasing
    // visits.
    std::mt19937 random(3);
    for (int round = 0; round < 60; ++round) {
        CameraParameters p = parameters_of(arrangements[round % 3]);
        p.sheet.pitch = 0.5 + (random() % 100) / 50.0;
        p.sheet.slant = int(random() % 181) - 90;
        p.film.pixel_pitch = {25.4 / 300, 25.4 / (150 + random() % 300)};
        p.mapping = LensMapping::closest;
        p.capture_aperture = Vec2{1e4, 1e4};
        const IntegralCamera camera = camera_of(p, 90, 110);
        LightFieldImage samples(camera);
        for (int y = 0; y < 110; ++y)
            for (int x = 0; x < 90; ++x)
                if (const auto ray = camera.optics
                                         .map(film_from_pixel(camera.film, {x + 0.5, y + 0.5}),
                                              p.mapping)
                                         .ray)
                    samples.set(x, y, {}, ray->lens, 0);
        int furthest = 0;
        for (int y = 0; y < 110; ++y)
            for (int x = 0; x < 90; ++x)
                samples.for_each_neighbour(
                    x, y, [&](int, int j) { furthest = std::max(furthest, std::abs(j - y)); });
        BOOST_TEST(furthest == refine_margin_rows(p.sheet, camera.film),
                   int(p.sheet.arrangement) << " " << p.sheet.pitch << " " << p.sheet.slant);
    }
}

BOOST_AUTO_TEST_CASE(merged_strips_are_the_frame)
{
    is_whole_again<std::uint8_t>(37, 200, 3, 4);
    is_whole_again<std::uint8_t>(37, 97, 4, 3);
    is_whole_again<std::uint16_t>(20, 129, 3, 100);
    is_whole_again<std::uint16_t>(20, 64, 4, 1);
    is_whole_again<float>(33, 150, 3, 3);
    is_whole_again<float>(33, 150, 4, 5);
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_named)
{
    const Folder folder;
    const DecodedImage frame = noise<std::uint8_t>(20, 160, 3);
    auto files = cut<std::uint8_t>(folder, frame, row_strips(160, 5, 32, 4));
    const std::string output = folder / "whole";
    BOOST_TEST(has(refusal({files[0], files[2]}, output),
                   "strip-2: it begins at row 65 where row 33 is wanted"));
    BOOST_TEST(has(refusal({files[0], files[1]}, output), "strip-1: it ends at row 64 of 160"));
    BOOST_TEST(
        has(refusal({files[0], files[1], folder / "none"}, output), "none: this strip is missing"));
    BOOST_TEST(
        has(refusal({files[0], files[0]}, output), "strip-0: it begins at row 1 where row 33"));
    write_file(folder / "frame", encode_png(frame));
    BOOST_TEST(has(refusal({folder / "frame"}, output), "frame: it does not say which rows"));
    const std::string bytes = read_file(files[3]);
    write_file(files[3], bytes.substr(0, bytes.size() / 2));
    BOOST_TEST(has(refusal(files, output), "strip-3: it cannot be read"));

    // Strips of a frame with another sheet.
    DecodedImage other = frame;
    FrameMetadata metadata = frame_metadata_from_json(frame.document);
    metadata.sheet.pitch = 1;
    other.document = to_json(metadata);
    write_file(folder / "rendered", encode_png(other));
    cut_strip(folder / "rendered", row_strips(160, 5, 32, 4)[3], files[3]);
    BOOST_TEST(has(refusal(files, output), "strip-3: it is a strip of another frame"));
    write_file(folder / "rendered", encode_png(noise<std::uint8_t>(20, 96, 3)));
    BOOST_CHECK_THROW(cut_strip(folder / "rendered", row_strips(160, 5, 32, 4)[3], files[3]),
                      InputError);
}

BOOST_AUTO_TEST_CASE(errors_of_strips_are_the_frames)
{
    // Two halves of equal weight, one of them without error. Each interval reaches at least a tenth
    // of the mean square to either side.
    ErrorEstimate good, bad;
    good.method = bad.method = ErrorMethod::split_halves;
    good.pixels = good.lit_pixels = bad.pixels = bad.lit_pixels = 100;
    bad.rms = 0.02;
    bad.low = 0.018;
    bad.high = 0.023;
    const ErrorEstimate both = combined({good, bad});
    BOOST_TEST(both.rms == 0.02 / std::sqrt(2), boost::test_tools::tolerance(1e-12));
    BOOST_TEST(both.pixels == 200);
    BOOST_TEST(both.lit_pixels == 200);
    BOOST_TEST(both.low == 0.018 / std::sqrt(2), boost::test_tools::tolerance(1e-12));
    BOOST_TEST(both.high == 0.023 / std::sqrt(2), boost::test_tools::tolerance(1e-12));
    // Many equal estimates have a smaller interval than each, but the same bias.
    const ErrorEstimate many = combined(std::vector<ErrorEstimate>(400, bad));
    BOOST_TEST(many.rms == bad.rms, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(many.low > bad.low);
    BOOST_TEST(many.high < bad.high);
    BOOST_TEST(many.high * many.high == 1.1 * many.rms * many.rms,
               boost::test_tools::tolerance(1e-9));
    // Compares with sums over all pixels.
    std::mt19937 random(1);
    ErrorSums all;
    std::vector<ErrorEstimate> strips;
    for (int k = 0; k < 8; ++k) {
        ErrorSums sums;
        for (int i = 0; i < 500; ++i)
            sums.add((random() % 1000) * 1e-6 * (k + 1));
        all.add(sums);
        strips.push_back(*estimate(sums, ErrorMethod::audit));
        strips.back().lit_pixels = sums.pixels;
    }
    const auto whole = *estimate(all, ErrorMethod::audit);
    const auto merged = combined(strips);
    BOOST_TEST(merged.rms == whole.rms, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(merged.low == whole.low, boost::test_tools::tolerance(0.02));
    BOOST_TEST(merged.high == whole.high, boost::test_tools::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(words_of_randomness_are_found_where_they_count)
{
    const Folder folder;
    const std::string a = folder / "a.pov", b = folder / "b.inc", c = folder / "c.png";
    write_file(a, "// radiosity\n/* media /* jitter */ photons */ #include \"b.inc\"\n#declare "
                  "radiosity_on = 1; text { \"crand \\\" media\" }\n");
    write_file(b, "sphere { 0, 1 }\n");
    write_file(c, "photons\n");
    BOOST_TEST(words_of_randomness({a, b, c}).empty());
    write_file(b,
               "global_settings { radiosity { } }\nlight_source { 0 1 area_light x,y,2,2 jitter }");
    BOOST_TEST(words_of_randomness({a, b, c}) == (std::vector<std::string>{"radiosity", "jitter"}),
               boost::test_tools::per_element());
    BOOST_CHECK_THROW(words_of_randomness({folder / "none.pov"}), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
