// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests that pictures of other programs are read as viewers show them: upright, in the window and
// the colours that the file describes, with its resolution. Expected values are written out here or
// follow from the formats' definitions.
#include "integral/base/notices.h"
#include "integral/io/codecs.h"
#include "integral/io/image_file.h"
#include "tests/unit/picture_files.h"

#include <boost/test/unit_test.hpp>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <lcms2.h>
#include <tiffio.h>
#include <zlib.h>

using namespace picture_files;
using namespace std::string_literals;

BOOST_AUTO_TEST_SUITE(io_as_shown)

namespace {

std::string u16(unsigned v) { return {char(v >> 8), char(v)}; }
std::string u32(unsigned v) { return u16(v >> 16) + u16(v & 0xffff); }

/// Exif with an orientation and, if `pixels` > 0, that many pixels per unit (2: inch, 3: cm).
std::string exif(unsigned orientation, unsigned pixels = 0, unsigned unit = 2)
{
    const std::string text = "MM\0\x2a"s + u32(8) + u16(4) + u16(0x112) + u16(3) + u32(1) +
                             u16(orientation) + u16(0) + u16(0x11a) + u16(5) + u32(1) + u32(62) +
                             u16(0x11b) + u16(5) + u32(1) + u32(62) + u16(0x128) + u16(3) + u32(1) +
                             u16(unit) + u16(0) + u32(0);
    return text + u32(pixels) + u32(1);
}

/// A JPEG with another segment after its first two bytes.
std::string with_segment(const std::string& jpeg, char marker, const std::string& data)
{
    return jpeg.substr(0, 2) + "\xff"s + marker + u16(unsigned(data.size() + 2)) + data +
           jpeg.substr(2);
}

/// A PNG with another chunk before one of these types.
std::string with_chunk(const std::string& png, const std::string& type_and_data,
                       const char* before = "IDAT")
{
    const auto place = png.find(before) - 4;
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(type_and_data.data()),
                           uInt(type_and_data.size()));
    return png.substr(0, place) + u32(unsigned(type_and_data.size() - 4)) + type_and_data +
           u32(unsigned(sum)) + png.substr(place);
}

DecodedImage shown(const std::string& bytes)
{
    const InputFile file = InputFile::of_bytes(bytes);
    return whole_picture(*read_any(file));
}

/// The pixels of a grey picture as letters, a slash after each row but the last.
std::string letters(const Image& image)
{
    std::string text;
    for (int y = 0; y < image.height; ++y) {
        text += y == 0 ? "" : "/";
        for (int x = 0; x < image.width; ++x)
            text += char(std::lround(255 * stored_pixel(image, x, y).g));
    }
    return text;
}

Image abcdef()
{
    Image image = make_image<std::uint8_t>(3, 2, 3, Encoding());
    for (int i = 0; i < 6; ++i)
        for (int c = 0; c < 3; ++c)
            row_bytes(image, 0)[3 * i + c] = (unsigned char)("abcdef"[i]);
    return image;
}

/// An ICC profile of RGB with these primaries and this gamma.
std::string profile_of(const cmsCIExyYTRIPLE& primaries, double gamma)
{
    const cmsCIExyY white{0.3127, 0.3290, 1};
    cmsToneCurve* curve = cmsBuildGamma(nullptr, gamma);
    cmsToneCurve* curves[] = {curve, curve, curve};
    void* profile = cmsCreateRGBProfile(&white, &primaries, curves);
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile, nullptr, &size);
    std::string bytes(size, '\0');
    cmsSaveProfileToMem(profile, &bytes[0], &size);
    cmsCloseProfile(profile);
    cmsFreeToneCurve(curve);
    return bytes;
}

const cmsCIExyYTRIPLE srgb_primaries{{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
const cmsCIExyYTRIPLE adobe_primaries{{0.64, 0.33, 1}, {0.21, 0.71, 1}, {0.15, 0.06, 1}};

/// Adobe RGB (1998) in sRGB, by the matrix between the two: (128, 160, 96) for one colour.
Colour adobe_in_srgb(Colour adobe)
{
    const double power = 563.0 / 256, r = std::pow(adobe.r, power), g = std::pow(adobe.g, power),
                 b = std::pow(adobe.b, power);
    const auto e = [](double v) { return float(encode(Encoding(), v)); };
    return {e(1.398353 * r - 0.398353 * g), e(g), e(-0.042930 * g + 1.042930 * b), 1};
}

void check_close(Colour a, Colour b, double tolerance)
{
    BOOST_TEST(std::fabs(a.r - b.r) <= tolerance, a.r << " red, not " << b.r);
    BOOST_TEST(std::fabs(a.g - b.g) <= tolerance, a.g << " green, not " << b.g);
    BOOST_TEST(std::fabs(a.b - b.b) <= tolerance, a.b << " blue, not " << b.b);
}

/// An EXR of floats 1, 2, 3, ... row by row in each channel, in these windows.
std::string exr_in_windows(const Imath::Box2i& display, const Imath::Box2i& data,
                           const std::vector<std::string>& channels)
{
    const Folder folder;
    const int width = data.max.x - data.min.x + 1, height = data.max.y - data.min.y + 1;
    std::vector<float> values(std::size_t(width * height));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = float(i + 1);
    Imf::Header header(display, data);
    Imf::FrameBuffer source;
    for (const std::string& name : channels) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        source.insert(name,
                      Imf::Slice::Make(Imf::FLOAT, values.data(), data, 4, 4 * std::size_t(width)));
    }
    {
        Imf::OutputFile file((folder / "a.exr").c_str(), header);
        file.setFrameBuffer(source);
        file.writePixels(height);
    }
    return bytes_of(folder / "a.exr");
}

/// The red samples of all pixels, read `rows` rows at a time.
std::vector<float> reds_in_bands(const std::string& bytes, int rows)
{
    const InputFile file = InputFile::of_bytes(bytes);
    const auto reader = read_any(file);
    const Image form = reader->head().image;
    std::vector<float> reds;
    for (int y = 0; y < form.height; y += rows) {
        Image band = blank_like(form, form.width, std::min(rows, form.height - y));
        reader->read(band);
        for (int k = 0; k < band.height; ++k)
            for (int x = 0; x < band.width; ++x)
                reds.push_back(stored_pixel(band, x, k).r);
    }
    return reds;
}

} // namespace

BOOST_AUTO_TEST_CASE(pictures_are_turned_upright)
{
    const char* requested[] = {"abc/def",  "cba/fed",  "fed/cba",  "def/abc",
                               "ad/be/cf", "da/eb/fc", "fc/eb/da", "cf/be/ad"};
    const Folder folder;
    for (unsigned orientation = 1; orientation <= 8; ++orientation)
        BOOST_TEST_CONTEXT("orientation " << orientation)
        {
            const std::string path = folder / "a.tif";
            write_bytes(path, encode_tiff({abcdef(), "", Vec2{0.1, 0.2}}));
            TIFF* tiff = TIFFOpen(path.c_str(), "r+");
            TIFFSetField(tiff, TIFFTAG_ORIENTATION, orientation);
            TIFFRewriteDirectory(tiff);
            TIFFClose(tiff);
            const DecodedImage tiff_shown = shown(bytes_of(path));
            BOOST_TEST(letters(tiff_shown.image) == requested[orientation - 1]);
            BOOST_TEST(tiff_shown.pixel_pitch->x == (orientation < 5 ? 0.1 : 0.2),
                       boost::test_tools::tolerance(1e-6));
            BOOST_TEST(reds_in_bands(bytes_of(path), 1) == reds_in_bands(bytes_of(path), 3),
                       boost::test_tools::per_element());

            const std::string png = encode_png({abcdef(), "", {}}),
                              chunk = "eXIf" + exif(orientation);
            for (const char* before : {"IDAT", "IEND"})
                BOOST_TEST(letters(shown(with_chunk(png, chunk, before)).image) ==
                           requested[orientation - 1]);
        }
}

BOOST_AUTO_TEST_CASE(photographs_are_turned_upright)
{
    Image image = make_image<std::uint8_t>(32, 16, 3, Encoding());
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x)
            store_pixel(image, x, y, x < 16 ? Colour{1, 1, 1, 1} : Colour{0, 0, 0, 1});
    const std::string jpeg = encode_jpeg(image, 95);
    const DecodedImage turned = shown(with_segment(jpeg, '\xe1', "Exif\0\0"s + exif(6)));
    BOOST_TEST(turned.image.width == 16);
    BOOST_TEST(turned.image.height == 32);
    BOOST_TEST(stored_pixel(turned.image, 8, 4).g > 0.9); // its left is on top
    BOOST_TEST(stored_pixel(turned.image, 8, 28).g < 0.1);
    // Truncated Exif counts as far as it can be read; an invalid orientation counts as upright.
    BOOST_TEST(shown(with_segment(jpeg, '\xe1', "Exif\0\0"s + exif(6).substr(0, 30))).image.width ==
               16);
    BOOST_TEST(shown(with_segment(jpeg, '\xe1', "Exif\0\0"s + exif(77))).image.width == 32);
    BOOST_TEST(shown(with_segment(jpeg, '\xe1', "Exif\0\0"s)).image.width == 32);
}

BOOST_AUTO_TEST_CASE(jpegs_say_their_resolution)
{
    const std::string jpeg = encode_jpeg(abcdef(), 90);
    const auto pitch = [&](char marker, const std::string& data) {
        return shown(with_segment(jpeg, marker, data)).pixel_pitch;
    };
    const auto jfif = [](char unit, unsigned x, unsigned y) {
        return "JFIF\0\1\1"s + unit + u16(x) + u16(y) + "\0\0"s;
    };
    BOOST_TEST(!shown(jpeg).pixel_pitch.has_value());
    BOOST_TEST(!pitch('\xe0', jfif(0, 300, 300)).has_value()); // only an aspect ratio
    BOOST_TEST(pitch('\xe0', jfif(1, 300, 600))->x == 25.4 / 300);
    BOOST_TEST(pitch('\xe0', jfif(1, 300, 600))->y == 25.4 / 600);
    BOOST_TEST(pitch('\xe0', jfif(2, 100, 100))->x == 0.1);
    BOOST_TEST(pitch('\xe1', "Exif\0\0"s + exif(1, 300))->y == 25.4 / 300);
    BOOST_TEST(pitch('\xe1', "Exif\0\0"s + exif(1, 100, 3))->y == 0.1);
}

BOOST_AUTO_TEST_CASE(embedded_profiles_are_converted)
{
    const std::string adobe = profile_of(adobe_primaries, 563.0 / 256);
    const std::vector<Colour> colours = {
        {0.5f, 0.6f, 0.4f, 1}, {0.2f, 0.2f, 0.2f, 1}, {0.9f, 0.8f, 0.5f, 1}, {1, 1, 1, 1}};
    Image image = make_image<std::uint16_t>(4, 1, 3, Encoding());
    for (int x = 0; x < 4; ++x)
        store_pixel(image, x, 0, colours[std::size_t(x)]);
    const Image narrow = converted(image, 8, Encoding(), false);
    const std::string profiled_jpeg = with_segment(
        encode_jpeg(tiled({part_of(narrow, 0, 0, 1, 1)}, 1, 0), 100), '\xe2',
        "ICC_PROFILE\0\1\1"s + adobe);
    for (int x = 0; x < 4; ++x)
        BOOST_TEST_CONTEXT("colour " << x)
        {
            const Colour requested = adobe_in_srgb(colours[std::size_t(x)]);
            check_close(stored_pixel(shown(encode_png({image, "", {}, adobe})).image, x, 0),
                        requested, 0.002);
            check_close(stored_pixel(shown(encode_tiff({image, "", {}, adobe})).image, x, 0),
                        requested, 0.002);
            check_close(stored_pixel(shown(encode_png({narrow, "", {}, adobe})).image, x, 0),
                        requested, 0.006);
            if (x == 0)
                check_close(stored_pixel(shown(profiled_jpeg).image, x, 0), requested, 0.012);
        }
    const DecodedImage png = shown(encode_png({image, "", {}, adobe}));
    BOOST_CHECK(same_encoding(png.image.encoding, Encoding()));
    BOOST_TEST(png.profile == "");
    BOOST_TEST(png.colours_converted);
}

BOOST_AUTO_TEST_CASE(alpha_is_kept_beside_a_profile)
{
    Image image = make_image<std::uint8_t>(1, 1, 4, Encoding());
    store_pixel(image, 0, 0, {0.5f, 0.6f, 0.4f, 0.2f});
    const std::string adobe = profile_of(adobe_primaries, 563.0 / 256);
    const Colour got = stored_pixel(shown(encode_png({image, "", {}, adobe})).image, 0, 0);
    check_close(got, adobe_in_srgb({0.5f, 0.6f, 0.4f, 1}), 0.006);
    BOOST_TEST(got.a == 0.2f);
}

BOOST_AUTO_TEST_CASE(a_copy_of_srgb_changes_no_pixel)
{
    const std::string bytes = profile_of(srgb_primaries, 2.2);
    const Image image = noise<std::uint8_t>(9, 9, 3, Encoding());
    void* made = cmsCreate_sRGBProfile();
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(made, nullptr, &size);
    std::string srgb(size, '\0');
    cmsSaveProfileToMem(made, &srgb[0], &size);
    cmsCloseProfile(made);
    BOOST_CHECK(shown(encode_png({image, "", {}, srgb})).image.samples == image.samples);
    BOOST_CHECK(shown(encode_png({image, "", {}, bytes})).image.samples != image.samples);
}

BOOST_AUTO_TEST_CASE(a_profile_of_no_use_is_said)
{
    const Folder folder;
    std::vector<std::string> lines;
    receive_notices([&](const std::string& line) { lines.push_back(line); });
    const Image image = noise<std::uint8_t>(3, 3, 3, Encoding());
    write_bytes(folder / "a.tif", encode_tiff({image,
                                               "",
                                               {},
                                               "no profile at all, but long enough "
                                               "for its header to be looked at"}));
    BOOST_CHECK(read_frame(folder / "a.tif").image.samples == image.samples);
    read_frame(folder / "a.tif"); // no second notice
    receive_notices({});
    BOOST_REQUIRE(lines.size() == 1u);
    BOOST_TEST(lines[0] == folder / "a.tif" + ": its colour profile is not used: it is no ICC "
                                              "profile");
}

BOOST_AUTO_TEST_CASE(the_display_window_is_the_picture)
{
    using Box = Imath::Box2i;
    const Box display({10, 20}, {13, 22});
    const auto reds = [&](const Box& data) {
        const std::string bytes = exr_in_windows(display, data, {"R", "G", "B", "A"});
        BOOST_TEST(reds_in_bands(bytes, 1) == reds_in_bands(bytes, 3),
                   boost::test_tools::per_element());
        return reds_in_bands(bytes, 2);
    };
    const std::vector<float> inside = {0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 4, 0},
                             across = {5, 6, 0, 0, 8, 9, 0, 0, 0, 0, 0, 0}, beyond(12, 0.0f);
    BOOST_TEST(reds(Box({11, 21}, {12, 22})) == inside, boost::test_tools::per_element());
    BOOST_TEST(reds(Box({9, 19}, {11, 21})) == across, boost::test_tools::per_element());
    BOOST_TEST(reds(Box({0, 0}, {1, 1})) == beyond, boost::test_tools::per_element());
    const DecodedImage grey = shown(exr_in_windows(display, Box({11, 21}, {12, 22}), {"Y"}));
    BOOST_TEST(stored_pixel(grey.image, 2, 1).r == 2.0f);
    BOOST_TEST(stored_pixel(grey.image, 2, 1).b == 2.0f);
    BOOST_TEST(decode_exr_header(exr_in_windows(display, Box({11, 21}, {12, 22}), {"R"})).width ==
               4);
}

BOOST_AUTO_TEST_SUITE_END()
