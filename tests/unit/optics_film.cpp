// SPDX-License-Identifier: AGPL-3.0-or-later
// The size of a film in pixels and on paper: print_size and drafts.
#include "integral/optics/camera_parameters.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

BOOST_AUTO_TEST_SUITE(optics_film)

BOOST_AUTO_TEST_CASE(print_pixels_are_the_nearest_to_the_size)
{
    CameraParameters p;
    p.print_size = Vec2{150, 100};
    p.film.pixel_pitch = {25.4 / 720, 25.4 / 300};
    const PixelSize pixels = print_pixels(p);
    BOOST_TEST(pixels.width == 4252);  // 150 * 720 / 25.4 = 4251.97
    BOOST_TEST(pixels.height == 1181); // 100 * 300 / 25.4 = 1181.10
    BOOST_TEST(find_errors(p).empty());
    p.film.pixel_pitch = {1e-4, 1};
    BOOST_REQUIRE(find_errors(p).size() == 1);
    BOOST_TEST(find_errors(p).front() ==
               "print_size <150, 100> mm is 1.5e+06 pixels of this film across or down; 1 to "
               "1000000 are possible");
}

BOOST_AUTO_TEST_CASE(a_draft_is_as_large_as_its_film)
{
    for (const int width : {1, 2, 7, 100, 4252, 1000000})
        for (const int height : {1, 3, 50, 2835})
            for (const int n : {1, 2, 3, 7, 16, 100}) {
                const Film film{width, height, {0.03, 0.05}, Subpixels::rgb};
                const Film draft = draft_of(film, n);
                BOOST_TEST_CONTEXT(width << " x " << height << " / " << n)
                {
                    BOOST_TEST(draft.width >= 1);
                    BOOST_TEST(draft.height >= 1);
                    BOOST_TEST(std::abs(draft.width - double(width) / n) <= 1);
                    BOOST_TEST(size_of(draft).x == size_of(film).x,
                               boost::test_tools::tolerance(1e-15));
                    BOOST_TEST(size_of(draft).y == size_of(film).y,
                               boost::test_tools::tolerance(1e-15));
                    BOOST_CHECK(draft.subpixels.order == film.subpixels.order);
                    if (n == 1)
                        BOOST_TEST(draft.pixel_pitch.x == film.pixel_pitch.x);
                }
            }
}

BOOST_AUTO_TEST_SUITE_END()
