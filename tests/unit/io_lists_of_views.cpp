// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests files that hold several pictures: layers, parts and views of OpenEXR, and indices of MPO.
#include "integral/base/memory.h"
#include "integral/base/notices.h"
#include "integral/io/codecs.h"
#include "integral/io/image_file.h"
#include "integral/io/mpo_file.h"
#include "integral/views/view_input.h"
#include "tests/unit/picture_files.h"

#include <boost/test/unit_test.hpp>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>

using namespace picture_files;
using namespace std::string_literals;

BOOST_AUTO_TEST_SUITE(io_lists_of_views)

namespace {

/// A channel, and the value that all its pixels have.
struct Channel {
    std::string name;
    float value;
};

/// A part of an OpenEXR file: its name, its view and its channels.
struct Part {
    std::string name, view;
    std::vector<Channel> channels;
};

constexpr int side = 3;

Imf::FrameBuffer source_of(const Part& part, Imf::Header& header, std::vector<float>& values)
{
    Imf::FrameBuffer source;
    values.clear();
    for (const Channel& channel : part.channels)
        values.insert(values.end(), side * side, channel.value);
    std::size_t begin = 0;
    for (const Channel& channel : part.channels) {
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
        source.insert(channel.name,
                      Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&values[begin]), 4, 4 * side));
        begin += side * side;
    }
    return source;
}

/// Writes a file of one part, whose channels name these views, if any.
void write_exr(const std::string& path, const std::vector<Channel>& channels,
               const std::vector<std::string>& views = {})
{
    Imf::Header header(side, side);
    std::vector<float> values;
    const Imf::FrameBuffer source = source_of({"", "", channels}, header, values);
    if (!views.empty())
        Imf::addMultiView(header, views);
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(source);
    file.writePixels(side);
}

void write_parts(const std::string& path, const std::vector<Part>& parts)
{
    std::vector<Imf::Header> headers;
    std::vector<std::vector<float>> values(parts.size());
    std::vector<Imf::FrameBuffer> sources;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        Imf::Header header(side, side);
        sources.push_back(source_of(parts[k], header, values[k]));
        header.setName(parts[k].name);
        header.setType(Imf::SCANLINEIMAGE);
        if (!parts[k].view.empty())
            header.setView(parts[k].view);
        headers.push_back(header);
    }
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), int(headers.size()));
    for (std::size_t k = 0; k < parts.size(); ++k) {
        Imf::OutputPart part(file, int(k));
        part.setFrameBuffer(sources[k]);
        part.writePixels(side);
    }
}

std::vector<Channel> colours(const std::string& layer, float first)
{
    return {{layer + "R", first}, {layer + "G", first + 1}, {layer + "B", first + 2}};
}

template <class Item> std::vector<Item> joined(std::vector<Item> a, const std::vector<Item>& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// The first red sample of a picture, and the notices about it.
struct Result {
    float red = 0;
    std::vector<std::string> notices;
};

Result result_of(const std::string& path)
{
    const std::string bytes = bytes_of(path);
    const InputFile file = InputFile::of_bytes(bytes);
    const auto reader = read_any(file);
    const Image image = whole_picture(*reader).image;
    const Colour c = stored_pixel(image, 1, 1);
    BOOST_TEST(c.g == c.r + 1);
    BOOST_TEST(c.b == c.r + 2);
    return {c.r, reader->take_notices()};
}

std::string refusal(const std::string& path)
{
    try {
        read_frame(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// The first red sample of each view in a file.
std::vector<float> reds_of(const std::string& path)
{
    std::vector<float> reds;
    for (const Image& image : read_list_of_views(path))
        reds.push_back(stored_pixel(image, 0, 0).r);
    return reds;
}

std::string u32(std::size_t v) { return {char(v >> 24), char(v >> 16), char(v >> 8), char(v)}; }

} // namespace

BOOST_AUTO_TEST_CASE(the_obvious_layer_is_read)
{
    const Folder folder;
    const std::string path = folder / "a.exr";
    write_exr(path, joined(colours("glow.", 5), colours("", 1)));
    BOOST_TEST(result_of(path).red == 1); // channels without a layer come first
    BOOST_TEST(result_of(path).notices.empty());

    write_exr(path, joined(colours("light.", 5), {{"depth.Z", 9}}));
    BOOST_TEST(result_of(path).red == 5);
    BOOST_REQUIRE(result_of(path).notices.size() == 1u);
    BOOST_TEST(result_of(path).notices[0].find("its layer light is read") != std::string::npos);

    write_exr(path, joined(colours("View.Combined.", 7), colours("View.Diffuse.", 3)));
    BOOST_TEST(result_of(path).red == 7);
}

BOOST_AUTO_TEST_CASE(layers_of_equal_rank_are_listed)
{
    const Folder folder;
    const std::string path = folder / "a.exr";
    write_exr(path, joined(colours("diffuse.", 5), colours("glossy.", 1)));
    const std::string why = refusal(path);
    BOOST_TEST(why.find("layers: diffuse, glossy;") != std::string::npos, why);
    write_exr(path, {{"Z", 1}});
    BOOST_TEST(refusal(path).find("no channels R, G and B") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(other_parts_are_said)
{
    const Folder folder;
    const std::string path = folder / "a.exr";
    write_parts(
        path,
        {{"depth", "", {{"Z", 4}}}, {"beauty", "", colours("", 2)}, {"glow", "", colours("", 6)}});
    BOOST_TEST(result_of(path).red == 2);
    BOOST_REQUIRE(result_of(path).notices.size() == 1u);
    BOOST_TEST(result_of(path).notices[0].find("further parts: glow") != std::string::npos);
    BOOST_TEST(!is_list_of_views(path));
}

BOOST_AUTO_TEST_CASE(stereo_pictures_are_views)
{
    const Folder folder;
    const std::string path = folder / "a.exr";
    const std::vector<float> left_right = {1, 5};
    write_parts(path, {{"r", "right", colours("", 5)}, {"l", "left", colours("", 1)}});
    BOOST_TEST(is_list_of_views(path));
    BOOST_TEST(reds_of(path) == left_right, boost::test_tools::per_element());

    write_exr(path, joined(colours("", 5), colours("left.", 1)), {"right", "left"});
    BOOST_TEST(reds_of(path) == left_right, boost::test_tools::per_element());
    BOOST_TEST(result_of(path).red == 1);
    BOOST_REQUIRE(result_of(path).notices.size() == 1u);
    BOOST_TEST(result_of(path).notices[0] == "it holds 2 views; left is read");

    std::vector<std::string> lines;
    receive_notices([&](const std::string& line) { lines.push_back(line); });
    const ViewInput given = read_given_views({path}, {});
    receive_notices({});
    BOOST_TEST(given.grid.columns == 2);
    BOOST_TEST(given.grid.rows == 1);
    BOOST_TEST(stored_pixel(given.views[1], 2, 2).b == 7.0f);
    BOOST_TEST(lines.empty()); // nothing is left out
}

BOOST_AUTO_TEST_CASE(three_views_keep_the_order_of_the_file)
{
    const Folder folder;
    const std::string path = folder / "a.exr";
    write_exr(path, joined(joined(colours("c.", 5), colours("", 1)), colours("b.", 3)),
              {"z", "c", "b"});
    const std::vector<float> requested = {1, 5, 3};
    BOOST_TEST(reds_of(path) == requested, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(an_index_that_repeats_a_picture)
{
    const Folder folder;
    const std::string path = folder / "a.mpo";
    const Image one = noise<std::uint8_t>(8, 8, 3, Encoding());
    std::string mpo = mpo_of_views({one, one, one}, 90, 60);
    write_bytes(path, mpo);
    BOOST_TEST(read_list_of_views(path).size() == 3u);
    // The third entry's offset becomes the second's.
    const auto entries = mpo.find("\x20\x02\x00\x02"s);
    BOOST_REQUIRE(entries != std::string::npos);
    mpo.replace(entries + 40, 4, mpo.substr(entries + 24, 4));
    write_bytes(path, mpo);
    BOOST_CHECK_EXCEPTION(read_list_of_views(path), InputError, [](const InputError& error) {
        return std::string(error.what()).find("has a picture twice") != std::string::npos;
    });
}

BOOST_AUTO_TEST_CASE(an_index_has_a_limit)
{
    const Folder folder;
    const std::string path = folder / "a.mpo";
    std::string mpo = mpo_of_views({noise<std::uint8_t>(8, 8, 3, Encoding())}, 90, 60);
    const auto count = mpo.find("\xb0\x02\x00\x07"s) + 4;
    mpo.replace(count, 4, u32(16 * 257));
    write_bytes(path, mpo);
    BOOST_CHECK_EXCEPTION(read_list_of_views(path), InputError, [](const InputError& error) {
        return std::string(error.what()).find("more than 256 pictures") != std::string::npos;
    });
}

BOOST_AUTO_TEST_CASE(all_pictures_are_weighed_before_one_is_read)
{
    // Pictures with 30000 x 30000 pixels by their headers, more than fit in memory.
    constexpr double bytes = 30000.0 * 30000 * 3;
    const int count = int(std::min(free_memory() / bytes, 250.0)) + 2;
    const Folder folder;
    const std::string path = folder / "a.mpo";
    const Image one = noise<std::uint8_t>(750, 750, 3, Encoding());
    std::string mpo = mpo_of_views(std::vector<Image>(std::size_t(count), one), 100, 60);
    int headers = 0;
    for (auto at = mpo.find("\xff\xc0\0\x11\x08"s); at != std::string::npos;
         at = mpo.find("\xff\xc0\0\x11\x08"s, at + 9), ++headers)
        mpo.replace(at + 5, 4, "\x75\x30\x75\x30"s);
    BOOST_REQUIRE(headers == count);
    write_bytes(path, mpo);
    char sum[40];
    std::snprintf(sum, sizeof sum, "it needs %.3g GB of memory", count * bytes / 1e9);
    BOOST_CHECK_EXCEPTION(read_list_of_views(path), InputError, [&](const InputError& error) {
        return std::string(error.what()).find(sum) != std::string::npos;
    });
}

BOOST_AUTO_TEST_SUITE_END()
