// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the fields of multi-picture files that describe views (CIPA DC-007-2009), byte by byte.
#include "integral/io/mpo_file.h"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <optional>

using namespace integral;

namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t at, int count)
{
    std::uint32_t value = 0;
    for (int k = 0; k < count; ++k)
        value = value << 8 | std::uint8_t(bytes.at(at + std::size_t(k)));
    return value;
}

/// The value of a rational field (type 5 or 10, one value) in a picture's index. `picture`: the
/// picture's offset in the file.
std::optional<double> fraction_of(const std::string& bytes, std::size_t picture, std::uint32_t tag)
{
    const std::size_t header = bytes.find(std::string("MPF\0", 4), picture) + 4;
    std::size_t directory = header + number_at(bytes, header + 4, 4);
    while (directory != header) {
        const std::uint32_t fields = number_at(bytes, directory, 2);
        for (std::uint32_t k = 0; k < fields; ++k) {
            const std::size_t field = directory + 2 + 12 * k;
            if (number_at(bytes, field, 2) != tag)
                continue;
            const std::size_t value = header + number_at(bytes, field + 8, 4);
            return double(number_at(bytes, value, 4)) / double(number_at(bytes, value + 4, 4));
        }
        directory = header + number_at(bytes, directory + 2 + 12 * fields, 4);
    }
    return std::nullopt;
}

} // namespace

BOOST_AUTO_TEST_SUITE(io_mpo)

BOOST_AUTO_TEST_CASE(eyes_are_metres_from_the_first)
{
    constexpr std::uint32_t baseline_tag = 0xb206;
    const std::vector<Image> views(3, make_image<std::uint8_t>(16, 8, 3, {}));
    const std::string bytes = mpo_of_views(views, 90, 63.5);
    const std::vector<std::size_t> begin = pictures_in_mpo(bytes);
    BOOST_REQUIRE(begin.size() == 3u);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto metres = fraction_of(bytes, begin[k], baseline_tag);
        BOOST_REQUIRE(metres.has_value());
        BOOST_TEST(std::fabs(*metres - 0.0635 * double(k)) < 1e-9);
    }
}

BOOST_AUTO_TEST_SUITE_END()
