// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests which medium a page fits, and the page's position on it. The media are from Gutenprint's
// drivers.
#include "integral/print/print_media.h"
#include "integral/print/spool.h"

#include <boost/test/unit_test.hpp>

#include <stdexcept>

using namespace integral;

BOOST_AUTO_TEST_SUITE(print_media)

namespace {

PrintMedium medium(const char* name, const char* label, SizeMm sheet, SizeMm printable)
{
    return {name, label, sheet, printable, {}};
}

/// Media of a DNP DS620: 2x6 and 4x6 have the same sheet; 4x6 and 2x6*2 have the same printable
/// area.
const std::vector<PrintMedium> ds620 = {
    medium("B7", "3.5x5", {92.12, 162.56}, {92.12, 131.06}),
    medium("w144h432", "2x6", {104.99, 162.56}, {52.49, 156.13}),
    medium("w288h432-div2", "2x6*2", {104.99, 162.56}, {104.99, 156.13}),
    medium("w288h432", "4x6", {104.99, 162.56}, {104.99, 156.13}),
    medium("w432h432", "6x6", {155.45, 162.56}, {155.45, 156.13}),
};

std::string placed(SizeMm page, const std::string& name = "")
{
    const std::optional<PagePlace> place = place_page(ds620, page, name);
    return place ? ds620[place->medium].name + (place->turned ? " turned" : "") : "none";
}

/// 8-bit RGB; every sample differs from its neighbours.
Image counted(int width, int height)
{
    Image page = make_image<std::uint8_t>(width, height, 3, Encoding());
    int value = 0;
    for (std::uint8_t& sample : std::get<std::vector<std::uint8_t>>(page.samples))
        sample = std::uint8_t(value++ % 250);
    return page;
}

const std::vector<std::uint8_t>& samples(const Image& image)
{
    return std::get<std::vector<std::uint8_t>>(image.samples);
}

} // namespace

BOOST_AUTO_TEST_CASE(nominal_sizes)
{
    const auto nominal = [](const char* name, const char* label) {
        return nominal_size(medium(name, label, {1, 2}, {1, 2}));
    };
    BOOST_TEST(nominal("w288h432", "4x6").width == 101.6, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(nominal("B7", "3.5x5").height == 127.0, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(nominal("Postcard", "Postcard 100x148mm").height == 148.0,
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(nominal("Index", "4 x 6\"").height == 152.4, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(nominal("A4", "A4").height == 2.0);
    BOOST_TEST(nominal("odd", "100x148").height == 2.0); // inches would be metres
    BOOST_TEST(nominal("odd", "0x0").height == 2.0);
    BOOST_TEST(nominal("", "").height == 2.0);
    BOOST_TEST(nominal_size({"A4", "A4", {216, 304.8}, {203.2, 304.8}, {210, 297}}).height ==
               297.0); // a Kodak 1400's
}

BOOST_AUTO_TEST_CASE(places)
{
    BOOST_TEST(placed({101.6, 152.4}) == "w288h432");
    BOOST_TEST(placed({101.6 + 0.49, 152.4 - 0.49}) == "w288h432");
    BOOST_TEST(placed({101.6 + 0.51, 152.4}) == "none");
    BOOST_TEST(placed({104.99, 156.13}) == "w288h432"); // all that is printable
    BOOST_TEST(placed({104.99, 162.56}) == "w288h432"); // largest printable area of three
    BOOST_TEST(placed({152.4, 101.6}) == "w288h432 turned");
    BOOST_TEST(placed({152.4, 152.4}) == "w432h432");
    BOOST_TEST(placed({101.6, 152.4}, "w288h432-div2") == "w288h432-div2");
    BOOST_TEST(placed({101.6, 152.4}, "w144h432") == "none"); // its own size is another
    BOOST_TEST(placed({101.6, 152.4}, "A4") == "none");
    BOOST_TEST(!place_page({}, {101.6, 152.4}));
}

BOOST_AUTO_TEST_CASE(words)
{
    BOOST_TEST(media_in_words({ds620[0], ds620[3]}) ==
               "3.5x5 (88.9 x 127.0 mm, B7), 4x6 (101.6 x 152.4 mm, w288h432)");
    BOOST_TEST(media_in_words({}) == "none");
}

BOOST_AUTO_TEST_CASE(turns)
{
    const Image page = counted(5, 3);
    const Image turned = turned_page(page);
    BOOST_TEST(turned.width == 3);
    BOOST_TEST(turned.height == 5);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x)
            BOOST_TEST(stored_pixel(turned, 2 - y, x).g == stored_pixel(page, x, y).g);
    const Image back = turned_page(turned_page(turned_page(turned)));
    BOOST_TEST(samples(back) == samples(page), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(centres)
{
    const Image page = counted(5, 3);
    const std::optional<Image> wide = centred_page(page, 8, 4); // left 1, top 0; odd pixels after
    BOOST_REQUIRE(wide.has_value());
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) {
            const bool inside = x >= 1 && x < 6 && y < 3;
            BOOST_TEST(stored_pixel(*wide, x, y).r ==
                       (inside ? stored_pixel(page, x - 1, y).r : 1.f));
        }
    BOOST_TEST(samples(*centred_page(page, 5, 3)) == samples(page),
               boost::test_tools::per_element());

    // For smaller areas, only white margins are cut off: from any larger page with this one in its
    // middle, the same page results.
    for (int width : {5, 7, 9})
        for (int height : {3, 5, 7})
            BOOST_TEST(samples(*centred_page(*centred_page(page, width, height), 5, 3)) ==
                           samples(page),
                       boost::test_tools::per_element());
    BOOST_TEST(!centred_page(page, 4, 3));
    BOOST_TEST(!centred_page(page, 5, 2));
    BOOST_TEST(!centred_page(page, 3, 9));
    BOOST_TEST(!centred_page(page, 9, 1));
}

BOOST_AUTO_TEST_CASE(jobs_that_make_no_sense)
{
    if (!can_spool())
        return;
    SpoolJob job;
    BOOST_CHECK_THROW(spool(job), std::invalid_argument);
    job.pages = {counted(5, 3)};
    job.copies = 0;
    BOOST_CHECK_THROW(spool(job), std::invalid_argument);
    job.copies = 1;
    job.pages.push_back(counted(3, 5));
    BOOST_CHECK_THROW(spool(job), std::invalid_argument);
    job.pages = {make_image<std::uint16_t>(5, 3, 3, Encoding())};
    BOOST_CHECK_THROW(spool(job), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
