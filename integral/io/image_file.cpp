// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/image_file.h"

#include "integral/io/codecs.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <new>
#include <sstream>
#include <unistd.h>

namespace integral {
namespace {

bool begins_with(const std::string& bytes, const std::string& magic)
{
    return bytes.compare(0, magic.size(), magic) == 0;
}

DecodedImage decode_any(const std::string& bytes)
{
    using namespace std::string_literals;
    if (begins_with(bytes, "\x89PNG"))
        return decode_png(bytes);
    if (begins_with(bytes, "\x76\x2f\x31\x01"))
        return decode_exr(bytes);
    if (begins_with(bytes, "II*\0"s) || begins_with(bytes, "MM\0*"s) ||
        begins_with(bytes, "II+\0"s) || begins_with(bytes, "MM\0+"s))
        return decode_tiff(bytes);
    throw std::runtime_error(bytes.empty() ? "it is empty"
                                           : "it is no PNG, OpenEXR or TIFF; convert it first");
}

/// A message that is one line, whatever a library or file put into it.
std::string one_line(std::string text)
{
    for (char& c : text)
        if (std::iscntrl(static_cast<unsigned char>(c)))
            c = ' ';
    return text;
}

[[noreturn]] void refuse(const std::string& path, const std::string& what)
{
    throw InputError(display_name(path, "standard input") + ": " + one_line(what));
}

/// What `decode` makes of a file.
template <class Decode> auto decoded(const std::string& path, Decode decode)
{
    const std::string bytes = read_file(path);
    try {
        return decode(bytes);
    } catch (const std::bad_alloc&) {
        refuse(path, "it needs more memory than there is");
    } catch (const std::exception& error) {
        refuse(path, std::string("it cannot be read: ") + error.what());
    }
}

FrameMetadata parse(const std::string& path, const std::string& document, const char* help)
{
    try {
        return frame_metadata_from_json(document);
    } catch (const std::invalid_argument& error) {
        refuse(path, std::string("its geometry cannot be used: ") + error.what() + help);
    }
}

/// The document that stands beside a picture whose format holds none; empty if none does.
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

/// The geometry for a picture, as read_frame's comment has it.
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

Image in_form_of(ImageFormat format, Image image, bool has_metadata)
{
    const Encoding linear{Encoding::Kind::linear, 1}, srgb;
    const bool is_linear = image.encoding.kind == Encoding::Kind::linear;
    int bits = sample_bits(image);
    Encoding encoding = image.encoding;
    bool premultiplied = image.premultiplied;
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
    } else if (!has_metadata) { // a TIFF without a document is taken for linear floats or sRGB
        encoding = bits == 32 ? linear : srgb;
    }
    if (bits == sample_bits(image) && same_encoding(encoding, image.encoding) &&
        (image.channels == 3 || premultiplied == image.premultiplied)) {
        image.premultiplied = premultiplied;
        return image;
    }
    return converted(image, bits, encoding, premultiplied);
}

} // namespace

void check_plausible_size(double raw_bytes, double file_bytes, double ratio)
{
    std::ostringstream text;
    text.precision(3);
    text << "its header promises " << raw_bytes << " bytes of pixels, more than the file can hold";
    if (raw_bytes > file_bytes * ratio)
        throw std::runtime_error(text.str());
    check_memory(raw_bytes);
}

void check_memory(double bytes)
{
    const double memory = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
    std::ostringstream text;
    text.precision(3);
    text << "it needs " << bytes / 1e9 << " GB, more memory than this machine has";
    if (memory > 0 && bytes > memory)
        throw std::runtime_error(text.str());
}

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

namespace {

/// A picture, its encoding as read_frame's comment has it, and its geometry.
Views read_with_geometry(const std::string& path, const std::string& sheet_file)
{
    DecodedImage picture = decoded(path, decode_any);
    Views views{std::move(picture.image), geometry_for(path, sheet_file, picture.document)};
    if (views.metadata && sheet_file.empty()) // a document for other frames says nothing of this one's encoding
        views.image.encoding = views.metadata->encoding;
    return views;
}

Frame frame_of(const std::string& path, const std::string& sheet_file, Views picture)
{
    Frame frame{std::move(picture.image), std::nullopt};
    if (!picture.metadata || picture.metadata->quilt)
        return frame;
    try {
        set_metadata(frame, *picture.metadata);
    } catch (const std::invalid_argument& error) {
        refuse(path, std::string(error.what()) +
                         (sheet_file.empty() ? give_sheet
                                             : "; leave film.width and film.height out of " +
                                                   sheet_file));
    }
    return frame;
}

} // namespace

Frame read_frame(const std::string& path, const std::string& sheet_file)
{
    return frame_of(path, sheet_file, read_with_geometry(path, sheet_file));
}

Views read_views(const std::string& path, bool needs_geometry)
{
    DecodedImage picture = decoded(path, decode_any);
    Views views{std::move(picture.image), std::nullopt};
    try {
        views.metadata = geometry_for(path, "", picture.document);
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

std::pair<int, int> picture_size(const std::string& path)
{
    // The signature, then the first chunk: its length and name, width and height, four bytes each, the highest first.
    std::string start(24, '\0');
    std::ifstream file(path, std::ios::binary);
    if (file.read(&start[0], std::streamsize(start.size())) && begins_with(start, "\x89PNG") && start.compare(12, 4, "IHDR") == 0) {
        const auto number = [&](int at) {
            std::uint32_t value = 0;
            for (int k = at; k < at + 4; ++k)
                value = value << 8 | static_cast<unsigned char>(start[std::size_t(k)]);
            return int(std::min<std::uint32_t>(value, 0x7fffffff));
        };
        return {number(16), number(20)};
    }
    const DecodedImage picture = decoded(path, decode_any);
    return {picture.image.width, picture.image.height};
}

Scan read_scan(const std::string& path)
{
    DecodedImage picture = decoded(path, decode_any);
    return {std::move(picture.image), picture.pixel_pitch};
}

Frame read_frame_with_metadata(const std::string& path, const std::string& sheet_file)
{
    Views picture = read_with_geometry(path, sheet_file);
    if (!picture.metadata)
        refuse(path, std::string("it carries no `integral` metadata") + give_sheet +
                         " (integral sheet --json writes one)");
    if (picture.metadata->quilt)
        refuse(path, "it holds views of a frame, not a frame; integral views --to-frame makes one of them");
    return frame_of(path, sheet_file, std::move(picture));
}

FrameMetadata read_metadata(const std::string& path)
{
    const std::string bytes = read_file(path);
    const auto first = bytes.find_first_not_of(" \t\r\n");
    FrameMetadata geometry;
    if (first != std::string::npos && bytes[first] == '{') {
        geometry = parse(path, bytes, "");
        geometry.quilt.reset();
        return geometry;
    }
    DecodedImage picture;
    try {
        picture = decode_any(bytes);
    } catch (const std::exception& error) {
        refuse(path, std::string("it is neither a JSON document nor a frame: ") + error.what());
    }
    const auto metadata = geometry_for(path, "", picture.document);
    if (!metadata)
        refuse(path, "it carries no `integral` metadata");
    geometry = *metadata;
    geometry.quilt.reset();
    return geometry;
}

DepthFrame read_depths(const std::string& path)
{
    DecodedDepths file = decoded(path, decode_depths);
    if (file.document.empty())
        refuse(path, "it carries no `integral` metadata; Integral_Depth_Image=FILE.exr writes depth frames that do");
    DepthFrame frame{std::move(file.depth), std::move(file.imaged), parse(path, file.document, "")};
    if (frame.metadata.film.width != file.width || frame.metadata.film.height != file.height)
        refuse(path, "its geometry is of a frame of another size");
    return frame;
}

namespace {

/// A picture in a format's bytes; errors as OutputError.
template <class Prepare> void write_encoded(const std::string& path, Prepare prepare)
{
    const ImageFormat format = format_for(path);
    std::string bytes;
    try {
        const DecodedImage picture = prepare(format);
        bytes = format == ImageFormat::png   ? encode_png(picture)
                : format == ImageFormat::exr ? encode_exr(picture)
                                             : encode_tiff(picture);
    } catch (const std::bad_alloc&) {
        throw OutputError(path + ": it needs more memory than there is");
    } catch (const std::exception& error) {
        throw OutputError(path + ": " + one_line(error.what()));
    }
    write_file(path, bytes);
}

} // namespace

void write_frame(const std::string& path, Frame frame)
{
    write_encoded(path, [&](ImageFormat format) {
        DecodedImage picture;
        picture.image = in_form_of(format, std::move(frame.image), frame.metadata.has_value());
        if (frame.metadata) {
            FrameMetadata metadata = *frame.metadata;
            metadata.encoding = picture.image.encoding;
            picture.document = to_json(metadata);
            if (!metadata.quilt)
                picture.pixel_pitch = metadata.film.pixel_pitch;
        }
        return picture;
    });
}

void write_page(const std::string& path, Image page, Vec2 pixel_pitch, const std::string& profile, const std::optional<FrameMetadata>& geometry)
{
    write_encoded(path, [&](ImageFormat) {
        DecodedImage picture;
        picture.image = std::move(page);
        if (geometry)
            picture.document = to_json(*geometry);
        picture.pixel_pitch = pixel_pitch;
        picture.profile = profile;
        return picture;
    });
}

} // namespace integral
