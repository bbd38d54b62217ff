// SPDX-License-Identifier: AGPL-3.0-or-later
// OpenEXR: the document in a string attribute `integral`, the resolution in xDensity and
// pixelAspectRatio; samples are linear and premultiplied by alpha.
#include "integral/io/codecs.h"
#include "integral/io/exr_header.h"

#include "integral/optics/film.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace integral {
namespace {

constexpr char attribute[] = "integral";
constexpr double greatest_ratio = 2000; // ZIP reaches 1032, PIZ about 500
constexpr int largest_side = 1000000;

using Offset = decltype(std::declval<Imf::IStream&>().tellg()); // its name changed with OpenEXR 3

class ByteSource : public Imf::IStream {
public:
    explicit ByteSource(const std::string& bytes) : Imf::IStream("image"), bytes_(bytes) {}
    bool read(char data[], int count) override
    {
        if (count < 0 || position_ > bytes_.size() ||
            std::size_t(count) > bytes_.size() - position_)
            throw std::runtime_error("the file ends too early");
        std::memcpy(data, bytes_.data() + position_, std::size_t(count));
        position_ += std::size_t(count);
        return position_ < bytes_.size();
    }
    Offset tellg() override { return position_; }
    void seekg(Offset position) override { position_ = position; }

private:
    const std::string& bytes_;
    std::size_t position_ = 0;
};

class ByteSink : public Imf::OStream {
public:
    explicit ByteSink(std::string& bytes) : Imf::OStream("image"), bytes_(bytes) {}
    void write(const char data[], int count) override
    {
        const std::size_t end = position_ + std::size_t(count);
        if (end > bytes_.size())
            bytes_.resize(end);
        std::memcpy(&bytes_[position_], data, std::size_t(count));
        position_ = end;
    }
    Offset tellp() override { return position_; }
    void seekp(Offset position) override { position_ = position; }

private:
    std::string& bytes_;
    std::size_t position_ = 0;
};

/// Names of the file's channels that give R, G, B (a grey Y three times) and alpha.
std::vector<const char*> channel_names(const Imf::ChannelList& channels)
{
    std::vector<const char*> names;
    if (channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B"))
        names = {"R", "G", "B"};
    else if (channels.findChannel("Y") && !channels.findChannel("RY"))
        names = {"Y", "Y", "Y"};
    else
        throw std::runtime_error("it has no channels R, G and B");
    if (channels.findChannel("A"))
        names.push_back("A");
    for (const char* name : names) {
        const auto* channel = channels.findChannel(name);
        if (channel->xSampling != 1 || channel->ySampling != 1)
            throw std::runtime_error("its channels are subsampled");
    }
    return names;
}

/// The slice of one interleaved channel.
Imf::Slice slice(Image& image, int channel, const Imath::Box2i& window)
{
    auto& samples = std::get<std::vector<float>>(image.samples);
    const std::size_t step = sizeof(float) * std::size_t(image.channels);
    return Imf::Slice::Make(Imf::FLOAT, samples.data() + channel, window, step,
                            step * std::size_t(image.width));
}

int width_of(const Imath::Box2i& window) { return window.max.x - window.min.x + 1; }
int height_of(const Imath::Box2i& window) { return window.max.y - window.min.y + 1; }

/// As many rows as OpenEXR keeps of a picture of `height` rows: those of the picture, and of its first row of tiles.
double rows_kept(const Imf::Header& header, int height)
{
    return header.hasTileDescription() ? std::max(double(height), double(header.tileDescription().ySize)) : height;
}

std::string document_of(const Imf::Header& header)
{
    const auto* text = header.findTypedAttribute<Imf::StringAttribute>(attribute);
    return text ? text->value() : "";
}

DecodedImage decode_picture(const std::string& bytes)
{
    Imf::Header::setMaxImageSize(largest_side, largest_side);
    ByteSource source(bytes);
    Imf::InputFile file(source);
    const Imf::Header& header = file.header();
    const auto names = channel_names(header.channels());
    const Imath::Box2i window = header.dataWindow();
    const int width = width_of(window), height = height_of(window);
    const int channels = int(names.size());
    check_plausible_size(double(width) * rows_kept(header, height) * channels * 2, double(bytes.size()), greatest_ratio);

    DecodedImage picture;
    picture.image =
        make_image<float>(width, height, channels, Encoding{Encoding::Kind::linear, 1});
    picture.image.premultiplied = true;
    Imf::FrameBuffer target;
    for (int c = 0; c < channels; ++c)
        target.insert(names[c], slice(picture.image, c, window));
    file.setFrameBuffer(target);
    file.readPixels(window.min.y, window.max.y);

    if (std::strcmp(names[0], "Y") == 0) { // three slices of one name: only the last was filled
        auto& samples = std::get<std::vector<float>>(picture.image.samples);
        for (std::size_t i = 0; i < samples.size(); i += std::size_t(channels))
            samples[i] = samples[i + 1] = samples[i + 2];
    }
    picture.document = document_of(header);
    if (Imf::hasXDensity(header) && Imf::xDensity(header) > 0 && header.pixelAspectRatio() > 0) {
        const double pitch = mm_per_inch / Imf::xDensity(header);
        picture.pixel_pitch = Vec2{pitch, pitch / header.pixelAspectRatio()};
    }
    return picture;
}

PictureHeader decode_start(const std::string& bytes)
{
    constexpr Offset magic_and_version = 8;
    ByteSource source(bytes);
    int version = static_cast<unsigned char>(bytes[4]) | static_cast<unsigned char>(bytes[5]) << 8;
    source.seekg(magic_and_version);
    Imf::Header header;
    header.readFrom(source, version);
    const Imath::Box2i window = header.dataWindow();
    return {width_of(window), height_of(window), 32, document_of(header)};
}

DecodedDepths decode_z(const std::string& bytes)
{
    Imf::Header::setMaxImageSize(largest_side, largest_side);
    ByteSource source(bytes);
    Imf::InputFile file(source);
    const Imf::Header& header = file.header();
    for (const char* name : {"Z", "A"}) {
        const auto* channel = header.channels().findChannel(name);
        if (!channel || channel->xSampling != 1 || channel->ySampling != 1)
            throw std::runtime_error("it is no depth frame: it has no channels Z and A");
    }
    const Imath::Box2i window = header.dataWindow();
    DecodedDepths depths{width_of(window), height_of(window), {}, {}, document_of(header)};
    const double pixels = double(depths.width) * depths.height;
    check_plausible_size(double(depths.width) * rows_kept(header, depths.height) * 2 * sizeof(float), double(bytes.size()), greatest_ratio);
    Imf::FrameBuffer target;
    const std::size_t step = sizeof(float), row = step * std::size_t(depths.width);
    for (auto* channel : {&depths.depth, &depths.imaged}) {
        channel->resize(std::size_t(pixels));
        target.insert(channel == &depths.depth ? "Z" : "A", Imf::Slice::Make(Imf::FLOAT, channel->data(), window, step, row));
    }
    file.setFrameBuffer(target);
    file.readPixels(window.min.y, window.max.y);
    return depths;
}

/// What `decode` makes of the bytes; errors as the header says.
template <class Decode> auto guarded(Decode decode, const std::string& bytes)
{
    try {
        check_exr_header(bytes);
        return decode(bytes);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        // OpenEXR's messages begin with the stream's name and may hold line ends.
        std::string text = error.what();
        for (char& c : text)
            if (c == '\n' || c == '\r')
                c = ' ';
        throw std::runtime_error(text);
    }
}

} // namespace

DecodedImage decode_exr(const std::string& bytes) { return guarded(decode_picture, bytes); }

PictureHeader decode_exr_header(const std::string& bytes) { return guarded(decode_start, bytes); }

bool is_whole_exr(const std::string& path)
{
    try {
        Imf::InputFile file(path.c_str(), 0);
        const Imath::Box2i window = file.header().dataWindow();
        std::vector<float> row(std::size_t(width_of(window)));
        Imf::FrameBuffer target; // every row goes to the same place
        target.insert("R", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(row.data() - window.min.x), sizeof(float), 0));
        file.setFrameBuffer(target);
        file.readPixels(window.min.y, window.max.y);
        return file.isComplete();
    } catch (const std::exception&) {
        return false;
    }
}

DecodedDepths decode_depths(const std::string& bytes) { return guarded(decode_z, bytes); }

std::string encode_exr(const DecodedImage& picture)
{
    const Image& image = picture.image;
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    static const char* const names[] = {"R", "G", "B", "A"};
    Imf::FrameBuffer source;
    for (int c = 0; c < image.channels; ++c) {
        header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
        source.insert(names[c], slice(const_cast<Image&>(image), c, header.dataWindow()));
    }
    if (!picture.document.empty())
        header.insert(attribute, Imf::StringAttribute(picture.document));
    if (picture.pixel_pitch) {
        Imf::addXDensity(header, float(mm_per_inch / picture.pixel_pitch->x));
        header.pixelAspectRatio() = float(picture.pixel_pitch->x / picture.pixel_pitch->y);
    }
    std::string output;
    {
        ByteSink sink(output);
        Imf::OutputFile file(sink, header);
        file.setFrameBuffer(source);
        file.writePixels(image.height);
    } // the file's destructor completes it
    return output;
}

} // namespace integral
