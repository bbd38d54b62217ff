// SPDX-License-Identifier: AGPL-3.0-or-later
// OpenEXR: the document in a string attribute `integral`, the resolution in xDensity and
// pixelAspectRatio; samples are linear and premultiplied by alpha.
#include "integral/base/memory.h"
#include "integral/frame/depth_attribute.h"
#include "integral/io/codecs.h"
#include "integral/io/exr_header.h"
#include "integral/io/exr_stream.h"
#include "integral/io/exr_views.h"

#include "integral/optics/film.h"

#include <ImfChannelList.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>

namespace integral {
namespace {

constexpr char attribute[] = "integral";
constexpr double greatest_ratio = 2000; // ZIP reaches 1032, PIZ about 500
constexpr int largest_side = 1000000;

/// The OpenEXR slice of one interleaved channel of `image`, which holds the rows in `window` of the
/// file.
Imf::Slice slice(const Image& image, int channel, const Imath::Box2i& window)
{
    const auto& samples = std::get<std::vector<float>>(image.samples);
    const std::size_t step = sizeof(float) * std::size_t(image.channels);
    return Imf::Slice::Make(Imf::FLOAT, samples.data() + channel, window, step,
                            step * std::size_t(image.width));
}

int width_of(const Imath::Box2i& window) { return window.max.x - window.min.x + 1; }
int height_of(const Imath::Box2i& window) { return window.max.y - window.min.y + 1; }

/// Number of rows that OpenEXR may hold in memory for a picture of `height` rows: all of them, or a
/// whole row of tiles if that is more.
double rows_kept(const Imf::Header& header, int height)
{
    return header.hasTileDescription()
               ? std::max(double(height), double(header.tileDescription().ySize))
               : height;
}

std::string document_of(const Imf::Header& header)
{
    const auto* text = header.findTypedAttribute<Imf::StringAttribute>(attribute);
    return text ? text->value() : "";
}

/// A depth frame's distances from the scene's eye plane to the surfaces that the eye sees; empty
/// for files of other programs.
std::vector<float> eye_distances_of(const Imf::Header& header)
{
    const auto* distances = header.findTypedAttribute<Imf::FloatVectorAttribute>("eyeDistances");
    if (!distances)
        return {};
    for (const float distance : distances->value())
        if (!(distance > 0))
            throw std::runtime_error("its attribute eyeDistances has values that are no distances");
    return distances->value();
}

/// Returns `input` after check_exr_header.
const InputFile& checked(const InputFile& input)
{
    check_exr_header(input);
    return input;
}

struct ExrFile {
    explicit ExrFile(const InputFile& input) : source(checked(input))
    {
        Imf::Header::setMaxImageSize(largest_side, largest_side);
        parts.emplace(source);
    }

    std::vector<Imf::Header> headers() const
    {
        std::vector<Imf::Header> all;
        for (int part = 0; part < parts->parts(); ++part)
            all.push_back(parts->header(part));
        return all;
    }

    ExrSource source;
    std::optional<Imf::MultiPartInputFile> parts;
};

/// Returns work(); rethrows its exceptions as promised in codecs.h.
template <class Work> auto guarded(Work work)
{
    try {
        return work();
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

/// Reads the header from the first bytes of a file.
PictureHeader decode_start(const InputFile& input)
{
    constexpr int magic_and_version = 8;
    ExrSource source(checked(input));
    const std::string beginning = input.beginning(magic_and_version);
    int version = static_cast<unsigned char>(beginning[4]) |
                  static_cast<unsigned char>(beginning[5]) << 8;
    source.seekg(magic_and_version);
    Imf::Header header;
    header.readFrom(source, version);
    const Imath::Box2i window = header.displayWindow();
    return {width_of(window), height_of(window), 32, document_of(header)};
}

class ExrReader : public RowReader {
public:
    ExrReader(const InputFile& input, std::optional<int> view) : exr_(input)
    {
        const ExrViews all = exr_views(exr_.headers());
        view_ = all.views.at(std::size_t(view.value_or(0)));
        if (!all.notice.empty())
            add_notice(all.notice);
        if (!view && all.views.size() > 1)
            add_notice("it holds " + std::to_string(all.views.size()) + " views; " +
                       all.views[0].name + " is read");
        part_.emplace(*exr_.parts, view_.part);
        const Imf::Header& header = part_->header();
        check_channels(header.channels());
        data_ = header.dataWindow();
        display_ = header.displayWindow();
        if (width_of(display_) > largest_side || height_of(display_) > largest_side)
            throw std::runtime_error("its display window makes no sense");
        head_.image = form_of(32, width_of(display_), height_of(display_),
                              int(view_.channels.size()), Encoding{Encoding::Kind::linear, 1});
        head_.image.premultiplied = true;
        head_.document = document_of(header);
        if (Imf::hasXDensity(header) && Imf::xDensity(header) > 0 &&
            header.pixelAspectRatio() > 0) {
            const double pitch = mm_per_inch / Imf::xDensity(header);
            head_.pixel_pitch = Vec2{pitch, pitch / header.pixelAspectRatio()};
        }
        const double packed_row = double(width_of(data_)) * head_.image.channels * 2; // half floats
        check_plausible_size(packed_row * rows_kept(header, height_of(data_)), double(input.size()),
                             greatest_ratio);
    }

    void read(Image& band) override
    {
        guarded([&] {
            if (data_ == display_)
                read_stored(band, display_.min.y + next_);
            else
                place_stored(band, display_.min.y + next_);
        });
        next_ += band.height;
    }

private:
    void check_channels(const Imf::ChannelList& channels) const
    {
        for (const std::string& name : view_.channels) {
            const auto* channel = channels.findChannel(name);
            if (channel->xSampling != 1 || channel->ySampling != 1)
                throw std::runtime_error("its channels are subsampled");
        }
    }

    /// Reads rows of the data window from row `first` of the file on.
    void read_stored(Image& band, int first)
    {
        Imath::Box2i rows = data_;
        rows.min.y = first;
        rows.max.y = first + band.height - 1;
        Imf::FrameBuffer target;
        for (int c = 0; c < band.channels; ++c)
            target.insert(view_.channels[std::size_t(c)], slice(band, c, rows));
        part_->setFrameBuffer(target);
        part_->readPixels(rows.min.y, rows.max.y);
        if (view_.channels[0] != view_.channels[1])
            return;
        // A grey picture has three slices for one channel; OpenEXR fills only the last.
        auto& samples = std::get<std::vector<float>>(band.samples);
        for (std::size_t i = 0; i < samples.size(); i += std::size_t(band.channels))
            samples[i] = samples[i + 1] = samples[i + 2];
    }

    /// Reads rows of the display window from row `first` of the file on. Pixels outside the data
    /// window are black and transparent.
    void place_stored(Image& band, int first)
    {
        auto& samples = std::get<std::vector<float>>(band.samples);
        std::fill(samples.begin(), samples.end(), 0.0f);
        const int left = std::max(data_.min.x, display_.min.x),
                  right = std::min(data_.max.x, display_.max.x),
                  end = std::min(first + band.height - 1, data_.max.y);
        if (right < left)
            return;
        const Image form = form_of(32, width_of(data_), 1, band.channels, band.encoding);
        const int most = rows_of_a_band(form);
        for (int y = std::max(first, data_.min.y); y <= end; y += most) {
            Image part = blank_like(form, form.width, std::min(most, end - y + 1));
            read_stored(part, y);
            const auto& from = std::get<std::vector<float>>(part.samples);
            const auto at = [&](const Image& image, int row, int column) {
                return (std::size_t(row) * image.width + column) * image.channels;
            };
            for (int row = 0; row < part.height; ++row)
                std::copy_n(&from[at(part, row, left - data_.min.x)],
                            std::size_t(right - left + 1) * band.channels,
                            &samples[at(band, y + row - first, left - display_.min.x)]);
        }
    }

    ExrFile exr_;
    ExrView view_;
    std::optional<Imf::InputPart> part_;
    Imath::Box2i data_, display_;
    int next_ = 0;
};

class ExrWriter : public RowWriter {
public:
    ExrWriter(ByteSink& sink, const DecodedImage& head) : sink_(sink)
    {
        const Image& form = head.image;
        Imf::Header header(form.width, form.height);
        header.compression() = Imf::ZIP_COMPRESSION;
        for (int c = 0; c < form.channels; ++c)
            header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
        if (!head.document.empty())
            header.insert(attribute, Imf::StringAttribute(head.document));
        if (head.pixel_pitch) {
            Imf::addXDensity(header, float(mm_per_inch / head.pixel_pitch->x));
            header.pixelAspectRatio() = float(head.pixel_pitch->x / head.pixel_pitch->y);
        }
        file_.emplace(sink_, header);
    }
    void write(const Image& band) override
    {
        const Imath::Box2i rows({0, next_}, {band.width - 1, next_ + band.height - 1});
        Imf::FrameBuffer source;
        for (int c = 0; c < band.channels; ++c)
            source.insert(names[c], slice(band, c, rows));
        file_->setFrameBuffer(source);
        file_->writePixels(band.height);
        next_ += band.height;
    }
    void finish() override { file_.reset(); } // its destructor completes the file

private:
    static constexpr const char* names[] = {"R", "G", "B", "A"};
    ExrSink sink_;
    std::optional<Imf::OutputFile> file_;
    int next_ = 0;
};

DecodedDepths decode_z(const InputFile& input)
{
    ExrFile exr(input);
    Imf::InputPart part(*exr.parts, 0);
    const Imf::Header& header = part.header();
    for (const char* name : {"Z", "A"}) {
        const auto* channel = header.channels().findChannel(name);
        if (!channel || channel->xSampling != 1 || channel->ySampling != 1)
            throw std::runtime_error("it is no depth frame: it has no channels Z and A");
    }
    const Imath::Box2i window = header.dataWindow();
    DecodedDepths depths{width_of(window),    height_of(window),       {}, {},
                         document_of(header), eye_distances_of(header)};
    const double pixels = double(depths.width) * depths.height;
    const double row_bytes = double(depths.width) * 2 * sizeof(float);
    check_plausible_size(row_bytes * rows_kept(header, depths.height), double(input.size()),
                         greatest_ratio);
    check_memory(row_bytes * depths.height);
    Imf::FrameBuffer target;
    const std::size_t step = sizeof(float), row = step * std::size_t(depths.width);
    for (auto* channel : {&depths.depth, &depths.imaged}) {
        channel->resize(std::size_t(pixels));
        target.insert(channel == &depths.depth ? "Z" : "A",
                      Imf::Slice::Make(Imf::FLOAT, channel->data(), window, step, row));
    }
    part.setFrameBuffer(target);
    part.readPixels(window.min.y, window.max.y);
    return depths;
}

} // namespace

PictureHeader decode_exr_header(const std::string& bytes)
{
    return guarded([&] { return decode_start(InputFile::of_bytes(bytes)); });
}

bool is_whole_exr(const std::string& path)
{
    try {
        Imf::InputFile file(path.c_str(), 0);
        const Imath::Box2i window = file.header().dataWindow();
        std::vector<float> row(std::size_t(width_of(window)));
        Imf::FrameBuffer target; // every row overwrites the previous row
        target.insert("R",
                      Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(row.data() - window.min.x),
                                 sizeof(float), 0));
        file.setFrameBuffer(target);
        file.readPixels(window.min.y, window.max.y);
        return file.isComplete();
    } catch (const std::exception&) {
        return false;
    }
}

std::unique_ptr<RowReader> read_exr(const InputFile& file, std::optional<int> view)
{
    return guarded([&] { return std::make_unique<ExrReader>(file, view); });
}

int views_in_exr(const InputFile& file)
{
    return guarded([&] { return int(exr_views(ExrFile(file).headers()).views.size()); });
}

DecodedDepths decode_depths(const std::string& bytes)
{
    return guarded([&] { return decode_z(InputFile::of_bytes(bytes)); });
}

std::string encode_depths(int width, int height, const std::vector<NamedFloats>& channels,
                          const char* unit, const std::string& document)
{
    return guarded([&] {
        Imf::Header header(width, height);
        header.compression() = Imf::ZIP_COMPRESSION;
        header.insert(depth_attribute, Imf::StringAttribute(unit));
        if (!document.empty())
            header.insert(attribute, Imf::StringAttribute(document));
        Imf::FrameBuffer source;
        const std::size_t step = sizeof(float);
        for (const NamedFloats& channel : channels) {
            header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
            source.insert(channel.name,
                          Imf::Slice::Make(Imf::FLOAT, channel.values->data(), header.dataWindow(),
                                           step, step * std::size_t(width)));
        }
        ByteString bytes;
        {
            ExrSink sink(bytes);
            Imf::OutputFile file(sink, header);
            file.setFrameBuffer(source);
            file.writePixels(height);
        }
        return bytes.bytes;
    });
}

std::unique_ptr<RowWriter> write_exr(ByteSink& sink, const DecodedImage& head)
{
    return std::make_unique<ExrWriter>(sink, head);
}

} // namespace integral
