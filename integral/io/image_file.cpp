// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/image_file.h"

#include "integral/io/codecs.h"
#include "integral/io/mpo_file.h"

#include <algorithm>
#include <new>
#include <unistd.h>

namespace integral {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what)
{
    throw InputError(display_name(path, "standard input") + ": " + what);
}

/// Returns what `read` returns; rethrows its exceptions as InputError with the file's name.
template <class Read> auto guarded(const std::string& path, Read read)
{
    try {
        return read();
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        refuse(path, "it cannot be read: " + reason_of(error));
    }
}

/// An open picture file whose metadata has been read.
struct OpenPicture {
    explicit OpenPicture(const std::string& path)
        : path(path), file(path), rows(guarded(path, [&] { return read_any(file, path); }))
    {
    }
    const DecodedImage& head() const { return rows->head(); }
    Image whole()
    {
        return guarded(path, [&] { return whole_picture(*rows).image; });
    }

    std::string path;
    InputFile file;
    std::unique_ptr<RowReader> rows;
};

FrameMetadata parse(const std::string& path, const std::string& document, const char* help)
{
    try {
        return frame_metadata_from_json(document);
    } catch (const std::invalid_argument& error) {
        refuse(path, std::string("its geometry cannot be used: ") + error.what() + help);
    }
}

/// The JSON document in the same folder as a picture that carries none itself; empty if there is no
/// such file.
std::string document_beside(const std::string& path)
{
    const auto slash = path.rfind('/'), dot = path.rfind('.');
    std::vector<std::string> candidates = {path + ".json"};
    if (dot != std::string::npos && (slash == std::string::npos || dot > slash))
        candidates.push_back(path.substr(0, dot) + ".json");
    for (const auto& candidate : candidates)
        if (path != "-" && access(candidate.c_str(), F_OK) == 0)
            return candidate;
    return "";
}

constexpr char give_sheet[] = "; give --sheet FILE.json";

/// The geometry of a picture, by the rules of read_frame.
std::optional<FrameMetadata> geometry_for(const std::string& path, const std::string& sheet_file,
                                          const std::string& document)
{
    if (!sheet_file.empty())
        return read_metadata(sheet_file);
    if (!document.empty())
        return parse(path, document, give_sheet);
    const std::string beside = document_beside(path);
    if (!beside.empty())
        return parse(beside, read_file(beside), give_sheet);
    return std::nullopt;
}

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

/// Whether two forms store samples alike, so that none need be converted.
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

struct FrameReader::Source {
    Source(const std::string& path, const std::string& sheet_file) : picture(path)
    {
        frame.image = picture.head().image;
        const auto metadata = geometry_for(path, sheet_file, picture.head().document);
        if (!metadata)
            return;
        if (sheet_file.empty()) // a separate sheet file does not tell this picture's encoding
            frame.image.encoding = metadata->encoding;
        holds_views = metadata->quilt.has_value();
        if (holds_views)
            return;
        try {
            set_metadata(frame, *metadata);
        } catch (const std::invalid_argument& error) {
            refuse(path, std::string(error.what()) +
                             (sheet_file.empty()
                                  ? give_sheet
                                  : "; leave film.width and film.height out of " + sheet_file));
        }
    }

    OpenPicture picture;
    Frame frame;
    bool holds_views = false; ///< then the picture has no geometry of its own
};

FrameReader::FrameReader(const std::string& path, const std::string& sheet_file)
    : source_(std::make_unique<Source>(path, sheet_file))
{
}

FrameReader::~FrameReader() = default;

const Frame& FrameReader::frame() const { return source_->frame; }

void FrameReader::require_metadata() const
{
    const std::string& path = source_->picture.path;
    if (source_->holds_views)
        refuse(path,
               "it holds views of a frame, not a frame; integral views --to-frame makes one of "
               "them");
    if (!source_->frame.metadata)
        refuse(path, std::string("it carries no `integral` metadata") + give_sheet +
                         " (integral sheet --json writes one)");
}

void FrameReader::refuse_projection() const
{
    if (source_->frame.metadata && source_->frame.metadata->projection)
        refuse(source_->picture.path,
               "it is a frame for replay through a projection lens, of which this command knows "
               "nothing; integral replay looks through it");
}

void FrameReader::read(Image& band)
{
    guarded(source_->picture.path, [&] { source_->picture.rows->read(band); });
}

Frame FrameReader::whole()
{
    Frame frame = source_->frame;
    frame.image.samples = source_->picture.whole().samples;
    return frame;
}

void FrameReader::restart()
{
    OpenPicture& picture = source_->picture;
    picture.rows = guarded(picture.path, [&] { return read_any(picture.file, picture.path); });
}

Frame read_frame(const std::string& path, const std::string& sheet_file)
{
    return FrameReader(path, sheet_file).whole();
}

Views read_views(const std::string& path, bool needs_geometry)
{
    OpenPicture picture(path);
    Views views{picture.whole(), std::nullopt};
    try {
        views.metadata = geometry_for(path, "", picture.head().document);
    } catch (const InputError&) {
        if (needs_geometry)
            throw;
    }
    if (views.metadata)
        views.image.encoding = views.metadata->encoding;
    if (views.metadata && !views.metadata->quilt)
        views.metadata.reset();
    return views;
}

bool is_mpo(const std::string& path) { return extension_of(path) == "mpo"; }

std::vector<Image> read_mpo(const std::string& path)
{
    const std::string bytes = read_file(path);
    return guarded(path, [&] {
        std::vector<std::size_t> places = pictures_in_mpo(bytes);
        if (places.empty())
            places = {0};
        std::vector<Image> pictures;
        for (const std::size_t place : places) {
            const std::string one = bytes.substr(place);
            pictures.push_back(whole_picture(*read_jpeg(InputFile::of_bytes(one))).image);
        }
        return pictures;
    });
}

std::pair<int, int> picture_size(const std::string& path)
{
    const OpenPicture picture(path);
    return {picture.head().image.width, picture.head().image.height};
}

Scan read_scan(const std::string& path)
{
    OpenPicture picture(path);
    return {picture.whole(), picture.head().pixel_pitch};
}

Frame read_frame_with_metadata(const std::string& path, const std::string& sheet_file)
{
    FrameReader reader(path, sheet_file);
    reader.require_metadata();
    return reader.whole();
}

Frame read_sheet_frame(const std::string& path, const std::string& sheet_file)
{
    FrameReader reader(path, sheet_file);
    reader.require_metadata();
    reader.refuse_projection();
    return reader.whole();
}

FrameMetadata read_metadata(const std::string& path)
{
    const InputFile file(path);
    std::string document;
    std::optional<FrameMetadata> metadata;
    try {
        constexpr std::size_t some = 4096;
        const std::string beginning = file.beginning(some);
        const auto first = beginning.find_first_not_of(" \t\r\n");
        if (first != std::string::npos && beginning[first] == '{')
            metadata = parse(path, file.beginning(file.size()), "");
        else
            document = read_any(file, path)->head().document;
    } catch (const InputError&) {
        throw;
    } catch (const std::bad_alloc& error) {
        refuse(path, reason_of(error));
    } catch (const std::exception& error) {
        refuse(path, std::string("it is neither a JSON document nor a frame: ") + error.what());
    }
    if (!metadata)
        metadata = geometry_for(path, "", document);
    if (!metadata)
        refuse(path, "it carries no `integral` metadata");
    metadata->quilt.reset();
    return *metadata;
}

DepthFrame read_depths(const std::string& path)
{
    DecodedDepths file = guarded(path, [&] { return decode_depths(read_file(path)); });
    if (file.document.empty())
        refuse(path, "it carries no `integral` metadata; Integral_Depth_Image=FILE.exr writes "
                     "depth frames that do");
    DepthFrame frame{std::move(file.depth), std::move(file.imaged), parse(path, file.document, "")};
    if (frame.metadata.film.width != file.width || frame.metadata.film.height != file.height)
        refuse(path, "its geometry is of a frame of another size");
    return frame;
}

struct PictureWriter::Target {
    /// `head` has the form of the file, `given` the form of the bands that write() gets.
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
                                     const std::optional<FrameMetadata>& geometry)
{
    DecodedImage head;
    head.image = form_of(form);
    if (geometry)
        head.document = to_json(*geometry);
    head.pixel_pitch = pixel_pitch;
    head.profile = profile;
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

void write_page(const std::string& path, const Image& page, Vec2 pixel_pitch,
                const std::string& profile, const std::optional<FrameMetadata>& geometry)
{
    PictureWriter writer = PictureWriter::of_page(path, page, pixel_pitch, profile, geometry);
    writer.write(page);
    writer.finish();
}

} // namespace integral
