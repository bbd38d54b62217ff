// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests which rows the passes of anti-aliasing work on.
#include "integral/reconstruction/pass_rows.h"
#include "tests/unit/pixel_origins.h"

using namespace pixel_origins;

namespace {

constexpr int height = 960; // of the picture

/// 15 pixels a lens.
CameraParameters sheet(Arrangement arrangement, double slant = 0)
{
    CameraParameters p = parameters_of(arrangement);
    p.film.pixel_pitch = {25.4 / 300, 25.4 / 300};
    p.sheet.slant = slant;
    return p;
}

/// The first row that is set, and the one after the last.
std::pair<int, int> range_of(const std::vector<bool>& rows)
{
    const auto first = std::find(rows.begin(), rows.end(), true);
    const auto last = std::find(rows.rbegin(), rows.rend(), true);
    return {int(first - rows.begin()), int(rows.rend() - last)};
}

} // namespace

BOOST_AUTO_TEST_SUITE(reconstruction_pass_rows)

// Strips of a frame are cut by sampled_from(), and rendered by passes().
BOOST_AUTO_TEST_CASE(passes_reach_as_far_as_is_told)
{
    constexpr int top = 480;
    for (const CameraParameters& p :
         {sheet(Arrangement::square), sheet(Arrangement::hexagonal, 7),
          sheet(Arrangement::lenticular), sheet(Arrangement::lenticular, 60)})
        for (const bool reconstructs : {false, true})
            for (const int side : {4, 8, 32}) {
                const PassRows rows(p.sheet, camera_of(p, 960, height).film, side, reconstructs);
                std::vector<bool> counting(height);
                std::fill(counting.begin() + top, counting.begin() + top + side, true);
                const auto passes = rows.passes(counting, counting);
                BOOST_TEST_REQUIRE(passes.size() == (reconstructs ? 5u : 3u));
                const auto expect = [&](std::size_t pass, int reach) {
                    const auto [first, end] = range_of(passes[pass].rows);
                    BOOST_TEST(top - first == reach);
                    BOOST_TEST(end - (top + side) == reach);
                };
                expect(0, rows.sampled_from());
                expect(1, rows.refined_from());
                expect(passes.size() - 1, 0);
                BOOST_TEST(rows.sampled_from() == rows.refined_from() + passes[1].reach);
                // The rows that a pass needs from the previous pass are present.
                int needs = 0;
                for (std::size_t pass = passes.size() - 1; pass > 0; --pass) {
                    needs += passes[pass].reach;
                    BOOST_TEST(top - range_of(passes[pass - 1].rows).first >= needs);
                }
            }
}

// The figures of doc/cluster.md.
BOOST_AUTO_TEST_CASE(margins_of_strips)
{
    const auto reach = [](const CameraParameters& p, int side) {
        const PassRows rows(p.sheet, camera_of(p, 960, height).film, side, true);
        return std::pair<int, int>(rows.refined_from(), rows.refine_margin());
    };
    BOOST_TEST((reach(sheet(Arrangement::square), 32) == std::pair(64, 15)));
    BOOST_TEST((reach(sheet(Arrangement::lenticular), 32) == std::pair(64, 1)));
    BOOST_TEST((reach(sheet(Arrangement::lenticular), 8) == std::pair(16, 1)));
}

BOOST_AUTO_TEST_SUITE_END()
