// SPDX-License-Identifier: AGPL-3.0-or-later
// How coarse a draft may be that is to be judged by eye.
#include "integral/batch/scene_look.h"

#include <boost/test/unit_test.hpp>

using namespace integral;

BOOST_AUTO_TEST_SUITE(batch_scene_look)

BOOST_AUTO_TEST_CASE(a_draft_keeps_four_pixels_or_stripes_a_lens)
{
    FrameMetadata frame;
    frame.sheet.arrangement = Arrangement::lenticular;
    frame.sheet.pitch = 1.3;
    frame.film = {100, 100, {0.1, 0.1}}; // 13 pixels a lens
    BOOST_TEST(draft_of_four_views(frame) == 3);
    frame.film.pixel_pitch = {0.4, 0.4};
    BOOST_TEST(draft_of_four_views(frame) == 1);
    frame.film = {100, 100, {0.2, 0.2}, Subpixels::rgb}; // 19.5 stripes a lens
    BOOST_TEST(draft_of_four_views(frame) == 4);
    frame.film.subpixels = Subpixels::vrgb; // along the lenses
    BOOST_TEST(draft_of_four_views(frame) == 1);
    frame.sheet.slant = 90; // the lenses lie across
    BOOST_TEST(draft_of_four_views(frame) == 4);
}

BOOST_AUTO_TEST_SUITE_END()
