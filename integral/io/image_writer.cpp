// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/frame/depth_attribute.h"
#include "integral/io/codecs.h"
#include "integral/io/image_file.h"

#include <algorithm>

namespace integral {
namespace {

/// The form in which a format stores a picture of the given form.
Image form_in(ImageFormat format, const Image& form, bool has_metadata)
{
    const Encoding linear{Encoding::Kind::linear, 1}, srgb;
    const bool is_linear = form.encoding.kind == Encoding::Kind::linear;
    int bits = sample_bits(form);
    Encoding encoding = form.encoding;
    bool premultiplied = form.premultiplied;
    if (format == ImageFormat::exr) {
        bits = 32;
        encoding = linear;
        premultiplied = true;
    } else if (format == ImageFormat::png) {
        if (bits == 32) {
            bits = 16;
            encoding = is_linear ? srgb : encoding;
        }
        premultiplied = false;
    } else if (!has_metadata) { // a TIFF without a document is read as linear floats or as sRGB
        encoding = bits == 32 ? linear : srgb;
    }
    Image result = form_of(bits, form.width, form.height, form.channels, encoding);
    result.premultiplied = premultiplied;
    return result;
}

/// Whether samples need no conversion between two forms.
bool same_samples(const Image& a, const Image& b)
{
    return sample_bits(a) == sample_bits(b) && same_encoding(a.encoding, b.encoding) &&
           (a.channels == 3 || a.premultiplied == b.premultiplied);
}

} // namespace

ImageFormat format_for(const std::string& path)
{
    if (path == "-")
        return ImageFormat::png;
    const std::string extension = extension_of(path);
    if (extension == "png")
        return ImageFormat::png;
    if (extension == "exr")
        return ImageFormat::exr;
    if (extension == "tif" || extension == "tiff")
        return ImageFormat::tiff;
    throw OutputError(path + ": its name does not say a format that can be written; end it in " +
                      ".png, .exr or .tiff");
}

struct PictureWriter::Target {
    /// `head` has the form of the file, `given` the form of the bands passed to write().
    Target(const std::string& path, const DecodedImage& head, const Image& given)
        : path(path), file(path), head(head)
    {
        const ImageFormat format = format_for(path);
        const auto write = format == ImageFormat::png   ? write_png
                           : format == ImageFormat::exr ? write_exr
                                                        : write_tiff;
        as_given = same_samples(head.image, given);
        guarded([&] { rows = write(file, head); });
    }

    /// Calls work() and rethrows its exceptions as OutputError.
    template <class Work> void guarded(Work work)
    {
        try {
            work();
        } catch (const OutputError&) {
            throw;
        } catch (const std::exception& error) {
            throw OutputError(path + ": " + reason_of(error));
        }
    }

    std::string path;
    OutputFile file;
    DecodedImage head;
    std::unique_ptr<RowWriter> rows;
    bool as_given; ///< bands need not be converted
};

PictureWriter::PictureWriter(std::unique_ptr<Target> target) : target_(std::move(target)) {}
PictureWriter::PictureWriter(PictureWriter&&) noexcept = default;
PictureWriter::~PictureWriter() = default;

PictureWriter PictureWriter::of_frame(const std::string& path, const Image& form,
                                      const std::optional<FrameMetadata>& metadata)
{
    DecodedImage head;
    head.image = form_in(format_for(path), form, metadata.has_value());
    if (metadata) {
        FrameMetadata document = *metadata;
        document.encoding = head.image.encoding;
        head.document = to_json(document);
        if (!document.quilt)
            head.pixel_pitch = document.film.pixel_pitch;
    }
    return PictureWriter(std::make_unique<Target>(path, head, form));
}

PictureWriter PictureWriter::of_page(const std::string& path, const Image& form, Vec2 pixel_pitch,
                                     const std::string& profile,
                                     const std::optional<FrameMetadata>& geometry,
                                     const std::vector<std::string>& inks)
{
    DecodedImage head;
    head.image = form_of(form);
    head.inks = inks;
    if (geometry)
        head.document = to_json(*geometry);
    head.pixel_pitch = pixel_pitch;
    head.profile = profile;
    return PictureWriter(std::make_unique<Target>(path, head, form));
}

PictureWriter PictureWriter::of_grey_page(const std::string& path, const Image& form,
                                          Vec2 pixel_pitch, bool two_tone,
                                          const std::optional<FrameMetadata>& geometry)
{
    DecodedImage head;
    head.image = form_of(form);
    if (geometry)
        head.document = to_json(*geometry);
    head.pixel_pitch = pixel_pitch;
    head.two_tone = two_tone;
    return PictureWriter(std::make_unique<Target>(path, head, form));
}

void PictureWriter::write(const Image& band)
{
    Target& t = *target_;
    const Image& form = t.head.image;
    t.guarded([&] {
        if (t.as_given) {
            t.rows->write(band);
            return;
        }
        const int most = rows_of_a_band(form_of(band));
        for (int y = 0; y < band.height; y += most)
            t.rows->write(converted(rows_of(band, y, std::min(most, band.height - y)),
                                    sample_bits(form), form.encoding, form.premultiplied));
    });
}

void PictureWriter::finish()
{
    target_->guarded([&] { target_->rows->finish(); });
    target_->file.finish();
}

void write_frame(const std::string& path, const Frame& frame)
{
    PictureWriter writer = PictureWriter::of_frame(path, frame.image, frame.metadata);
    writer.write(frame.image);
    writer.finish();
}

void write_depths(const std::string& path, const DepthFrame& frame)
{
    const Film& film = frame.metadata.film;
    std::string bytes;
    try {
        bytes = encode_depths(film.width, film.height,
                              {{"Z", &frame.depth}, {"Y", &frame.depth}, {"A", &frame.imaged}},
                              depth_in_mm, to_json(frame.metadata));
    } catch (const std::exception& error) {
        throw OutputError(path + ": " + reason_of(error));
    }
    write_file(path, bytes);
}

void write_page(const std::string& path, const Image& page, Vec2 pixel_pitch,
                const std::string& profile, const std::optional<FrameMetadata>& geometry)
{
    PictureWriter writer = PictureWriter::of_page(path, page, pixel_pitch, profile, geometry);
    writer.write(page);
    writer.finish();
}

} // namespace integral
