// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests portable float maps: round trips, and files of other programs.
#include "integral/base/file_bytes.h"
#include "integral/io/pfm_file.h"

#include <boost/test/unit_test.hpp>

#include <cstdio>

using namespace integral;

namespace {

struct File {
    std::string path = "io_pfm.pfm";
    ~File() { std::remove(path.c_str()); }
};

} // namespace

BOOST_AUTO_TEST_SUITE(io_pfm)

BOOST_AUTO_TEST_CASE(there_and_back)
{
    const File file;
    write_pfm(file.path, {2, 3, {1, -2.5f, 3e-9f, 4e9f, 0, 6}});
    const FloatMap back = read_pfm(file.path);
    BOOST_TEST(back.width == 2);
    BOOST_TEST(back.height == 3);
    BOOST_TEST(back.values == (std::vector<float>{1, -2.5f, 3e-9f, 4e9f, 0, 6}),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(highest_byte_first_and_three_channels)
{
    const File file;
    // The bottom row comes first; 1 is 3f800000, 2 is 40000000.
    const std::string one("\x3f\x80\0\0", 4), two("\x40\0\0\0", 4), none(4, '\0');
    write_file(file.path, "Pf 1 2 1.0\n" + one + two);
    BOOST_TEST(read_pfm(file.path).values == (std::vector<float>{2, 1}),
               boost::test_tools::per_element());
    write_file(file.path, "PF\n1 2\n1\n" + one + none + none + two + none + none);
    BOOST_TEST(read_pfm(file.path).values == (std::vector<float>{2, 1}),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(broken_ones_are_refused)
{
    const File file;
    for (const char* bytes : {"", "P6\n1 1\n255\n...", "Pf\n0 1\n-1\n....", "Pf\n1 -1\n-1\n....",
                              "Pf\n2 2\n-1\n....", "Pf\n1000000 1000000\n-1\n....", "Pf\n1x 1\n"}) {
        write_file(file.path, bytes);
        BOOST_CHECK_THROW(read_pfm(file.path), InputError);
    }
}

BOOST_AUTO_TEST_SUITE_END()
