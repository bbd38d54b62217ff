// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests JPEGs of other programs: CMYK, and what a decoder reads with warnings. Expected values are
// the stored ones, by the format's definition.
#include "integral/io/codecs.h"
#include "tests/unit/picture_bytes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstdio>

#include <jpeglib.h> // needs <cstdio> before it

using namespace picture_bytes;
using namespace picture_files;
using namespace std::string_literals;

BOOST_AUTO_TEST_SUITE(io_jpeg_forms)

namespace {

/// A JPEG of CMYK or its YCCK, all of one colour, inks stored inverted.
std::string inks_jpeg(J_COLOR_SPACE stored, const std::array<unsigned char, 4>& inks)
{
    jpeg_compress_struct codec;
    jpeg_error_mgr errors;
    codec.err = jpeg_std_error(&errors);
    jpeg_create_compress(&codec);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&codec, &bytes, &size);
    codec.image_width = codec.image_height = 16;
    codec.input_components = 4;
    codec.in_color_space = JCS_CMYK;
    jpeg_set_defaults(&codec);
    jpeg_set_colorspace(&codec, stored);
    jpeg_set_quality(&codec, 100, TRUE);
    jpeg_start_compress(&codec, TRUE);
    std::vector<unsigned char> row;
    for (int x = 0; x < 16; ++x)
        for (const unsigned char ink : inks)
            row.push_back((unsigned char)(255 - ink));
    for (int y = 0; y < 16; ++y) {
        unsigned char* rows[] = {row.data()};
        jpeg_write_scanlines(&codec, rows, 1);
    }
    jpeg_finish_compress(&codec);
    jpeg_destroy_compress(&codec);
    const std::string jpeg(reinterpret_cast<const char*>(bytes), size);
    std::free(bytes);
    return jpeg;
}

std::string noise_jpeg() { return encode_jpeg(noise<std::uint8_t>(64, 512, 3, Encoding()), 80); }

} // namespace

BOOST_AUTO_TEST_CASE(inks_of_jpegs)
{
    const std::array<unsigned char, 4> inks = {204, 51, 0, 102};
    for (const auto stored : {JCS_CMYK, JCS_YCCK}) {
        const std::string jpeg = inks_jpeg(stored, inks);
        const InputFile file = InputFile::of_bytes(jpeg);
        const Colour got = stored_pixel(whole_picture(*read_any(file)).image, 5, 5);
        BOOST_TEST(std::fabs(255 * got.r - 0.2 * 0.6 * 255) <= 2);
        BOOST_TEST(std::fabs(255 * got.g - 0.8 * 0.6 * 255) <= 2);
        BOOST_TEST(std::fabs(255 * got.b - 1.0 * 0.6 * 255) <= 2);
        BOOST_TEST(notices_of(jpeg).size() == 1u);
    }
}

BOOST_AUTO_TEST_CASE(jpegs_that_a_decoder_recovers)
{
    const std::string jpeg = noise_jpeg(), body = jpeg.substr(0, jpeg.size() - 2);
    const InputFile whole_file = InputFile::of_bytes(jpeg);
    const Image whole = whole_picture(*read_any(whole_file)).image;
    BOOST_TEST(notices_of(jpeg).empty());
    BOOST_TEST(notices_of(jpeg + "more bytes behind the end").empty());
    const std::string harmless[] = {body + "\1\2\3"s + "\xff\xd9", // before the end marker
                                    body,                          // without one
                                    jpeg.substr(0, 2) + "\0\0junk"s + jpeg.substr(2)};
    for (const std::string& bytes : harmless) {
        const InputFile file = InputFile::of_bytes(bytes);
        BOOST_CHECK(whole_picture(*read_any(file)).image.samples == whole.samples);
        BOOST_REQUIRE(notices_of(bytes).size() == 1u);
        BOOST_TEST(notices_of(bytes)[0].find("read all the same") != std::string::npos);
    }
    // First one of 64 rows of blocks is missing, then half of them.
    const std::string short_of_a_row = jpeg.substr(0, jpeg.size() - jpeg.size() / 64);
    BOOST_REQUIRE(notices_of(short_of_a_row).size() == 1u);
    BOOST_TEST(notices_of(short_of_a_row)[0].find("may be wrong") != std::string::npos);
    const std::string why = refusal(jpeg.substr(0, jpeg.size() / 2));
    BOOST_TEST(why.find("% of it is lost: Premature end") != std::string::npos, why);
}

BOOST_AUTO_TEST_SUITE_END()
