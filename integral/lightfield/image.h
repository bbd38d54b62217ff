// SPDX-License-Identifier: AGPL-3.0-or-later
// A picture in memory: samples as its file stored them, and how they encode light.
#ifndef INTEGRAL_LIGHTFIELD_IMAGE_H
#define INTEGRAL_LIGHTFIELD_IMAGE_H

#include "integral/lightfield/frame_metadata.h"

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace integral {

/// Colour in any encoding; 1 is full scale. Alpha 1 is opaque.
struct Color {
    float r = 0, g = 0, b = 0, a = 1;
};

/// Interleaved samples: 8 or 16 bit integers (full scale = 1) or floats (any finite value).
using Samples = std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>,
                             std::vector<float>>;

/// A picture of width x height pixels, row by row from the top left; pixel (x, y) begins at
/// sample (y * width + x) * channels. Three channels (R, G, B) or four (and alpha, linear).
struct Image {
    int width = 0, height = 0;
    int channels = 3;
    Samples samples;
    Encoding encoding;          ///< of R, G and B
    bool premultiplied = false; ///< R, G and B have been multiplied by alpha, in linear light
};

/// A picture of zeros whose samples are of the given type's kind.
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

/// A picture's form: a picture of that size whose samples are left out. `bits` is 8, 16, or 32 for
/// floats. blank_like makes rows of it.
Image form_of(int bits, int width, int height, int channels, Encoding encoding);

/// The form of a picture.
Image form_of(const Image& image);

/// Bytes of a picture of that form.
double size_in_bytes(const Image& form);

/// As many rows of that form as are worked on at a time: some megabytes, and at least one.
int rows_of_a_band(const Image& form);

/// The samples of a row, as bytes.
unsigned char* row_bytes(Image& image, int y);
const unsigned char* row_bytes(const Image& image, int y);

/// Whether two pictures are alike in all but their samples' values and the encoding.
bool same_form(const Image& a, const Image& b);

/// A picture of zeros of the same form.
Image blank_like(const Image& like, int width, int height);

/// The rectangle of a picture whose top left pixel is (x, y); it must be inside.
Image part_of(const Image& picture, int x, int y, int width, int height);

/// Rows [first, first + rows) of a picture.
Image rows_of(const Image& picture, int first, int rows);

/// The pictures, all of one size and form, row by row from the top left, `columns` in a row, with
/// `border` pixels of black (opaque) between them. Throws std::invalid_argument where they differ,
/// or are none.
Image tiled(const std::vector<Image>& pictures, int columns, int border);

/// Bits per sample: 8, 16, or 32 for floats.
int sample_bits(const Image& image);

/// The stored colour of pixel (x, y), 1 at full scale; it must be inside. Alpha is 1 if absent.
Color stored_pixel(const Image& image, int x, int y);

/// Stores a colour as it is, integers rounded and cut to their range.
void store_pixel(Image& image, int x, int y, Color color);

/// Reads pixels as linear light, premultiplied by alpha: what averages are taken of. Holds a
/// table for integer samples; refers to the image, which must outlive it.
class LinearReader {
public:
    explicit LinearReader(const Image& image);
    Color operator()(int x, int y) const;

private:
    const Image& image_;
    std::vector<float> table_;
};

/// Inverse of a LinearReader: stores linear premultiplied light in the image's own form.
void store_linear(Image& image, int x, int y, Color linear);

/// The same picture in another form. `bits` is 8, 16 or 32. Without change of encoding or
/// premultiplication, values only change by rounding.
Image converted(const Image& image, int bits, Encoding encoding, bool premultiplied);

} // namespace integral

#endif
