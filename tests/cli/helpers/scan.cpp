// SPDX-License-Identifier: AGPL-3.0-or-later
// A flatbed scanner, simulated, for integral_rectify.test; shares nothing with libintegral.
//
//   scan PAGE.png SCAN.png WORD=VALUE...   PAGE is 8 or 16 bits, sRGB; SCAN is 8 bits
//     page=D  size=W,H  dpi=D    dots an inch of the page (300), pixels of the scan, dots an inch
//                                that it claims (600)
//     scale=F or F,F             its true dots an inch divided by the claimed ones, across and
//                                down (1)
//     turn=DEGREES               anticlockwise, of the page in the scan (0)
//     at=X,Y                     page pixel, from the top left, in the middle of the scan (the
//                                page's middle)
//     light=A,B                  light falls by A from left to right and by B from the middle to
//                                the corners (0,0)
//     cast=R,G,B  noise=S  seed=N
//                                the channels' gains; Gaussian noise, of 255; its seed
//     flat                       PAGE is white (its name is ignored)
//     paper=V  blur=S  jpeg=Q    linear light of the surroundings of the page (0.05); standard
//                                deviation of a Gaussian blur, scan pixels (0); quality of a JPEG
//                                through which the scan goes (none)
// Prints where the page's middle is in the scan, pixels from its top left. The page's pixels are
// boxes; a scan pixel is the mean of 6 x 6 points of it.
#include <cstddef>
#include <cstdio>

#include <jpeglib.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

struct Page {
    int width = 0, height = 0;
    std::vector<float> linear; // r, g, b
};

double decoded(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
double encoded(double v)
{
    return v <= 0 ? 0 : v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

bool read_page(const char* name, Page& page)
{
    png_image png = {};
    png.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&png, name))
        return false;
    png.format = PNG_FORMAT_RGB;
    std::vector<png_byte> bytes(PNG_IMAGE_SIZE(png));
    if (!png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr))
        return false;
    page.width = int(png.width);
    page.height = int(png.height);
    float table[256];
    for (int k = 0; k < 256; ++k)
        table[k] = float(decoded(k / 255.0));
    for (const png_byte b : bytes)
        page.linear.push_back(table[b]);
    return true;
}

bool write_scan(const char* name, int width, int height, double dpi, std::vector<png_byte>& bytes)
{
    FILE* file = std::fopen(name, "wb");
    if (!file)
        return false;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_init_io(png, file);
    png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_pHYs(png, info, png_uint_32(std::lround(dpi / 0.0254)),
                 png_uint_32(std::lround(dpi / 0.0254)), PNG_RESOLUTION_METER);
    png_set_compression_level(png, 1);
    png_write_info(png, info);
    for (int y = 0; y < height; ++y)
        png_write_row(png, bytes.data() + std::size_t(y) * width * 3);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return std::fclose(file) == 0;
}

/// Blurs three channels of linear light by a Gaussian of this standard deviation, pixels.
void blur(std::vector<float>& light, int width, int height, double deviation)
{
    const int reach = int(std::ceil(3 * deviation));
    std::vector<double> weights;
    double sum = 0;
    for (int k = -reach; k <= reach; ++k) {
        weights.push_back(std::exp(-0.5 * k * k / (deviation * deviation)));
        sum += weights.back();
    }
    for (const bool across : {true, false}) {
        std::vector<float> result(light.size());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int k = -reach; k <= reach; ++k) {
                    const int i = across ? std::clamp(x + k, 0, width - 1) : x,
                              j = across ? y : std::clamp(y + k, 0, height - 1);
                    for (int c = 0; c < 3; ++c)
                        result[(std::size_t(y) * width + x) * 3 + c] += float(
                            weights[k + reach] / sum * light[(std::size_t(j) * width + i) * 3 + c]);
                }
        light = std::move(result);
    }
}

/// Compresses a picture as JPEG, and expands it again.
void through_jpeg(std::vector<png_byte>& bytes, int width, int height, int quality)
{
    jpeg_error_mgr errors;
    unsigned char* file = nullptr;
    unsigned long size = 0;
    jpeg_compress_struct out = {};
    out.err = jpeg_std_error(&errors);
    jpeg_create_compress(&out);
    jpeg_mem_dest(&out, &file, &size);
    out.image_width = JDIMENSION(width);
    out.image_height = JDIMENSION(height);
    out.input_components = 3;
    out.in_color_space = JCS_RGB;
    jpeg_set_defaults(&out);
    jpeg_set_quality(&out, quality, TRUE);
    jpeg_start_compress(&out, TRUE);
    for (int y = 0; y < height; ++y) {
        JSAMPROW row = bytes.data() + std::size_t(y) * width * 3;
        jpeg_write_scanlines(&out, &row, 1);
    }
    jpeg_finish_compress(&out);
    jpeg_destroy_compress(&out);
    jpeg_decompress_struct in = {};
    in.err = jpeg_std_error(&errors);
    jpeg_create_decompress(&in);
    jpeg_mem_src(&in, file, size);
    jpeg_read_header(&in, TRUE);
    jpeg_start_decompress(&in);
    for (int y = 0; y < height; ++y) {
        JSAMPROW row = bytes.data() + std::size_t(y) * width * 3;
        jpeg_read_scanlines(&in, &row, 1);
    }
    jpeg_finish_decompress(&in);
    jpeg_destroy_decompress(&in);
    std::free(file);
}

} // namespace

int main(int count, char** arguments)
{
    if (count < 3)
        return 2;
    std::map<std::string, std::string> words;
    for (int k = 3; k < count; ++k) {
        const std::string word = arguments[k];
        words[word.substr(0, word.find('='))] = word.find('=') < word.size()
                                                    ? word.substr(word.find('=') + 1)
                                                    : "";
    }
    const auto numbers = [&](const char* name, std::vector<double> fallback) {
        if (!words.count(name))
            return fallback;
        std::vector<double> values;
        for (const char* at = words[name].c_str(); *at; at += *at == ',') {
            char* end;
            values.push_back(std::strtod(at, &end));
            if (end == at)
                std::exit(2);
            at = end;
        }
        while (values.size() < fallback.size())
            values.push_back(values.back());
        return values;
    };
    Page page;
    if (!words.count("flat") && !read_page(arguments[1], page))
        return 3;
    const double page_dpi = numbers("page", {300})[0], dpi = numbers("dpi", {600})[0];
    const auto size = numbers("size", {100, 100}), scale = numbers("scale", {1, 1}),
               light = numbers("light", {0, 0}), cast = numbers("cast", {1, 1, 1});
    const auto at = numbers("at", {0.5 * page.width, 0.5 * page.height});
    const double turn = numbers("turn", {0})[0] * std::acos(-1.0) / 180,
                 noise = numbers("noise", {0})[0];
    const int width = int(size[0]), height = int(size[1]);
    // Page pixels a scan pixel, along the scan's axes.
    const double across = page_dpi / (dpi * scale[0]), down = page_dpi / (dpi * scale[1]),
                 c = std::cos(turn), s = std::sin(turn);
    std::mt19937 random(unsigned(numbers("seed", {1})[0]));
    std::normal_distribution<double> normal(0, 1);
    std::vector<png_byte> bytes(std::size_t(width) * height * 3);
    const double paper = numbers("paper", {words.count("flat") ? 0.9 : 0.05})[0];
    std::vector<float> linear(bytes.size());
    constexpr int points = 6;
    const float outside[3] = {float(paper), float(paper), float(paper)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float sums[3] = {0, 0, 0};
            for (int j = 0; j < points; ++j) {
                // Right and up of the middle, by the page's pixels, turned back clockwise.
                const double up = -(y + (j + 0.5) / points - 0.5 * height) * down;
                for (int i = 0; i < points; ++i) {
                    const double right = (x + (i + 0.5) / points - 0.5 * width) * across,
                                 to_right = at[0] + c * right + s * up,
                                 to_below = at[1] - (-s * right + c * up);
                    const bool inside = to_right >= 0 && to_below >= 0 && to_right < page.width &&
                                        to_below < page.height;
                    const float* from = inside ? &page.linear[(std::size_t(to_below) * page.width +
                                                               std::size_t(to_right)) *
                                                              3]
                                               : outside;
                    for (int k = 0; k < 3; ++k)
                        sums[k] += from[k];
                }
            }
            for (int k = 0; k < 3; ++k)
                linear[(std::size_t(y) * width + x) * 3 + k] = sums[k] / (points * points);
        }
    const double blurred = numbers("blur", {0})[0];
    if (blurred > 0)
        blur(linear, width, height, blurred);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double u = 2 * (x + 0.5) / width - 1, v = 2 * (y + 0.5) / height - 1;
            const double lit = (1 - light[0] * 0.5 * (1 + u)) *
                               (1 - light[1] * 0.5 * (u * u + v * v));
            for (int k = 0; k < 3; ++k) {
                const std::size_t at_byte = (std::size_t(y) * width + x) * 3 + k;
                const double value = 255 * encoded(linear[at_byte] * lit * cast[k]) +
                                     noise * normal(random);
                bytes[at_byte] = png_byte(std::clamp(value + 0.5, 0.0, 255.0));
            }
        }
    if (words.count("jpeg"))
        through_jpeg(bytes, width, height, int(numbers("jpeg", {90})[0]));
    if (!write_scan(arguments[2], width, height, dpi, bytes))
        return 4;
    // The page's middle from the scan's middle, turned anticlockwise.
    const double right = 0.5 * page.width - at[0], up = at[1] - 0.5 * page.height;
    std::printf("%.6f %.6f\n", 0.5 * width + (c * right - s * up) / across,
                0.5 * height - (s * right + c * up) / down);
}
