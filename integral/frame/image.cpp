// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/image.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <limits>

namespace integral {
namespace {

template <class Sample> Sample sample_from(float value)
{
    if constexpr (std::is_integral<Sample>::value) {
        if (!(value > 0)) // NaN too
            return 0;
        const float scaled = value * full_scale<Sample>() + 0.5f;
        return scaled >= full_scale<Sample>() ? std::numeric_limits<Sample>::max()
                                              : static_cast<Sample>(scaled);
    } else {
        return value;
    }
}

double srgb_from_linear(double v)
{
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

double linear_from_srgb(double v)
{
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

Colour encoded(Colour linear, Encoding encoding)
{
    const auto e = [&](float v) { return float(encode(encoding, v)); };
    return {e(linear.r), e(linear.g), e(linear.b), linear.a};
}

} // namespace

Image tiled(const std::vector<Image>& pictures, int columns, int border)
{
    if (pictures.empty() || columns < 1)
        throw std::invalid_argument("there are no pictures");
    const Image& first = pictures[0];
    for (const Image& picture : pictures)
        if (!same_form(first, picture))
            throw std::invalid_argument("the pictures differ in size or form");
    const int rows = (int(pictures.size()) + columns - 1) / columns;
    Image sheet = blank_like(first, columns * (first.width + border) - border,
                             rows * (first.height + border) - border);
    for (int y = 0; y < sheet.height; ++y)
        for (int x = 0; x < sheet.width; ++x) {
            const int i = x / (first.width + border), j = y / (first.height + border);
            const int inner_x = x - i * (first.width + border),
                      inner_y = y - j * (first.height + border);
            const std::size_t k = std::size_t(j) * columns + i;
            const bool inside = k < pictures.size() && inner_x < first.width &&
                                inner_y < first.height;
            store_pixel(sheet, x, y,
                        inside ? stored_pixel(pictures[k], inner_x, inner_y) : Colour{0, 0, 0, 1});
        }
    return sheet;
}

int sample_bits(const Image& image)
{
    return image.samples.index() == 0 ? 8 : image.samples.index() == 1 ? 16 : 32;
}

double decode(Encoding encoding, double value)
{
    const double magnitude = std::fabs(value);
    switch (encoding.kind) {
    case Encoding::Kind::linear: return value;
    case Encoding::Kind::srgb: return std::copysign(linear_from_srgb(magnitude), value);
    case Encoding::Kind::power: return std::copysign(std::pow(magnitude, encoding.gamma), value);
    }
    return value;
}

double encode(Encoding encoding, double linear)
{
    const double magnitude = std::fabs(linear);
    switch (encoding.kind) {
    case Encoding::Kind::linear: return linear;
    case Encoding::Kind::srgb: return std::copysign(srgb_from_linear(magnitude), linear);
    case Encoding::Kind::power:
        return std::copysign(std::pow(magnitude, 1 / encoding.gamma), linear);
    }
    return linear;
}

bool same_encoding(Encoding a, Encoding b)
{
    return a.kind == b.kind && (a.kind != Encoding::Kind::power || a.gamma == b.gamma);
}

Colour stored_pixel(const Image& image, int x, int y)
{
    return std::visit(
        [&](const auto& samples) {
            using Sample = typename std::decay_t<decltype(samples)>::value_type;
            const Sample* s = samples.data() + first_sample(image, x, y);
            const float scale = full_scale<Sample>();
            if (image.channels == 1)
                return Colour{s[0] / scale, s[0] / scale, s[0] / scale, 1};
            return Colour{s[0] / scale, s[1] / scale, s[2] / scale,
                          image.channels == 4 ? s[3] / scale : 1};
        },
        image.samples);
}

void store_pixel(Image& image, int x, int y, Colour color)
{
    std::visit(
        [&](auto& samples) {
            using Sample = typename std::decay_t<decltype(samples)>::value_type;
            Sample* s = samples.data() + first_sample(image, x, y);
            s[0] = sample_from<Sample>(color.r);
            if (image.channels == 1)
                return;
            s[1] = sample_from<Sample>(color.g);
            s[2] = sample_from<Sample>(color.b);
            if (image.channels == 4)
                s[3] = sample_from<Sample>(color.a);
        },
        image.samples);
}

LinearReader::LinearReader(const Image& image) : image_(image)
{
    const int bits = sample_bits(image);
    if (bits > 16)
        return;
    const int last = (1 << bits) - 1;
    for (int v = 0; v <= last; ++v)
        table_.push_back(float(decode(image.encoding, double(v) / last)));
}

void store_linear(Image& image, int x, int y, Colour linear)
{
    if (image.channels == 4 && !image.premultiplied && linear.a > 0) {
        linear.r /= linear.a;
        linear.g /= linear.a;
        linear.b /= linear.a;
    }
    store_pixel(image, x, y, encoded(linear, image.encoding));
}

Image form_of(int bits, int width, int height, int channels, Encoding encoding)
{
    Image form = bits == 8    ? make_image<std::uint8_t>(0, 0, channels, encoding)
                 : bits == 16 ? make_image<std::uint16_t>(0, 0, channels, encoding)
                              : make_image<float>(0, 0, channels, encoding);
    form.width = width;
    form.height = height;
    return form;
}

Image form_of(const Image& image)
{
    Image form = form_of(sample_bits(image), image.width, image.height, image.channels,
                         image.encoding);
    form.premultiplied = image.premultiplied;
    return form;
}

double size_in_bytes(const Image& form)
{
    return double(form.width) * form.height * form.channels * (sample_bits(form) / 8);
}

int rows_of_a_band(const Image& form)
{
    constexpr double most_bytes = 4 << 20;
    constexpr int block = 16; // OpenEXR packs 16 rows at a time
    const double row = size_in_bytes(form) / std::max(1, form.height);
    const int rows = int(std::min(most_bytes / std::max(1.0, row), double(form.height)));
    return rows >= block ? rows / block * block : std::max(1, rows);
}

const unsigned char* row_bytes(const Image& image, int y)
{
    return std::visit(
        [&](const auto& samples) {
            const auto* row = samples.data() + first_sample(image, 0, y);
            return reinterpret_cast<const unsigned char*>(row);
        },
        image.samples);
}

unsigned char* row_bytes(Image& image, int y)
{
    return const_cast<unsigned char*>(row_bytes(const_cast<const Image&>(image), y));
}

bool same_form(const Image& a, const Image& b)
{
    return a.width == b.width && a.height == b.height && a.channels == b.channels &&
           a.samples.index() == b.samples.index() && a.premultiplied == b.premultiplied;
}

Image blank_like(const Image& like, int width, int height)
{
    Image image = std::visit(
        [&](const auto& samples) {
            return make_image<typename std::decay_t<decltype(samples)>::value_type>(
                width, height, like.channels, like.encoding);
        },
        like.samples);
    image.premultiplied = like.premultiplied;
    return image;
}

Image rows_of(const Image& picture, int first, int rows)
{
    return part_of(picture, 0, first, picture.width, rows);
}

Image part_of(const Image& picture, int x, int y, int width, int height)
{
    Image part = blank_like(picture, width, height);
    const std::size_t pixel = std::size_t(picture.channels) * (sample_bits(picture) / 8);
    for (int j = 0; j < height; ++j)
        std::memcpy(row_bytes(part, j), row_bytes(picture, y + j) + pixel * x, pixel * width);
    return part;
}

Image converted(const Image& image, int bits, Encoding encoding, bool premultiplied)
{
    Image result = bits == 8 ? make_image<std::uint8_t>(image.width, image.height, image.channels,
                                                        encoding)
                   : bits == 16
                       ? make_image<std::uint16_t>(image.width, image.height, image.channels,
                                                   encoding)
                       : make_image<float>(image.width, image.height, image.channels, encoding);
    result.premultiplied = premultiplied;
    const bool same_form = same_encoding(image.encoding, encoding) &&
                           (image.channels == 3 || image.premultiplied == premultiplied);
    const LinearReader linear(image);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (same_form)
                store_pixel(result, x, y, stored_pixel(image, x, y));
            else
                store_linear(result, x, y, linear(x, y));
    return result;
}

} // namespace integral
