// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/codecs.h"

#include "integral/io/memory.h"

#include <sstream>
#include <stdexcept>

namespace integral {
namespace {

using namespace std::string_literals;

using Read = std::unique_ptr<RowReader> (*)(const InputFile&);
using Write = std::unique_ptr<RowWriter> (*)(ByteSink&, const DecodedImage&);

DecodedImage decoded(const std::string& bytes, Read read)
{
    const InputFile file = InputFile::of_bytes(bytes);
    return whole_picture(*read(file));
}

std::string encoded(const DecodedImage& picture, Write write)
{
    ByteString sink;
    {
        const auto writer = write(sink, picture);
        writer->write(picture.image);
        writer->finish();
    }
    return std::move(sink.bytes);
}

} // namespace

std::unique_ptr<RowReader> read_any(const InputFile& file, const std::string& path)
{
    const std::string magic = file.beginning(4);
    if (magic == "\x89PNG")
        return read_png(file);
    if (magic == "\x76\x2f\x31\x01")
        return read_exr(file);
    if (magic.compare(0, 3, "\xff\xd8\xff") == 0)
        return read_jpeg(file);
    for (const auto& tiff : {"II*\0"s, "MM\0*"s, "II+\0"s, "MM\0+"s})
        if (magic == tiff)
            return read_tiff(file);
    if (magic.empty())
        throw std::runtime_error("it is empty");
    const std::string extension = extension_of(path);
    for (const char* known : {"png", "exr", "tif", "tiff", "jpg", "jpeg", "mpo"})
        if (extension == known)
            throw std::runtime_error("it is broken: its name ends in ." + extension +
                                     ", but it begins as no PNG, OpenEXR, TIFF or JPEG does");
    throw std::runtime_error("it is no PNG, OpenEXR, TIFF or JPEG; convert it first");
}

Image whole_blank(const Image& form)
{
    check_memory(size_in_bytes(form));
    return blank_like(form, form.width, form.height);
}

DecodedImage whole_picture(RowReader& reader)
{
    DecodedImage picture = reader.head();
    picture.image = whole_blank(picture.image);
    reader.read(picture.image);
    return picture;
}

DecodedImage decode_png(const std::string& bytes) { return decoded(bytes, read_png); }
DecodedImage decode_exr(const std::string& bytes) { return decoded(bytes, read_exr); }
DecodedImage decode_tiff(const std::string& bytes) { return decoded(bytes, read_tiff); }

std::string encode_png(const DecodedImage& picture) { return encoded(picture, write_png); }
std::string encode_exr(const DecodedImage& picture) { return encoded(picture, write_exr); }
std::string encode_tiff(const DecodedImage& picture) { return encoded(picture, write_tiff); }

void check_plausible_size(double raw_bytes, double file_bytes, double ratio)
{
    std::ostringstream text;
    text.precision(3);
    text << "its header promises " << raw_bytes << " bytes of pixels, more than the file can hold";
    if (raw_bytes > file_bytes * ratio)
        throw std::runtime_error(text.str());
}

} // namespace integral
