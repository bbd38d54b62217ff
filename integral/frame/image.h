// SPDX-License-Identifier: AGPL-3.0-or-later
// A picture in memory: samples as the file stores them, and their encoding.
#ifndef INTEGRAL_FRAME_IMAGE_H
#define INTEGRAL_FRAME_IMAGE_H

#include "integral/frame/frame_metadata.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

namespace integral {

/// Colour in any encoding; 1 is full scale. Alpha 1 is opaque.
struct Colour {
    float r = 0, g = 0, b = 0, a = 1;
};

/// Interleaved samples: 8 or 16 bit integers (full scale = 1) or floats (any finite value).
using Samples = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>,
                             std::vector<float>>;

/// A picture of width x height pixels, row by row from the top left; pixel (x, y) begins at sample
/// (y * width + x) * channels. Three channels (R, G, B), four (and alpha, linear), or one for a
/// mask (grey). A mask can be written as PNG or TIFF; stored_pixel reads a mask, and store_pixel
/// stores a colour's red in it.
struct Image {
    int width = 0, height = 0;
    int channels = 3;
    Samples samples;
    Encoding encoding;          ///< of R, G and B
    bool premultiplied = false; ///< R, G and B have been multiplied by alpha, in linear light
};

/// A picture of zeros with samples of type Sample.
template <class Sample> Image make_image(int width, int height, int channels, Encoding encoding)
{
    Image image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.samples = std::vector<Sample>(std::size_t(width) * height * channels);
    image.encoding = encoding;
    return image;
}

/// Makes a form: an Image with size, sample type, channels and encoding, but without samples.
/// `bits`: 8, 16, or 32 for floats. blank_like allocates rows of a form.
Image form_of(int bits, int width, int height, int channels, Encoding encoding);

/// The form of a picture: the picture without its samples.
Image form_of(const Image& image);

/// Size in bytes of the samples of a picture of that form.
double size_in_bytes(const Image& form);

/// The number of rows to process at a time: a few megabytes of that form, at least one row.
int rows_of_a_band(const Image& form);

/// The samples of a row, as bytes.
unsigned char* row_bytes(Image& image, int y);
const unsigned char* row_bytes(const Image& image, int y);

/// Whether two pictures have the same size, sample type, channels and premultiplication.
bool same_form(const Image& a, const Image& b);

/// A picture of width x height zeros; its form is otherwise that of `like`.
Image blank_like(const Image& like, int width, int height);

/// The width x height rectangle of a picture whose top left pixel is (x, y); it must lie inside.
Image part_of(const Image& picture, int x, int y, int width, int height);

/// Rows [first, first + rows) of a picture.
Image rows_of(const Image& picture, int first, int rows);

/// The pictures arranged in rows of `columns`, from the top left, with `border` pixels of opaque
/// black between them. Throws std::invalid_argument if they differ in size or form, or if there are
/// none.
Image tiled(const std::vector<Image>& pictures, int columns, int border);

/// Bits per sample: 8, 16, or 32 for floats.
int sample_bits(const Image& image);

/// The stored colour of pixel (x, y), with 1 as full scale. The pixel must be inside the image.
/// Alpha is 1 if the image has none.
Colour stored_pixel(const Image& image, int x, int y);

/// Stores a colour without conversion; for integer samples it is rounded and clamped.
void store_pixel(Image& image, int x, int y, Colour color);

/// Index of the first sample of pixel (x, y).
inline std::size_t first_sample(const Image& image, int x, int y)
{
    return (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) *
           std::size_t(image.channels);
}

/// The sample that stands for 1.
template <class Sample> constexpr float full_scale()
{
    return std::is_integral<Sample>::value ? float(std::numeric_limits<Sample>::max()) : 1.0f;
}

/// Reads pixels as linear light premultiplied by alpha, which is the form for averaging. Uses a
/// table for integer samples. Refers to the image, which must outlive it.
class LinearReader {
public:
    explicit LinearReader(const Image& image);
    Colour operator()(int x, int y) const
    {
        Colour color;
        use([&](auto read) { color = read(x, y); });
        return color;
    }

    /// Calls use(read) once; read(x, y) does what the reader does, without looking at the image's
    /// form for each pixel.
    template <class Use> void use(Use use) const
    {
        std::visit(
            [&](const auto& samples) {
                const bool multiplies = image_.channels == 4 && !image_.premultiplied;
                use([&, multiplies](int x, int y) {
                    Colour color = stored(samples.data() + first_sample(image_, x, y));
                    if (multiplies) {
                        color.r *= color.a;
                        color.g *= color.a;
                        color.b *= color.a;
                    }
                    return color;
                });
            },
            image_.samples);
    }

private:
    /// A pixel's linear light, before it is premultiplied.
    template <class Sample> Colour stored(const Sample* s) const
    {
        const float alpha = image_.channels == 4 ? s[3] / full_scale<Sample>() : 1.0f;
        if constexpr (std::is_integral<Sample>::value)
            return {table_[s[0]], table_[s[1]], table_[s[2]], alpha};
        if (image_.encoding.kind == Encoding::Kind::linear)
            return {float(s[0]), float(s[1]), float(s[2]), alpha};
        const auto d = [&](float v) { return float(decode(image_.encoding, v)); };
        return {d(float(s[0])), d(float(s[1])), d(float(s[2])), alpha};
    }

    const Image& image_;
    std::vector<float> table_;
};

/// The inverse of LinearReader: stores linear premultiplied light in the image's form.
void store_linear(Image& image, int x, int y, Colour linear);

/// The picture in another form. `bits`: 8, 16 or 32. If encoding and premultiplication stay the
/// same, values change only by rounding.
Image converted(const Image& image, int bits, Encoding encoding, bool premultiplied);

} // namespace integral

#endif
