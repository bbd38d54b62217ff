// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/exif.h"

#include "integral/optics/film.h"

#include <stdexcept>

namespace integral {
namespace {

enum Tag { orientation = 0x112, x_resolution = 0x11a, y_resolution = 0x11b, unit = 0x128 };
enum Type { u16_type = 3, rational = 5 };

/// The fields of the first directory that exif_facts needs.
struct Fields {
    std::uint32_t orientation = 1, unit = 2;
    double x = 0, y = 0; ///< pixels per unit; 0: not given
};

double rational_at(const TiffNumbers& numbers, std::size_t offset)
{
    const double below = numbers.at(offset + 4, 4);
    return below > 0 ? numbers.at(offset, 4) / below : 0;
}

void read_fields(const TiffNumbers& numbers, Fields& fields)
{
    const std::size_t directory = numbers.at(4, 4), count = numbers.at(directory, 2);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t field = directory + 2 + 12 * k;
        const std::uint32_t tag = numbers.at(field, 2), type = numbers.at(field + 2, 2);
        if (tag == orientation && type == u16_type)
            fields.orientation = numbers.at(field + 8, 2);
        if (tag == unit && type == u16_type)
            fields.unit = numbers.at(field + 8, 2);
        if (tag == x_resolution && type == rational)
            fields.x = rational_at(numbers, numbers.at(field + 8, 4));
        if (tag == y_resolution && type == rational)
            fields.y = rational_at(numbers, numbers.at(field + 8, 4));
    }
}

} // namespace

TiffNumbers::TiffNumbers(const std::string& bytes, std::size_t begin) : bytes_(bytes), begin_(begin)
{
    little_ = at(0, 2) == 0x4949;
}

std::uint32_t TiffNumbers::at(std::size_t offset, int count) const
{
    const std::size_t first = begin_ + offset;
    if (first > bytes_.size() || bytes_.size() - first < std::size_t(count))
        throw std::runtime_error("its directory of fields ends too early");
    std::uint32_t value = 0;
    for (int k = 0; k < count; ++k)
        value = value << 8 | std::uint8_t(bytes_[first + std::size_t(little_ ? count - 1 - k : k)]);
    return value;
}

ExifFacts exif_facts(const std::string& block)
{
    Fields fields;
    try {
        read_fields(TiffNumbers(block, 0), fields);
    } catch (const std::runtime_error&) { // keep what was read before the end
    }
    ExifFacts facts;
    if (fields.orientation >= 1 && fields.orientation <= 8)
        facts.orientation = int(fields.orientation);
    if (fields.x > 0 && fields.y > 0 && (fields.unit == 2 || fields.unit == 3)) {
        constexpr double mm_per_cm = 10;
        const double mm = fields.unit == 3 ? mm_per_cm : mm_per_inch;
        facts.pixel_pitch = Vec2{mm / fields.x, mm / fields.y};
    }
    return facts;
}

} // namespace integral
