// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the depth inside photographs: both formats of distances, and parts of XMP in any order.
#include "integral/io/embedded_depth.h"

#include "integral/io/codecs.h"
#include "integral/io/markup.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace integral;
using namespace std::string_literals;

BOOST_AUTO_TEST_SUITE(io_embedded_depth)

namespace {

std::string big_endian(std::size_t value, int bytes)
{
    std::string text;
    for (int k = bytes; k-- > 0;)
        text += char(value >> 8 * k & 255);
    return text;
}

std::string segment(const std::string& content)
{
    return "\xff\xe1" + big_endian(content.size() + 2, 2) + content;
}

std::string xmp(const std::string& text)
{
    return segment("http://ns.adobe.com/xap/1.0/\0"s + text);
}

std::string extension(const std::string& whole, std::size_t begin, std::size_t count)
{
    return segment("http://ns.adobe.com/xmp/extension/\0"s + std::string(32, 'g') +
                   big_endian(whole.size(), 4) + big_endian(begin, 4) + whole.substr(begin, count));
}

/// A JPEG of 8 x 4 pixels with these segments.
std::string photograph(const std::string& segments)
{
    const std::string jpeg = encode_jpeg(make_image<std::uint8_t>(8, 4, 3, {}), 90);
    return jpeg.substr(0, 2) + segments + jpeg.substr(2);
}

/// A PNG of 4 x 1 greys.
std::string ramp()
{
    DecodedImage picture{make_image<std::uint8_t>(4, 1, 3, {}), "", std::nullopt};
    for (int x = 0; x < 4; ++x) {
        const float grey = float(x) / 3;
        store_pixel(picture.image, x, 0, {grey, grey, grey, 1});
    }
    return encode_png(picture);
}

std::string gdepth(const std::string& format)
{
    return "<rdf:Description GDepth:Format=\"" + format +
           "\" GDepth:Near=\"2\" GDepth:Far=\"8\" GDepth:Data=\"" + base64(ramp()) + "\"/>";
}

/// Checks the nearness of four greys from 0 to 1.
void check_nearness(const std::string& bytes, double (*of)(double grey))
{
    const auto depth = depth_in_jpeg(bytes);
    BOOST_REQUIRE(depth.has_value());
    BOOST_TEST(depth->width == 4);
    for (int x = 0; x < 4; ++x)
        BOOST_TEST(std::fabs(stored_pixel(*depth, x, 0).g - of(x / 3.0)) < 1e-3, x);
}

double inverse(double grey) { return 1 - grey; }
/// Of a distance from 2 to 8: (1/d - 1/8)/(1/2 - 1/8).
double linear(double grey) { return (1 / (2 + 6 * grey) - 0.125) / 0.375; }

} // namespace

BOOST_AUTO_TEST_CASE(formats_of_distances)
{
    check_nearness(photograph(xmp(gdepth("RangeInverse"))), inverse);
    check_nearness(photograph(xmp(gdepth("RangeLinear"))), linear);
}

BOOST_AUTO_TEST_CASE(an_extension_in_parts)
{
    const std::string whole = gdepth("RangeLinear");
    const std::size_t half = whole.size() / 2;
    check_nearness(photograph(xmp("<rdf:Description/>") + extension(whole, half, whole.size()) +
                              extension(whole, 0, half)),
                   linear);
}

BOOST_AUTO_TEST_CASE(a_picture_behind_the_photograph)
{
    const std::string depth = ramp(), video = "video";
    const auto item = [](const std::string& semantic, std::size_t length) {
        return "<Container:Item Item:Mime=\"image/png\" Item:Semantic=\"" + semantic +
               "\" Item:Length=\"" + std::to_string(length) + "\"/>";
    };
    const std::string list = "<DepthMap:Format>RangeInverse</DepthMap:Format>" +
                             item("Primary", 0) + item("Depth", depth.size()) +
                             item("MotionPhoto", video.size());
    check_nearness(photograph(xmp(list)) + depth + video, inverse);
    // The video's length is wrong, or is missing from the file: no matter, if no depth is listed.
    for (const std::string& wrong :
         {item("MotionPhoto", 1000000), "<A Item:Mime='' Item:Length='-1'/>"s})
        BOOST_TEST(!depth_in_jpeg(photograph(xmp(item("Primary", 0) + wrong))).has_value());
    const std::string stripped = item("Primary", 0) + item("Depth", 9) +
                                 item("MotionPhoto", 1000000);
    BOOST_CHECK_THROW(depth_in_jpeg(photograph(xmp(stripped))), std::runtime_error);
    const std::string long_list = item("Primary", 0) + item("Depth", 1000000);
    BOOST_CHECK_THROW(depth_in_jpeg(photograph(xmp(long_list)) + depth), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(line_ends_in_the_text)
{
    const std::string whole = gdepth("RangeLinear");
    const std::size_t middle = whole.find("GDepth:Data") + 40;
    for (const std::string& end : {"\n"s, "&#10;"s, "&#xA;"s, "&#13;&#10;"s})
        check_nearness(photograph(xmp(whole.substr(0, middle) + end + whole.substr(middle))),
                       linear);
}

BOOST_AUTO_TEST_CASE(hostile_lists_of_parts)
{
    const auto repeated = [](const std::string& tag, int count) {
        std::string list;
        for (int k = 0; k < count; ++k)
            list += tag;
        return list;
    };
    const std::string depth = "<A Item:Mime=\"a\" Item:Semantic=\"Depth\" Item:Length=\"1\"/>";
    for (const std::string& list :
         {repeated("<Item:Mime", 20000), repeated("Item:Mime>", 20000), repeated(depth, 1000)}) {
        std::string segments;
        const std::size_t part = 60000;
        for (std::size_t k = 0; k < list.size(); k += part)
            segments += extension(list, k, part);
        BOOST_TEST(!depth_in_jpeg(photograph(segments)).has_value());
    }
}

BOOST_AUTO_TEST_CASE(files_without_depth)
{
    BOOST_TEST(!depth_in_jpeg("").has_value());
    BOOST_TEST(!depth_in_jpeg(ramp()).has_value());
    BOOST_TEST(!depth_in_jpeg(photograph("")).has_value());
    BOOST_TEST(!depth_in_jpeg(photograph(xmp("<rdf:Description GDepth:Near=\"2\"/>"))).has_value());
    const std::string beyond = segment("http://ns.adobe.com/xmp/extension/\0"s +
                                       std::string(32, 'g') + big_endian(5, 4) + big_endian(3, 4) +
                                       "abc"); // at 3 of 5 bytes
    BOOST_TEST(!depth_in_jpeg(photograph(beyond)).has_value());
    const std::string other = extension("another", 0, 7), whole = gdepth("RangeLinear");
    for (const std::string& damaged : {beyond, other + extension(whole, 0, whole.size())})
        BOOST_CHECK_THROW(
            depth_in_jpeg(photograph(xmp("<rdf:Description GDepth:Near=\"2\"/>") + damaged)),
            std::runtime_error);
}

BOOST_AUTO_TEST_SUITE_END()
