// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests which pictures a display shows and which are refused, and pictures decoded ahead of time.
// tests/cli/lcd_show.test uses real displays.
#include "integral/base/file_bytes.h"
#include "integral/screen/screen_picture.h"
#include "integral/screen/screens.h"

#include <boost/test/unit_test.hpp>

#include <atomic>
#include <chrono>
#include <random>

using namespace integral;

BOOST_AUTO_TEST_SUITE(screen_displays)

namespace {

XOutput panel()
{
    XOutput output;
    output.name = "HDMI-1";
    output.width = output.mode_width = output.preferred_width = 3840;
    output.height = output.mode_height = output.preferred_height = 2160;
    return output;
}

std::string refusal(const std::vector<Screen>& screens, const std::string& requested, int width,
                    int height)
{
    try {
        choose_screen(screens, requested, "p.png", width, height);
    } catch (const OutputError& error) {
        return error.what();
    }
    return "";
}

/// Waits for threads.
template <class Condition> void wait_for(Condition condition)
{
    while (!condition())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

ScreenPicture numbered_picture(long long number) { return {1, 1, {std::uint32_t(number)}}; }

/// Takes the pictures 0 to `count` - 1 of a loop of 30, each when it is due; none may be missing.
void take_in_order(PicturesAhead& pictures, int count)
{
    for (int k = 0; k < count; ++k) {
        std::optional<PicturesAhead::Ready> ready;
        wait_for([&] { return (ready = pictures.take(k)).has_value(); });
        BOOST_REQUIRE_EQUAL(ready->number, k);
        BOOST_REQUIRE_EQUAL(ready->picture->pixels[0], unsigned(k % 30));
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(what_scales_is_found)
{
    BOOST_TEST(why_scaled(panel()) == "");
    XOutput output = panel();
    output.preferred_width = output.preferred_height = 0; // native resolution unknown
    BOOST_TEST(why_scaled(output) == "");
    output = panel();
    output.transformed = true;
    BOOST_TEST(why_scaled(output).find("resampled") != std::string::npos);
    output = panel();
    output.width = 5760, output.height = 3240; // xrandr --scale 1.5x1.5
    BOOST_TEST(why_scaled(output).find("5760x3240 pixels of the desktop are resampled to its "
                                       "3840x2160; xrandr --output HDMI-1 --scale 1x1") == 0u);
    output = panel();
    output.width = output.mode_width = 1920, output.height = output.mode_height = 1080;
    BOOST_TEST(why_scaled(output).find("it is sent 1920x1080 pixels and has itself 3840x2160; "
                                       "xrandr --output HDMI-1 --preferred") == 0u);
}

BOOST_AUTO_TEST_CASE(displays_are_chosen)
{
    const std::vector<Screen> screens = {{0, "eDP-1", 0, 0, 1920, 1080, 60, ""},
                                         {1, "HDMI-1", 1920, 0, 3840, 2160, 60, ""},
                                         {2, "HDMI-2", 5760, 0, 1920, 1080, 60, ""},
                                         {3, "DP-1", 7680, 0, 800, 600, 60, "it is scaled; so"}};
    BOOST_TEST(choose_screen(screens, "2", "p.png", 3840, 2160) == 1u);
    BOOST_TEST(choose_screen(screens, "HDMI-1", "p.png", 3840, 2160) == 1u);
    BOOST_TEST(choose_screen(screens, "auto", "p.png", 3840, 2160) == 1u);
    BOOST_TEST(choose_screen(screens, "3", "p.png", 1920, 1080) == 2u);
    BOOST_TEST(refusal(screens, "auto", 1920, 1080)
                   .find("p.png: 1920x1080 pixels fit 2 displays; --show NUMBER says which") == 0u);
    BOOST_TEST(
        refusal(screens, "auto", 1920, 1081).find("p.png: 1920x1081 pixels fit no display") == 0u);
    BOOST_TEST(refusal(screens, "1", 1919, 1080)
                   .find("p.png: 1919x1080 pixels, but display 1 (eDP-1) has 1920x1080") == 0u);
    BOOST_TEST(refusal(screens, "1", 1080, 1920) != "");
    BOOST_TEST(refusal(screens, "5", 800, 600)
                   .find("5: there is no such display; there is display 1 (eDP-1) 1920x1080, ") ==
               0u);
    BOOST_TEST(refusal(screens, "0", 800, 600) != "");
    BOOST_TEST(refusal(screens, "", 800, 600) != "");
    BOOST_TEST(refusal(screens, "4", 800, 600) == "display 4 (DP-1): it is scaled; so");
}

BOOST_AUTO_TEST_CASE(samples_reach_the_display_as_they_are)
{
    for (const Encoding encoding : {Encoding{}, Encoding{Encoding::Kind::power, 2.2}}) {
        Image image = make_image<std::uint8_t>(16, 16, 3, encoding),
              opaque = make_image<std::uint8_t>(16, 16, 4, encoding);
        Image deep = make_image<std::uint16_t>(16, 16, 3, encoding);
        for (int k = 0; k < 256; ++k)
            for (int c = 0; c < 4; ++c) {
                const int value = c == 3 ? 255 : (k * (2 * c + 1) + c) % 256;
                std::get<std::vector<std::uint8_t>>(
                    opaque.samples)[std::size_t(4 * k + c)] = std::uint8_t(value);
                if (c == 3)
                    continue;
                std::get<std::vector<std::uint8_t>>(
                    image.samples)[std::size_t(3 * k + c)] = std::uint8_t(value);
                std::get<std::vector<std::uint16_t>>(deep.samples)[std::size_t(
                    3 * k + c)] = std::uint16_t(std::clamp(257 * value + 128 * (k % 2 ? 1 : -1), 0,
                                                           65535));
            }
        const ScreenPicture shown = screen_picture(image);
        BOOST_TEST(shown.width == 16);
        for (int k = 0; k < 256; ++k)
            BOOST_REQUIRE_EQUAL(shown.pixels[std::size_t(k)],
                                0xff000000u + unsigned(k) * 65536 +
                                    unsigned((k * 3 + 1) % 256) * 256 +
                                    unsigned((k * 5 + 2) % 256));
        BOOST_TEST((screen_picture(opaque).pixels == shown.pixels));
        BOOST_TEST((screen_picture(deep).pixels == shown.pixels));
    }
}

BOOST_AUTO_TEST_CASE(linear_light_becomes_srgb_and_clear_becomes_black)
{
    Image linear = make_image<float>(2, 1, 4, Encoding{Encoding::Kind::linear, 1});
    linear.samples = std::vector<float>{0.5f, 1, 2, 1, 0.25f, 0.25f, 0.25f, 0.5f};
    linear.premultiplied = true;
    const ScreenPicture shown = screen_picture(linear);
    BOOST_TEST(shown.pixels[0] == 0xffbcffffu); // sRGB of 0.5 is 187.5
    BOOST_TEST(shown.pixels[1] == 0xff898989u); // 0.25 is 137.0: alpha has been multiplied already
    Image clear = make_image<std::uint8_t>(1, 1, 4, Encoding());
    clear.samples = std::vector<std::uint8_t>{255, 255, 255, 0};
    BOOST_TEST(screen_picture(clear).pixels[0] == 0xff000000u);
}

BOOST_AUTO_TEST_CASE(every_picture_is_taken_once_and_in_order)
{
    for (const int keep : {2, 5, 40})
        for (const bool loop : {false, true}) {
            std::atomic<int> loads{0}, inside{0}, most_inside{0};
            PicturesAhead pictures(
                {30, loop, keep, 3, [&](long long file) {
                     ++loads;
                     const int now = ++inside;
                     int most = most_inside;
                     while (most < now && !most_inside.compare_exchange_weak(most, now)) {
                     }
                     std::this_thread::sleep_for(std::chrono::microseconds(50 * (file % 3)));
                     --inside;
                     return numbered_picture(file);
                 }});
            wait_for([&] { return pictures.is_full(); });
            BOOST_TEST(loads == std::min(keep, 30));
            const int requested = loop ? 75 : 30;
            take_in_order(pictures, requested);
            BOOST_TEST(!pictures.take(requested - 1));
            BOOST_TEST(most_inside <= keep);
            if (keep >= 30)
                BOOST_TEST(loads == 30); // a loop that fits decodes nothing twice
        }
}

BOOST_AUTO_TEST_CASE(a_loop_waits_for_a_picture_that_is_being_decoded)
{
    std::atomic<int> loads{0};
    PicturesAhead pictures({3, true, 5, 2, [&](long long file) {
                                ++loads;
                                if (file == 0) { // until the other thread is round the loop
                                    wait_for([&] { return loads >= 3; });
                                    std::this_thread::sleep_for(std::chrono::milliseconds(20));
                                }
                                return numbered_picture(file);
                            }});
    wait_for([&] { return pictures.is_full(); });
    BOOST_TEST(loads == 3);
    for (int k = 0; k < 7; ++k) {
        std::optional<PicturesAhead::Ready> ready;
        wait_for([&] { return (ready = pictures.take(k)).has_value(); });
        BOOST_TEST(ready->picture->pixels[0] == unsigned(k % 3));
    }
    BOOST_TEST(loads == 3);
}

BOOST_AUTO_TEST_CASE(late_pictures_are_skipped)
{
    std::atomic<int> loads{0};
    PicturesAhead pictures({1000, false, 4, 2, [&](long long file) {
                                ++loads;
                                return numbered_picture(file);
                            }});
    wait_for([&] { return pictures.is_full(); });
    BOOST_TEST(pictures.take(2)->number == 2); // the newest picture that is due
    BOOST_TEST(!pictures.take(2));
    wait_for([&] { return pictures.is_full(); });
    const int before = loads;
    // Takes the newest that is ready; from now on, nothing older than 500 is decoded.
    auto ready = pictures.take(500);
    BOOST_REQUIRE(ready);
    BOOST_TEST(ready->number < 10);
    wait_for([&] { return (ready = pictures.take(500)).has_value(); });
    BOOST_TEST(ready->number == 500);
    wait_for([&] { return pictures.is_full(); });
    BOOST_TEST(loads <= before + 8);
}

/// A source of `count` pictures that can only be read in order. `place`: the next file.
PicturesAhead::Source in_order(long long count, bool loop, int keep, std::atomic<long long>& place,
                               std::atomic<int>& finished)
{
    PicturesAhead::Source source;
    source.loop = loop;
    source.keep = keep;
    source.threads = 3;
    source.read = [&, count](long long file) -> PicturesAhead::Completion {
        if (file == 0)
            place = 0;
        if (file != place)
            throw InputError(std::to_string(file) + " is read out of order");
        std::this_thread::sleep_for(std::chrono::microseconds(50));
        if (file == count)
            return {};
        ++place;
        return [&finished, file] {
            std::this_thread::sleep_for(std::chrono::microseconds(50 * (file % 3)));
            ++finished;
            return numbered_picture(file);
        };
    };
    return source;
}

BOOST_AUTO_TEST_CASE(a_video_is_read_in_order_to_its_end)
{
    for (const int keep : {2, 5, 40})
        for (const bool loop : {false, true}) {
            std::atomic<long long> place{0};
            std::atomic<int> finished{0};
            PicturesAhead pictures(in_order(30, loop, keep, place, finished));
            wait_for([&] { return pictures.is_full(); });
            BOOST_TEST(finished == (loop ? keep : std::min(keep, 30)));
            if (keep < 30)
                BOOST_TEST(pictures.count() > 30); // the end is not found yet
            const int requested = loop ? 75 : 30;
            take_in_order(pictures, requested);
            wait_for([&] { return pictures.count() == 30; });
        }
}

BOOST_AUTO_TEST_CASE(late_pictures_of_a_video_are_read_but_not_finished)
{
    std::atomic<long long> place{0};
    std::atomic<int> finished{0};
    PicturesAhead pictures(in_order(300, false, 4, place, finished));
    wait_for([&] { return pictures.is_full(); });
    pictures.take(200);
    std::optional<PicturesAhead::Ready> ready;
    wait_for([&] { return (ready = pictures.take(200)).has_value(); });
    BOOST_TEST(ready->number == 200);
    wait_for([&] { return pictures.is_full(); });
    BOOST_TEST(finished <= 4 + 8);
    pictures.take(1000); // past the end, which is found
    wait_for([&] { return pictures.count() == 300; });
}

BOOST_AUTO_TEST_CASE(a_failure_to_decode_arrives)
{
    PicturesAhead pictures({10, false, 4, 2, [&](long long file) {
                                if (file == 3)
                                    throw InputError("3.png: it cannot be read");
                                return numbered_picture(file);
                            }});
    BOOST_CHECK_THROW(wait_for([&] { return pictures.is_full(); }), InputError);
    BOOST_CHECK_THROW(pictures.take(0), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
