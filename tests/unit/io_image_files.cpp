// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests frames as files: round trips, and the refusal of invalid files.
#include "integral/io/codecs.h"
#include "integral/io/image_file.h"
#include "tests/unit/picture_files.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

using namespace picture_files;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(io_image_files)

namespace {

const Encoding srgb;

FrameMetadata geometry(int width, int height)
{
    FrameMetadata m;
    m.sheet.arrangement = Arrangement::hexagonal;
    m.sheet.slant = 12.3456789012345678;
    m.film = {width, height, {25.4 / 300, 25.4 / 600}};
    m.aperture = {300, 200, 100, ApertureShape::ellipse};
    m.render = RenderRecord{
        "program", "scene.pov", LensModel::hybrid, LensMapping::closest, 4, 16, false, true, 1, 1.5,
        {},        {},          Vec2{0.25, 0.5}};
    return m;
}

void check_same(const Image& a, const Image& b)
{
    BOOST_TEST(a.width == b.width);
    BOOST_TEST(a.height == b.height);
    BOOST_TEST(a.channels == b.channels);
    BOOST_CHECK(a.samples == b.samples);
    BOOST_CHECK(same_encoding(a.encoding, b.encoding));
}

/// The message with which a file is refused; "" if it is read.
std::string refusal(const std::string& path)
{
    try {
        read_frame(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(frames_read_back)
{
    const Folder folder;
    const Encoding power{Encoding::Kind::power, 1.8};
    std::vector<std::pair<std::string, Image>> pictures;
    for (const int channels : {3, 4}) {
        for (const Encoding e : {srgb, linear, power}) {
            for (const char* name : {"a.png", "a.tif"}) {
                pictures.push_back({name, noise<std::uint8_t>(37, 23, channels, e)});
                pictures.push_back({name, noise<std::uint16_t>(37, 23, channels, e)});
            }
        }
        pictures.push_back({"a.tiff", noise<float>(37, 23, channels, linear)});
        pictures.push_back({"a.exr", noise<float>(37, 23, channels, linear)});
        pictures.back().second.premultiplied = true;
        pictures.push_back({"a.PNG", noise<std::uint8_t>(1, 1, channels, srgb)});
        pictures.push_back({"a.TIFF", noise<std::uint16_t>(1, 70, channels, srgb)});
    }
    for (const auto& [name, image] : pictures) {
        BOOST_TEST_CONTEXT(name << " " << sample_bits(image) << " bits, " << image.channels
                                << " channels, encoding " << int(image.encoding.kind))
        {
            Frame frame{image, {}};
            set_metadata(frame, geometry(image.width, image.height));
            write_frame(folder / name, frame);
            const Frame read = read_frame(folder / name);
            check_same(read.image, image);
            BOOST_REQUIRE(read.metadata);
            BOOST_TEST(to_json(*read.metadata) == to_json(*frame.metadata));
        }
    }
}

BOOST_AUTO_TEST_CASE(formats_carry_resolution_and_encoding_without_the_document)
{
    // PNG stores the resolution as whole pixels per metre, EXR and TIFF as 32-bit floats.
    DecodedImage picture;
    picture.image = noise<std::uint8_t>(5, 4, 3, {Encoding::Kind::power, 2.2});
    picture.pixel_pitch = Vec2{25.4 / 300, 25.4 / 150};
    DecodedImage read = decode_png(encode_png(picture));
    BOOST_REQUIRE(read.pixel_pitch);
    BOOST_TEST(read.pixel_pitch->x == 1000.0 / 11811);
    BOOST_TEST(read.pixel_pitch->y == 1000.0 / 5906);
    BOOST_CHECK(read.image.encoding.kind == Encoding::Kind::power);
    BOOST_TEST(read.image.encoding.gamma == 2.2, boost::test_tools::tolerance(1e-4));
    BOOST_TEST(read.document.empty());

    read = decode_tiff(encode_tiff(picture));
    BOOST_REQUIRE(read.pixel_pitch);
    BOOST_TEST(read.pixel_pitch->x == 25.4 / 300, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(read.pixel_pitch->y == 25.4 / 150, boost::test_tools::tolerance(1e-6));

    picture.image = noise<float>(5, 4, 3, linear);
    picture.image.premultiplied = true;
    read = decode_exr(encode_exr(picture));
    BOOST_REQUIRE(read.pixel_pitch);
    BOOST_TEST(read.pixel_pitch->x == 25.4 / 300, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(read.pixel_pitch->y == 25.4 / 150, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(formats_convert_what_they_cannot_hold)
{
    const Folder folder;
    Image light = make_image<float>(1, 1, 4, linear);
    light.premultiplied = true;
    store_pixel(light, 0, 0, {0.25f, 0.5f, 0, 0.5f});
    write_frame(folder / "a.png", {light, {}}); // 16 bits, sRGB, alpha divided out
    const Image png = read_frame(folder / "a.png").image;
    BOOST_TEST(sample_bits(png) == 16);
    BOOST_CHECK(png.encoding.kind == Encoding::Kind::srgb);
    BOOST_TEST(stored_pixel(png, 0, 0).r == 0.7353570f, boost::test_tools::tolerance(2e-5f));
    BOOST_TEST(stored_pixel(png, 0, 0).g == 1);

    write_frame(folder / "a.exr", {png, {}}); // and back
    const Colour back = stored_pixel(read_frame(folder / "a.exr").image, 0, 0);
    BOOST_TEST(back.r == 0.25f, boost::test_tools::tolerance(1e-4f));
    BOOST_TEST(back.g == 0.5f, boost::test_tools::tolerance(1e-4f));
    BOOST_TEST(back.a == 0.5f, boost::test_tools::tolerance(1e-4f));

    Image dim = make_image<std::uint8_t>(1, 1, 3, linear); // a bare TIFF is assumed to be sRGB
    store_pixel(dim, 0, 0, {0.2f, 0.2f, 0.2f, 1});
    write_frame(folder / "a.tif", {dim, {}});
    BOOST_TEST(stored_pixel(read_frame(folder / "a.tif").image, 0, 0).r == 124 / 255.0f);
}

BOOST_AUTO_TEST_CASE(where_geometry_comes_from)
{
    const Folder folder;
    const Image image = noise<std::uint8_t>(8, 6, 3, srgb);
    write_frame(folder / "bare.png", {image, {}});
    BOOST_CHECK(!read_frame(folder / "bare.png").metadata);
    BOOST_CHECK_THROW(read_frame_with_metadata(folder / "bare.png"), InputError);

    FrameMetadata beside = geometry(8, 6);
    beside.sheet.pitch = 2;
    beside.encoding = linear;
    write_bytes(folder / "bare.json", to_json(beside));
    Frame frame = read_frame_with_metadata(folder / "bare.png");
    BOOST_TEST(frame.metadata->sheet.pitch == 2);
    BOOST_CHECK(frame.image.encoding.kind == Encoding::Kind::linear);

    beside.sheet.pitch = 3;
    write_bytes(folder / "bare.png.json", to_json(beside)); // the more exact name wins
    BOOST_TEST(read_frame(folder / "bare.png").metadata->sheet.pitch == 3);

    FrameMetadata own = geometry(8, 6);
    own.sheet.pitch = 4;
    frame.image = image;
    set_metadata(frame, own);
    write_frame(folder / "bare.png", frame);
    BOOST_TEST(read_frame(folder / "bare.png").metadata->sheet.pitch == 4);

    FrameMetadata given = geometry(0, 0);
    given.sheet.pitch = 5;
    given.encoding = linear;
    write_bytes(folder / "sheet.json", to_json(given));
    frame = read_frame(folder / "bare.png", folder / "sheet.json");
    BOOST_TEST(frame.metadata->sheet.pitch == 5);
    BOOST_TEST(frame.metadata->film.width == 8);
    // The picture's own encoding counts, not the document's.
    BOOST_CHECK(frame.image.encoding.kind == Encoding::Kind::srgb);
    BOOST_TEST(read_metadata(folder / "bare.png").sheet.pitch == 4);
    BOOST_TEST(read_metadata(folder / "sheet.json").sheet.pitch == 5);

    write_bytes(folder / "sheet.json", to_json(geometry(9, 6)));
    try {
        read_frame(folder / "bare.png", folder / "sheet.json");
        BOOST_ERROR("a sheet for another size was taken");
    } catch (const InputError& error) {
        BOOST_TEST(std::string(error.what()).find("9x6") != std::string::npos);
    }
}

BOOST_AUTO_TEST_CASE(malformed_files_are_refused_in_one_line)
{
    const Folder folder;
    const auto check = [&](const std::string& path, bool must_fail) {
        const std::string message = refusal(path);
        BOOST_TEST((!must_fail || !message.empty()));
        BOOST_TEST(message.find_first_of("\n\r") == std::string::npos, message);
        BOOST_TEST((message.empty() || message.compare(0, path.size() + 2, path + ": ") == 0),
                   message);
    };
    std::mt19937 random(3);
    const std::pair<const char*, DecodedImage (*)(const std::string&)> formats[] = {
        {"a.png", decode_png}, {"a.exr", decode_exr}, {"a.tif", decode_tiff}};
    for (const auto& [name, decode] : formats) {
        BOOST_TEST_CONTEXT(name)
        {
            Frame frame{noise<std::uint16_t>(40, 30, 3, srgb), {}};
            set_metadata(frame, geometry(40, 30));
            const std::string path = folder / name,
                              broken = folder / (std::string("broken-") + name);
            write_frame(path, frame);
            const std::string good = bytes_of(path);
            for (std::size_t n = 0; n + 16 < good.size(); n += 1 + n / 40) {
                write_bytes(broken, good.substr(0, n));
                check(broken, true);
            }
            for (int i = 0; i < 4000; ++i) {
                std::string bytes = good;
                for (int flips = 1 + int(random() % 3); flips > 0; --flips) {
                    // The first bytes hold the header: half of the flips go there.
                    const std::size_t range = random() % 2
                                                  ? std::min<std::size_t>(bytes.size(), 1000)
                                                  : bytes.size();
                    bytes[random() % range] ^= char(1 << random() % 8);
                }
                try {
                    decode(bytes);
                } catch (const std::exception& error) {
                    BOOST_TEST(error.what()[0] != '\0');
                }
            }
        }
    }
    write_bytes(folder / "text.png", "not a picture\n");
    check(folder / "text.png", true);
    check(folder / "missing.png", true);
    check(folder.path, true);
}

BOOST_AUTO_TEST_CASE(a_header_cannot_make_us_allocate)
{
    // A PNG of 100000 x 100000 pixels in 100 bytes: IHDR with its proper CRC, then nothing.
    std::string png = encode_png({noise<std::uint8_t>(1, 1, 3, srgb), "", {}});
    const unsigned char ihdr[] = {0, 1, 0x86, 0xa0, 0, 1, 0x86, 0xa0, 8, 2, 0, 0, 0};
    std::uint32_t crc = 0xffffffff;
    const auto add = [&](unsigned char byte) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = crc & 1 ? crc >> 1 ^ 0xedb88320 : crc >> 1;
    };
    for (const char c : std::string("IHDR"))
        add(static_cast<unsigned char>(c));
    for (std::size_t i = 0; i < sizeof ihdr; ++i) {
        png[16 + i] = char(ihdr[i]);
        add(ihdr[i]);
    }
    for (int i = 0; i < 4; ++i)
        png[29 + std::size_t(i)] = char(~crc >> (24 - 8 * i));
    try {
        decode_png(png);
        BOOST_ERROR("it was read");
    } catch (const std::runtime_error& error) {
        BOOST_TEST(std::string(error.what()).find("header promises") != std::string::npos,
                   error.what());
    }
}

BOOST_AUTO_TEST_CASE(lengths_in_a_file_cannot_make_us_allocate)
{
    const auto refusal_of = [](auto decode, const std::string& bytes) -> std::string {
        try {
            decode(bytes);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    };
    // Found by tests/sanitized/fuzz.test: libpng allocated the 2 GB that a chunk's length claims,
    // and OpenEXR the 2 GB that an attribute's length claims.
    using namespace std::string_literals;
    std::string png = encode_png({noise<std::uint8_t>(5, 4, 3, srgb), "", {}});
    constexpr std::size_t behind_header = 33;
    png.insert(behind_header, "\x7a\x54\0\0eXIfMM"s);
    BOOST_TEST(refusal_of(decode_png, png).find("chunk") != std::string::npos);

    const std::string exr = encode_exr({noise<float>(5, 4, 3, linear), "", {}});
    const PictureHeader start = decode_exr_header(
        encode_exr({noise<float>(50, 40, 3, linear), "{}", {}}).substr(0, 700));
    BOOST_TEST(start.width == 50);
    BOOST_TEST(start.height == 40);
    BOOST_TEST(start.bits == 32);
    BOOST_TEST(start.document == "{}");
    for (std::size_t size = 0; size < 300; size += 7)
        BOOST_CHECK_THROW(decode_exr_header(exr.substr(0, size)), std::runtime_error);
    constexpr std::size_t magic_and_version = 8;
    const auto with_attribute = [&](const std::string& bytes) {
        return exr.substr(0, magic_and_version) + bytes + exr.substr(magic_and_version);
    };
    BOOST_TEST(refusal_of(decode_exr, with_attribute("a\0b\0\1\0\0\0x"s)).find("attribute") ==
               std::string::npos);
    BOOST_TEST(
        refusal_of(decode_exr, with_attribute("a\0b\0\0\0\0\x70x"s)).find("longer than the file") !=
        std::string::npos);
    BOOST_TEST(refusal_of(decode_depths, with_attribute("a\0b\0\0\0\0\x70x"s))
                   .find("longer than the file") != std::string::npos);
    // A list of channels is read up to its end; the bytes behind it look like an attribute.
    for (const std::string& bad :
         {"a\0chlist\0\2\0\0\0\0x"s, "a\0box2i\0\x11\0\0\0"s + std::string(17, 'x'),
          "a\0preview\0\x9\0\0\0\1\0\0\0\1\0\0\0x"s})
        BOOST_TEST(refusal_of(decode_exr, with_attribute(bad)).find("not as long as its type") !=
                   std::string::npos);
    // A tile of 2 x 134152194 pixels in a picture of 5 x 4, which OpenEXR would allocate.
    BOOST_TEST(
        refusal_of(decode_exr, with_attribute("tiles\0tiledesc\0\x9\0\0\0\2\0\0\0\2\0\xff\7\0"s))
            .find("4096 x 4096") != std::string::npos);
    // The header of a file's second part.
    std::string parts = with_attribute("a\0b\0\1\0\0\0x\0a\0b\0\0\0\0\x70x"s);
    parts[5] = 0x10;
    BOOST_TEST(refusal_of(decode_exr, parts).find("longer than the file") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_white_page_may_be_packed_tightly)
{
    // 4000 x 4000 pixels of one bit are three bytes each when read: 48 MB of a file of two
    // kilobytes.
    std::string png = "\x89PNG\r\n\x1a\n";
    const auto four = [](unsigned long v) {
        return std::string{char(v >> 24), char(v >> 16), char(v >> 8), char(v)};
    };
    const auto add = [&](const std::string& body) {
        png += four(body.size() - 4) + body +
               four(crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size())));
    };
    constexpr int side = 4000;
    std::string rows(std::size_t(side) * (1 + side / 8), '\xff');
    for (std::size_t at = 0; at < rows.size(); at += 1 + side / 8)
        rows[at] = 0; // no filter
    std::string packed(compressBound(uLong(rows.size())), '\0');
    uLongf size = uLongf(packed.size());
    BOOST_REQUIRE(compress2(reinterpret_cast<Bytef*>(&packed[0]), &size,
                            reinterpret_cast<const Bytef*>(rows.data()), uLong(rows.size()),
                            9) == Z_OK);
    packed.resize(size);
    add("IHDR" + four(side) + four(side) + std::string{1, 0, 0, 0, 0});
    add("IDAT" + packed);
    add("IEND");
    const Image image = decode_png(png).image;
    BOOST_TEST(image.width == side);
    BOOST_TEST(stored_pixel(image, side - 1, side - 1).g == 1.0f);
}

BOOST_AUTO_TEST_CASE(writing_is_whole_or_not_at_all)
{
    const Folder folder;
    const std::string path = folder / "a.txt";
    write_file(path, "first");
    BOOST_REQUIRE(chmod(path.c_str(), 0640) == 0);
    write_file(path, "second");
    BOOST_TEST(bytes_of(path) == "second");
    BOOST_TEST((fs::status(path).permissions() == fs::perms(0640)));
    BOOST_TEST(folder.names().size() == 1u); // no other file is left

    fs::create_symlink("a.txt", folder / "link");
    write_file(folder / "link", "third");
    BOOST_TEST(fs::is_symlink(folder / "link"));
    BOOST_TEST(bytes_of(path) == "third");

    BOOST_CHECK_THROW(write_file(folder / "no/such/folder", "x"), OutputError);
    BOOST_CHECK_THROW(write_file(folder.path, "x"), OutputError);
    BOOST_CHECK_THROW(check_writable(folder / "no/such/folder"), OutputError);
    BOOST_CHECK_THROW(check_writable(folder.path), OutputError);
    BOOST_CHECK_NO_THROW(check_writable(folder / "new"));
    BOOST_CHECK_THROW(write_file("/dev/full", "x"), OutputError);
    BOOST_CHECK_THROW(write_frame(folder / "a.jpeg", {noise<std::uint8_t>(1, 1, 3, srgb), {}}),
                      OutputError);
    BOOST_TEST(folder.names().size() == 2u);
    BOOST_TEST(bytes_of(path) == "third");
}

BOOST_AUTO_TEST_CASE(greys_and_palettes_become_colours)
{
    // A grey 2 x 1 TIFF, white is zero, written byte by byte.
    std::string tiff("II*\0\x08\0\0\0", 8);
    const auto u16 = [&](unsigned v) {
        tiff += char(v & 255);
        tiff += char(v >> 8);
    };
    const auto u32 = [&](unsigned v) {
        u16(v & 65535);
        u16(v >> 16);
    };
    const auto tag = [&](unsigned id, unsigned type, unsigned value) {
        u16(id);
        u16(type);
        u32(1);
        u32(value);
    };
    u16(8);
    tag(256, 3, 2);                  // width
    tag(257, 3, 1);                  // length
    tag(258, 3, 8);                  // bits
    tag(259, 3, 1);                  // no compression
    tag(262, 3, 0);                  // white is zero
    tag(273, 4, 8 + 2 + 8 * 12 + 4); // where the strip is
    tag(277, 3, 1);                  // samples
    tag(279, 4, 2);                  // bytes
    u32(0);
    tiff += char(0);
    tiff += char(200);
    const Image image = decode_tiff(tiff).image;
    const std::vector<std::uint8_t> expected = {255, 255, 255, 55, 55, 55};
    BOOST_CHECK(std::get<std::vector<std::uint8_t>>(image.samples) == expected);
}

BOOST_AUTO_TEST_SUITE_END()
