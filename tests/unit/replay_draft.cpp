// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests that a draft is filled in lens by lens, and where its pixels' light goes.
#include "integral/replay/draft_frame.h"

#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace integral;

namespace {

/// A draft of 3 x 3 pixels each, of linear light, behind lenses 1.2 mm wide with 6 pixels each.
Frame draft_of_lenses(Arrangement arrangement)
{
    Frame frame;
    frame.image = make_image<float>(48, 36, 3, Encoding{Encoding::Kind::linear});
    FrameMetadata metadata;
    metadata.sheet.arrangement = arrangement;
    metadata.sheet.pitch = 1.2;
    metadata.sheet.thickness = 3;
    metadata.sheet.ior = 1.6;
    metadata.film = {48, 36, {0.2, 0.2}};
    metadata.aperture = *filling_aperture(metadata.sheet, 2000);
    metadata.encoding = frame.image.encoding;
    metadata.render = RenderRecord();
    metadata.render->draft = 3;
    frame.metadata = metadata;
    return frame;
}

struct Place {
    LensIndex lens;
    Vec2 from_pole; // mm
};

Place place_of(const FrameMetadata& m, int x, int y)
{
    const SheetOptics optics(m.sheet, m.aperture);
    const Vec2 point = film_from_pixel(m.film, {x + 0.5, y + 0.5});
    const LensIndex lens = optics.map(point, LensMapping::automatic).ray->lens;
    return {lens, point - optics.lattice().pole(lens)};
}

/// Light that grows across each lens, about 0.2 or 0.8 by turns.
float light_of(const Place& place)
{
    return float(((place.lens.i + place.lens.j) % 2 ? 0.8 : 0.2) + 0.1 * place.from_pole.x);
}

} // namespace

BOOST_AUTO_TEST_SUITE(replay_draft)

BOOST_AUTO_TEST_CASE(pixels_are_filled_in_between_those_of_their_own_lens)
{
    for (const Arrangement arrangement : {Arrangement::lenticular, Arrangement::square,
                                          Arrangement::hexagonal}) {
        Frame draft = draft_of_lenses(arrangement);
        for (int y = 0; y < 36; ++y)
            for (int x = 0; x < 48; ++x) {
                const float light = light_of(place_of(*draft.metadata, x, y));
                store_pixel(draft.image, x, y, {light, 0.5f * light, 0.25f * light});
            }
        BOOST_TEST_REQUIRE(is_draft(draft));
        const auto finer = with_final_pixels(draft);
        BOOST_TEST_REQUIRE(finer.has_value());
        BOOST_TEST(!is_draft(*finer));
        BOOST_TEST(finer->image.width == 144);
        BOOST_TEST(size_of(finer->metadata->film).x == size_of(draft.metadata->film).x,
                   boost::test_tools::tolerance(1e-12));
        int between = 0;
        // At the film's upper and lower edge a hexagonal lens's corner may have no draft pixel.
        for (int y = 3; y < 105; ++y)
            for (int x = 0; x < 144; ++x) {
                const Place place = place_of(*finer->metadata, x, y);
                const Colour colour = stored_pixel(finer->image, x, y);
                const double light = colour.r, expected = light_of(place);
                BOOST_TEST(std::fabs(colour.g - 0.5 * light) < 1e-6);
                BOOST_TEST(std::fabs(colour.b - 0.25 * light) < 1e-6);
                // At a lens's edge the light of its outermost pixels continues; other lenses' light
                // differs by at least 0.4.
                BOOST_TEST(std::fabs(light - expected) < 0.1 * 0.7,
                           "pixel " << x << ", " << y << " of arrangement " << int(arrangement)
                                    << " has " << light << ", its lens " << expected);
                // Two draft pixels inside the edge, both neighbours belong to the lens.
                const bool inside = std::fabs(place.from_pole.x) < 0.35 &&
                                    (arrangement == Arrangement::lenticular ||
                                     std::fabs(place.from_pole.y) < 0.2);
                if (inside && x > 2 && x < 141) {
                    BOOST_TEST(std::fabs(light - expected) < 1e-6);
                    ++between;
                }
            }
        BOOST_TEST(between > 1000);
    }
}

BOOST_AUTO_TEST_CASE(a_final_frame_is_no_draft)
{
    Frame frame = draft_of_lenses(Arrangement::lenticular);
    frame.metadata->render->draft = 1;
    BOOST_TEST(!is_draft(frame));
    frame.metadata->render.reset();
    BOOST_TEST(!is_draft(frame));
    frame.metadata.reset();
    BOOST_TEST(!is_draft(frame));
}

BOOST_AUTO_TEST_SUITE_END()
