// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads and writes the files of `frames`: PNG frames, places of pixels, masks of imaged pixels.
#include "frames.h"

#include <png.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace frames {
namespace {

void complain(png_structp, png_const_charp message) { throw std::runtime_error(message); }

} // namespace

Frame read_frame(const std::string& name)
{
    std::FILE* file = std::fopen(name.c_str(), "rb");
    if (!file)
        throw std::runtime_error(name + ": cannot be opened");
    Frame f;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, complain, complain);
    png_infop info = png_create_info_struct(png);
    try {
        png_init_io(png, file);
        png_read_info(png, info);
        f.width = png_get_image_width(png, info);
        f.height = png_get_image_height(png, info);
        f.bits = png_get_bit_depth(png, info);
        f.channels = png_get_channels(png, info);
        png_set_expand_16(png);
        png_set_gray_to_rgb(png);
        png_set_add_alpha(png, 0xffff, PNG_FILLER_AFTER);
        png_set_interlace_handling(png);
        png_read_update_info(png, info);
        const std::size_t row = png_get_rowbytes(png, info);
        if (row != std::size_t(f.width) * 8)
            throw std::runtime_error("not 16-bit RGBA after expansion");
        std::vector<png_byte> bytes(row * f.height);
        std::vector<png_bytep> rows;
        for (int j = 0; j < f.height; j++)
            rows.push_back(bytes.data() + row * j);
        png_read_image(png, rows.data());
        png_read_end(png, nullptr);
        f.pixels.resize(std::size_t(f.width) * f.height);
        for (std::size_t p = 0; p < f.pixels.size(); p++)
            for (int c = 0; c < 4; c++)
                f.pixels[p][c] = bytes[p * 8 + c * 2] << 8 | bytes[p * 8 + c * 2 + 1];
    } catch (const std::exception& error) {
        std::fclose(file);
        throw std::runtime_error(name + ": " + error.what());
    }
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
    return f;
}

Frame read_oracle(const std::string& name, int height)
{
    Frame f = read_frame(name);
    if (f.height != height + 1)
        throw std::runtime_error(name + ": not one row more than the frame compared");
    f.pixels.erase(f.pixels.begin(), f.pixels.begin() + f.width);
    f.height--;
    return f;
}

void rerecord(const std::string& from, const std::vector<Place>& places, const std::string& to)
{
    std::FILE* in = std::fopen(from.c_str(), "rb");
    std::FILE* out = std::fopen(to.c_str(), "wb");
    if (!in || !out)
        throw std::runtime_error(from + " or " + to + ": cannot be opened");
    png_structp reader = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, complain, complain);
    png_infop info = png_create_info_struct(reader), end = png_create_info_struct(reader);
    png_init_io(reader, in);
    png_read_info(reader, info);
    const int width = png_get_image_width(reader, info),
              height = png_get_image_height(reader, info);
    const std::size_t row = png_get_rowbytes(reader, info), pixel = row / width;
    if (places.size() != std::size_t(width) * height)
        throw std::runtime_error("not a place for every pixel of " + from);
    std::vector<png_byte> bytes(row * height), moved(bytes.size());
    std::vector<png_bytep> rows, moved_rows;
    for (int j = 0; j < height; j++)
        rows.push_back(bytes.data() + row * j), moved_rows.push_back(moved.data() + row * j);
    png_read_image(reader, rows.data());
    png_read_end(reader, end);
    for (std::size_t n = 0; n < places.size(); n++)
        if (places[n].i >= 0)
            std::copy_n(rows[places[n].j] + pixel * places[n].i, pixel, moved.begin() + pixel * n);
    png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, complain,
                                                 complain);
    png_init_io(writer, out);
    png_write_info(writer, info);
    png_write_image(writer, moved_rows.data());
    png_write_end(writer, end);
    png_destroy_write_struct(&writer, nullptr);
    png_destroy_read_struct(&reader, &info, &end);
    std::fclose(in);
    std::fclose(out);
}

std::vector<Place> read_places(const std::string& name)
{
    std::vector<Place> places;
    std::ifstream in(name);
    for (Place place; in >> place.i >> place.j;)
        places.push_back(place);
    return places;
}

std::vector<std::string> read_mask(const std::string& name)
{
    std::ifstream in(name);
    std::vector<std::string> rows;
    for (std::string row; in >> row;)
        rows.push_back(row);
    return rows;
}

std::vector<std::size_t> read_imaged(const std::string& mask_name, std::size_t pixels)
{
    std::vector<std::size_t> places;
    std::ifstream mask(mask_name);
    char imaged;
    for (std::size_t p = 0; p < pixels && mask >> imaged; p++)
        if (imaged == '1')
            places.push_back(p);
    return places;
}

} // namespace frames
