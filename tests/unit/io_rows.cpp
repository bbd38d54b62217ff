// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests reading and writing pictures row by row: the same result as for whole pictures, metadata
// without pixels, and files that appear only when they are complete.
#include "integral/io/codecs.h"
#include "integral/io/image_file.h"
#include "integral/base/memory.h"
#include "tests/unit/picture_files.h"

#include <boost/test/unit_test.hpp>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfTiledOutputFile.h>
#include <cstdlib>
#include <filesystem>
#include <png.h>
#include <tiffio.h>

using namespace picture_files;
namespace fs = std::filesystem;

BOOST_AUTO_TEST_SUITE(io_rows)

namespace {

constexpr int width = 70, height = 53;

template <class Sample> Image noise(int channels, Encoding encoding = {})
{
    return picture_files::noise<Sample>(width, height, channels, encoding, 251, 11);
}

/// A file's picture, read `most` rows at a time.
Image in_bands(const std::string& bytes, int most)
{
    const InputFile file = InputFile::of_bytes(bytes);
    const auto reader = read_any(file);
    Image all = reader->head().image;
    all = blank_like(all, all.width, all.height);
    const std::size_t row = std::size_t(size_in_bytes(all) / all.height);
    for (int y = 0; y < all.height; y += most) {
        Image band = blank_like(all, all.width, std::min(most, all.height - y));
        reader->read(band);
        for (int k = 0; k < band.height; ++k)
            std::copy_n(row_bytes(band, k), row, row_bytes(all, y + k));
    }
    return all;
}

void check_bands(const std::string& bytes, const Image& requested)
{
    for (const int most : {1, 7, 16, height})
        BOOST_CHECK(in_bands(bytes, most).samples == requested.samples);
}

/// An 8-bit RGB PNG whose rows come in seven passes.
void write_interlaced(const std::string& path, const Image& image)
{
    std::FILE* file = std::fopen(path.c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_ADAM7,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    std::vector<png_bytep> rows;
    for (int y = 0; y < height; ++y)
        rows.push_back(const_cast<png_bytep>(row_bytes(image, y)));
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

/// An 8-bit RGB TIFF with separate planes for the channels.
void write_planes(const std::string& path, const Image& image)
{
    TIFF* tiff = TIFFOpen(path.c_str(), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_SEPARATE);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, height);
    std::vector<unsigned char> row(width);
    for (int channel = 0; channel < 3; ++channel)
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x)
                row[std::size_t(x)] = row_bytes(image, y)[3 * x + channel];
            TIFFWriteScanline(tiff, row.data(), std::uint32_t(y), std::uint16_t(channel));
        }
    TIFFClose(tiff);
}

/// An EXR in tiles of 16 x 16 pixels.
void write_tiles(const std::string& path, const Image& image)
{
    Imf::Header header(width, height);
    header.setTileDescription(Imf::TileDescription(16, 16));
    Imf::FrameBuffer source;
    int channel = 0;
    for (const char* name : {"R", "G", "B"}) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        source.insert(
            name, Imf::Slice(Imf::FLOAT,
                             const_cast<char*>(reinterpret_cast<const char*>(row_bytes(image, 0))) +
                                 4 * channel++,
                             12, 12 * width));
    }
    Imf::TiledOutputFile file(path.c_str(), header);
    file.setFrameBuffer(source);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
}

} // namespace

BOOST_AUTO_TEST_CASE(bands_are_the_rows_of_the_whole)
{
    for (const int channels : {3, 4}) {
        const Image bytes = noise<std::uint8_t>(channels), words = noise<std::uint16_t>(channels);
        Image floats = noise<float>(channels, linear);
        floats.premultiplied = true;
        for (const Image& image : {bytes, words}) {
            check_bands(encode_png({image, "", {}, ""}), image);
            check_bands(encode_tiff({image, "", {}, ""}), image);
        }
        check_bands(encode_tiff({floats, "", {}, ""}), floats);
        check_bands(encode_exr({floats, "", {}, ""}), floats);
    }
    const Folder folder;
    const Image image = noise<std::uint8_t>(3);
    write_interlaced(folder / "a.png", image);
    check_bands(bytes_of(folder / "a.png"), image);
    write_planes(folder / "a.tif", image);
    check_bands(bytes_of(folder / "a.tif"), image);
    const Image floats = noise<float>(3, linear);
    write_tiles(folder / "a.exr", floats);
    check_bands(bytes_of(folder / "a.exr"), floats);
}

BOOST_AUTO_TEST_CASE(bands_are_written_as_the_whole)
{
    const auto written = [](auto write, const Image& image, int most) {
        ByteString sink;
        const auto writer = write(sink,
                                  DecodedImage{form_of(image), "{\"a\": 1}", Vec2{0.1, 0.2}, ""});
        for (int y = 0; y < image.height; y += most)
            writer->write(rows_of(image, y, std::min(most, image.height - y)));
        writer->finish();
        return sink.bytes;
    };
    Image floats = noise<float>(4, linear);
    floats.premultiplied = true;
    for (const int most : {1, 7, 16}) {
        for (const Image& image : {noise<std::uint8_t>(3), noise<std::uint16_t>(4)}) {
            BOOST_CHECK(written(write_png, image, most) == written(write_png, image, height));
            BOOST_CHECK(written(write_tiff, image, most) == written(write_tiff, image, height));
        }
        BOOST_CHECK(written(write_exr, floats, most) == written(write_exr, floats, height));
    }
}

BOOST_AUTO_TEST_CASE(metadata_is_read_without_pixels)
{
    // Files whose pixels cannot be unpacked, with the document before or after the pixels.
    const Folder folder;
    FrameMetadata metadata;
    metadata.sheet.pitch = 2.5;
    metadata.film = {width, height, {0.1, 0.1}};
    metadata.aperture.distance = 300;
    metadata.aperture.width = metadata.aperture.height = 50;
    Frame frame{noise<std::uint16_t>(3), {}};
    set_metadata(frame, metadata);
    for (const char* name : {"a.png", "a.tif", "a.exr"}) {
        BOOST_TEST_CONTEXT(name)
        {
            const std::string path = folder / name;
            write_frame(path, frame);
            std::string bytes = bytes_of(path);
            std::size_t pixels = bytes.size() / 2; // far behind the header of this small picture
            if (path == folder / "a.png") {
                pixels = bytes.find("IDAT") + 4;
                const std::size_t text = bytes.find("iTXt") - 4, end = bytes.find("IDAT") - 4,
                                  iend = bytes.rfind("IEND") - 4;
                const std::string document = bytes.substr(text, end - text);
                bytes.insert(iend, document);
                bytes.erase(text, end - text);
                pixels -= end - text;
            }
            for (std::size_t k = 0; k < 1000; ++k)
                bytes[pixels + k] = char(0x55);
            write_bytes(path, bytes);
            BOOST_CHECK_THROW(read_frame(path), InputError);
            BOOST_TEST(read_metadata(path).sheet.pitch == 2.5);
            BOOST_TEST(picture_size(path).second == height);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_picture_larger_than_the_free_memory_is_refused)
{
    try {
        check_memory(1e15);
        BOOST_ERROR("a petabyte is free");
    } catch (const std::runtime_error& error) {
        BOOST_TEST(std::string(error.what()).find("it needs 1e+06 GB of memory, and ") == 0,
                   error.what());
    }
    BOOST_TEST(free_memory() > 1e6);
    BOOST_CHECK_NO_THROW(check_memory(1e6));
}

BOOST_AUTO_TEST_CASE(a_file_that_is_not_finished_leaves_nothing)
{
    const Folder folder;
    const std::string path = folder / "a.txt", large(3 << 20, 'x');
    write_file(path, "before");
    {
        OutputFile file(path);
        file.write(0, large.data(), large.size());
        BOOST_TEST(folder.names().size() == 2);
    }
    BOOST_TEST(folder.names().size() == 1);
    BOOST_TEST(bytes_of(path) == "before");
    {
        OutputFile file(path);
        file.write(0, large.data(), large.size());
        file.write(5, "yz", 2); // overwrites earlier bytes
        file.write(large.size(), "end", 3);
        char back[3];
        BOOST_TEST(file.read(4, back, 3) == 3u);
        BOOST_TEST(std::string(back, 3) == "xyz");
        BOOST_TEST(file.size() == large.size() + 3);
        file.finish();
    }
    std::string requested = large + "end";
    requested.replace(5, 2, "yz");
    BOOST_CHECK(bytes_of(path) == requested);
    BOOST_TEST(folder.names().size() == 1);

    // A picture with missing rows leaves no file.
    const Image image = noise<std::uint8_t>(3);
    for (const char* name : {"a.png", "a.tif", "a.exr"}) {
        PictureWriter writer = PictureWriter::of_frame(folder / name, image, std::nullopt);
        writer.write(rows_of(image, 0, 20));
    }
    BOOST_TEST(folder.names().size() == 1);
}

BOOST_AUTO_TEST_SUITE_END()
