// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the forms in which other programs store TIFFs. Expected values are the stored ones, by the
// format's definition.
#include "integral/io/codecs.h"
#include "integral/io/image_file.h"
#include "tests/unit/picture_bytes.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstring>
#include <functional>
#include <tiffio.h>

using namespace picture_bytes;
using namespace picture_files;

BOOST_AUTO_TEST_SUITE(io_tiff_forms)

namespace {

constexpr int width = 37, height = 21; // not multiples of a tile or a byte

/// The storage form of a test's TIFF.
struct Form {
    int bits = 8, samples = 3, photometric = PHOTOMETRIC_RGB, planar = PLANARCONFIG_CONTIG,
        format = SAMPLEFORMAT_UINT, compression = COMPRESSION_ADOBE_DEFLATE, rows_a_strip = 4;
    bool tiled = false;
};

unsigned stored_sample(int x, int y, int sample, int bits)
{
    const unsigned value = unsigned(x * 2654435u + y * 40503u + sample * 97u + 11);
    return bits >= 16 ? value & 0xffff : value & ((1u << bits) - 1);
}

/// Appends the samples of pixels [x, x + count) of a row as the file packs them.
void pack(std::vector<unsigned char>& bytes, const Form& form, int x, int y, int count, int plane)
{
    unsigned held = 0;
    int have = 0;
    const bool apart = form.planar == PLANARCONFIG_SEPARATE;
    for (int k = x; k < x + count; ++k)
        for (int s = apart ? plane : 0; s < (apart ? plane + 1 : form.samples); ++s) {
            const unsigned value = stored_sample(k, y, s, form.bits);
            if (form.bits == 16) { // in the machine's order
                const auto whole = std::uint16_t(value);
                unsigned char two[2];
                std::memcpy(two, &whole, 2);
                bytes.insert(bytes.end(), two, two + 2);
                continue;
            }
            held = held << form.bits | value;
            for (have += form.bits; have >= 8; have -= 8)
                bytes.push_back((unsigned char)(held >> (have - 8)));
        }
    if (have > 0)
        bytes.push_back((unsigned char)(held << (8 - have)));
}

using SetTags = std::function<void(TIFF*)>;

std::string tiff_of(const Form& form, const SetTags& set_tags = {})
{
    const Folder folder;
    const std::string path = folder / "a.tif";
    TIFF* tiff = TIFFOpen(path.c_str(), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, form.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, form.samples);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, form.format);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, form.planar);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, form.photometric);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, form.compression);
    if (set_tags)
        set_tags(tiff);
    const int planes = form.planar == PLANARCONFIG_SEPARATE ? form.samples : 1;
    std::vector<unsigned char> bytes;
    if (form.tiled) {
        constexpr int side = 16;
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, side);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, side);
        for (int plane = 0; plane < planes; ++plane)
            for (int y = 0; y < height; y += side)
                for (int x = 0; x < width; x += side) {
                    bytes.clear();
                    for (int row = y; row < y + side; ++row)
                        pack(bytes, form, x, row, side, plane);
                    TIFFWriteTile(tiff, bytes.data(), std::uint32_t(x), std::uint32_t(y), 0,
                                  std::uint16_t(plane));
                }
    } else {
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, form.rows_a_strip);
        for (int plane = 0; plane < planes; ++plane)
            for (int y = 0; y < height; ++y) {
                bytes.clear();
                pack(bytes, form, 0, y, width, plane);
                TIFFWriteScanline(tiff, bytes.data(), std::uint32_t(y), std::uint16_t(plane));
            }
    }
    TIFFClose(tiff);
    return bytes_of(path);
}

using Expected = std::function<Colour(int x, int y)>;

/// Reads the TIFF whole and in bands and compares every pixel.
void check_tiff(const std::string& tiff, const Expected& expected, double tolerance = 1e-6)
{
    const InputFile file = InputFile::of_bytes(tiff);
    const Image whole = whole_picture(*read_any(file)).image;
    BOOST_REQUIRE(whole.width == width);
    BOOST_REQUIRE(whole.height == height);
    const auto reader = read_any(file);
    double worst = 0;
    for (int y = 0; y < height; y += 5) {
        Image band = blank_like(whole, width, std::min(5, height - y));
        reader->read(band);
        for (int k = 0; k < band.height; ++k)
            for (int x = 0; x < width; ++x) {
                const Colour requested = expected(x, y + k);
                for (const Colour got : {stored_pixel(band, x, k), stored_pixel(whole, x, y + k)})
                    for (const double off : {got.r - requested.r, got.g - requested.g,
                                             got.b - requested.b, got.a - requested.a})
                        worst = std::max(worst, std::fabs(off));
            }
    }
    BOOST_TEST(worst <= tolerance);
}

/// Grey or colours as they were stored, scaled so that their largest value is 1.
Expected plain(const Form& form)
{
    return [form](int x, int y) {
        const double most = (1u << form.bits) - 1;
        const auto at = [&](int s) { return float(stored_sample(x, y, s, form.bits) / most); };
        const bool grey = form.samples < 3;
        return Colour{at(0), at(grey ? 0 : 1), at(grey ? 0 : 2), 1};
    };
}

} // namespace

BOOST_AUTO_TEST_CASE(tiffs_of_every_depth_and_order)
{
    for (const bool tiled : {false, true})
        for (const int planar : {PLANARCONFIG_CONTIG, PLANARCONFIG_SEPARATE})
            for (const int bits : {1, 2, 4, 8, 12, 16})
                for (const int samples : {1, 3}) {
                    Form form;
                    form.tiled = tiled;
                    form.planar = planar;
                    form.bits = bits;
                    form.samples = samples;
                    form.photometric = samples == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB;
                    BOOST_TEST_CONTEXT((tiled ? "tiles, " : "strips, ")
                                       << bits << " bits, " << samples << " samples, planar "
                                       << planar)
                    {
                        check_tiff(tiff_of(form), plain(form), 0.51 / 65535);
                    }
                }
}

BOOST_AUTO_TEST_CASE(white_may_be_zero)
{
    for (const int bits : {1, 4, 8, 16}) {
        Form form;
        form.samples = 1;
        form.bits = bits;
        form.photometric = PHOTOMETRIC_MINISWHITE;
        check_tiff(tiff_of(form), [&](int x, int y) {
            const float v = 1 - plain(form)(x, y).r;
            return Colour{v, v, v, 1};
        });
    }
}

BOOST_AUTO_TEST_CASE(palettes_of_tiffs)
{
    for (const int bits : {1, 4, 8})
        for (const unsigned step : {257u, 1u, 251u}) { // 8 bits, 8 bits as old files have them, 16
            Form form;
            form.samples = 1;
            form.bits = bits;
            form.photometric = PHOTOMETRIC_PALETTE;
            std::vector<std::uint16_t> map[3];
            for (unsigned k = 0; k < 1u << bits; ++k)
                for (unsigned c = 0; c < 3; ++c)
                    map[c].push_back(std::uint16_t(step * ((k * 7 + c * 50 + 3) & 255)));
            const std::string tiff = tiff_of(form, [&](TIFF* file) {
                TIFFSetField(file, TIFFTAG_COLORMAP, map[0].data(), map[1].data(), map[2].data());
            });
            const double most = step == 1 ? 255 : 65535;
            BOOST_TEST_CONTEXT(bits << " bits, steps of " << step)
            {
                check_tiff(tiff, [&](int x, int y) {
                    const unsigned k = stored_sample(x, y, 0, bits);
                    return Colour{float(map[0][k] / most), float(map[1][k] / most),
                                  float(map[2][k] / most), 1};
                });
            }
        }
}

BOOST_AUTO_TEST_CASE(inks_of_tiffs)
{
    for (const bool tiled : {false, true})
        for (const int bits : {8, 16}) {
            Form form;
            form.samples = 4;
            form.bits = bits;
            form.tiled = tiled;
            form.photometric = PHOTOMETRIC_SEPARATED;
            const std::string tiff = tiff_of(form);
            check_tiff(
                tiff,
                [&](int x, int y) {
                    const double most = (1u << bits) - 1;
                    const auto light = [&](int s) {
                        return 1 - stored_sample(x, y, s, bits) / most;
                    };
                    return Colour{float(light(0) * light(3)), float(light(1) * light(3)),
                                  float(light(2) * light(3)), 1};
                },
                0.51 / ((1 << bits) - 1));
            BOOST_REQUIRE(notices_of(tiff).size() == 1u);
            BOOST_TEST(notices_of(tiff)[0].find("CMYK") != std::string::npos);
        }
}

BOOST_AUTO_TEST_CASE(alpha_of_tiffs)
{
    for (const bool multiplied : {false, true})
        for (const int bits : {8, 16}) {
            Form form;
            form.samples = 4;
            form.bits = bits;
            const std::string tiff = tiff_of(form, [&](TIFF* file) {
                const std::uint16_t kind = multiplied ? EXTRASAMPLE_ASSOCALPHA
                                                      : EXTRASAMPLE_UNASSALPHA;
                TIFFSetField(file, TIFFTAG_EXTRASAMPLES, 1, &kind);
            });
            const double most = (1u << bits) - 1;
            check_tiff(
                tiff,
                [&](int x, int y) {
                    const double a = stored_sample(x, y, 3, bits) / most;
                    const auto own = [&](int s) {
                        const double v = stored_sample(x, y, s, bits) / most;
                        return float(!multiplied ? v : a > 0 ? std::min(1.0, v / a) : 0);
                    };
                    return Colour{own(0), own(1), own(2), float(a)};
                },
                0.51 / most);
        }
}

BOOST_AUTO_TEST_CASE(halves_of_tiffs_are_floats)
{
    Form form;
    form.bits = 16;
    form.samples = 1;
    form.format = SAMPLEFORMAT_IEEEFP;
    form.photometric = PHOTOMETRIC_MINISBLACK;
    const std::string tiff = tiff_of(form);
    const InputFile file = InputFile::of_bytes(tiff);
    const Image image = whole_picture(*read_any(file)).image;
    BOOST_TEST(sample_bits(image) == 32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const unsigned bits = stored_sample(x, y, 0, 16), exponent = bits >> 10 & 31;
            if (exponent == 0 || exponent == 31)
                continue;
            const double size = std::ldexp(1 + (bits & 1023) / 1024.0, int(exponent) - 15);
            BOOST_TEST(stored_pixel(image, x, y).g == float(bits & 0x8000 ? -size : size));
        }
}

BOOST_AUTO_TEST_CASE(jpeg_inside_a_tiff)
{
    if (!TIFFIsCODECConfigured(COMPRESSION_JPEG))
        return;
    const Folder folder;
    const std::string path = folder / "a.tif";
    TIFF* tiff = TIFFOpen(path.c_str(), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 48);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 32);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_YCBCR);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_JPEG);
    TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    TIFFSetField(tiff, TIFFTAG_JPEGQUALITY, 100);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 16);
    std::vector<unsigned char> row;
    for (int x = 0; x < 48; ++x)
        row.insert(row.end(), {200, 100, 50});
    for (std::uint32_t y = 0; y < 32; ++y)
        TIFFWriteScanline(tiff, row.data(), y, 0);
    TIFFClose(tiff);
    const Image image = read_frame(path).image;
    for (const int x : {0, 20, 47}) {
        BOOST_TEST(std::fabs(255 * stored_pixel(image, x, 31).r - 200) <= 2);
        BOOST_TEST(std::fabs(255 * stored_pixel(image, x, 0).g - 100) <= 2);
        BOOST_TEST(std::fabs(255 * stored_pixel(image, x, 17).b - 50) <= 2);
    }
}

BOOST_AUTO_TEST_CASE(colour_differences_without_jpeg)
{
    Form form; // whole blocks of two rows: four lumas, Cb and Cr
    form.photometric = PHOTOMETRIC_YCBCR;
    form.compression = COMPRESSION_NONE;
    const Folder folder;
    const std::string path = folder / "a.tif";
    TIFF* tiff = TIFFOpen(path.c_str(), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 4);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 2);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_YCBCR);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 2);
    TIFFSetField(tiff, TIFFTAG_YCBCRSUBSAMPLING, 2, 2);
    const float range[] = {0, 255, 128, 255, 128, 255};
    TIFFSetField(tiff, TIFFTAG_REFERENCEBLACKWHITE, range);
    unsigned char blocks[] = {124, 124, 124, 124, 86, 182, 60, 60, 60, 60, 128, 128};
    TIFFWriteEncodedStrip(tiff, 0, blocks, sizeof blocks);
    TIFFClose(tiff);
    const Image image = read_frame(path).image;
    const Colour left = stored_pixel(image, 1, 1), right = stored_pixel(image, 2, 0);
    BOOST_TEST(std::fabs(255 * left.r - (124 + 1.402 * 54)) <= 2);
    BOOST_TEST(std::fabs(255 * left.g - (124 + 0.344 * 42 - 0.714 * 54)) <= 2);
    BOOST_TEST(std::fabs(255 * left.b - (124 - 1.772 * 42)) <= 2);
    BOOST_TEST(std::fabs(255 * right.g - 60) <= 1);
}

BOOST_AUTO_TEST_CASE(further_pages_of_a_tiff_are_said)
{
    const Folder folder;
    const std::string path = folder / "a.tif";
    TIFF* tiff = TIFFOpen(path.c_str(), "w");
    for (int page = 0; page < 3; ++page) {
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 1);
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, page == 2 ? FILETYPE_REDUCEDIMAGE : 0);
        unsigned char sample = (unsigned char)(100 + page);
        TIFFWriteScanline(tiff, &sample, 0, 0);
        TIFFWriteDirectory(tiff);
    }
    TIFFClose(tiff);
    const std::vector<std::string> requested = {"it holds 2 pictures; the first is read"};
    BOOST_TEST(notices_of(bytes_of(path)) == requested, boost::test_tools::per_element());
    BOOST_TEST(stored_pixel(read_frame(path).image, 0, 0).g == 100 / 255.0f);
}

BOOST_AUTO_TEST_CASE(tiffs_that_stay_refused)
{
    Form form;
    form.format = SAMPLEFORMAT_INT;
    BOOST_TEST(refusal(tiff_of(form)).find("samples") != std::string::npos);
    form = Form();
    form.samples = 1;
    BOOST_TEST(refusal(tiff_of(form)).find("samples a pixel") != std::string::npos);
    form = Form();
    form.tiled = true;
    const std::string tiff = tiff_of(form);
    BOOST_TEST(refusal(tiff) == "");
    for (std::size_t size = 0; size < tiff.size(); size += 7)
        BOOST_TEST(refusal(tiff.substr(0, size)) != "", "cut to " << size << " bytes");
}

BOOST_AUTO_TEST_SUITE_END()
