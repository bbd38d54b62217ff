// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/as_shown.h"

#include "integral/base/memory.h"
#include "integral/io/mpo_file.h"
#include "integral/io/open_raster.h"

#include <algorithm>
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

bool is_exr(const InputFile& file) { return file.beginning(4) == "\x76\x2f\x31\x01"; }

bool is_jpeg(const InputFile& file) { return file.beginning(2) == "\xff\xd8"; }

bool is_tiff(const InputFile& file)
{
    const std::string magic = file.beginning(4);
    return magic == "II*\0"s || magic == "MM\0*"s || magic == "II+\0"s || magic == "MM\0+"s;
}

/// A reader of the stored rows, for the format that the file's first bytes indicate. `path` as in
/// read_any.
std::unique_ptr<RowReader> read_stored(const InputFile& file, const std::string& path)
{
    const std::string magic = file.beginning(4);
    if (magic == "\x89PNG")
        return read_png(file);
    if (is_exr(file))
        return read_exr(file);
    if (is_jpeg(file))
        return read_jpeg(file);
    if (is_tiff(file))
        return read_tiff(file);
    if (is_open_raster(file))
        return OpenRaster(file).merged();
    if (magic.empty())
        throw std::runtime_error("it is empty");
    const std::string extension = extension_of(path);
    for (const char* known : {"png", "exr", "tif", "tiff", "jpg", "jpeg", "mpo", "ora"})
        if (extension == known)
            throw std::runtime_error(
                "it is broken: its name ends in ." + extension +
                ", but it begins as no PNG, OpenEXR, TIFF, JPEG or OpenRaster does");
    throw std::runtime_error("it is no PNG, OpenEXR, TIFF, JPEG or OpenRaster; convert it first");
}

using OpenView = std::function<std::unique_ptr<RowReader>()>;

std::vector<OpenView> views_of_exr(const InputFile& file)
{
    std::vector<OpenView> views;
    for (int view = 0, count = views_in_exr(file); view < count; ++view)
        views.push_back([&file, view] { return read_exr(file, view); });
    return views;
}

std::vector<OpenView> views_of_tiff(const InputFile& file)
{
    std::vector<OpenView> views;
    for (const int directory : picture_directories_of_tiff(file))
        views.push_back([&file, directory] { return read_tiff(file, directory); });
    return views;
}

/// The pictures of an MPO, each up to the beginning of the next one in the file.
std::vector<OpenView> views_of_mpo(const InputFile& file)
{
    std::vector<std::size_t> places = pictures_in_mpo(file.part(0, file.size()));
    if (places.empty())
        places = {0};
    std::vector<OpenView> views;
    for (const std::size_t place : places) {
        ByteRange range{place, UINT64_MAX};
        for (const std::size_t other : places)
            if (other > place)
                range.count = std::min<std::uint64_t>(range.count, other - place);
        views.push_back([&file, range] { return read_jpeg(file, range); });
    }
    return views;
}

std::vector<OpenView> layers_of_open_raster(const InputFile& file)
{
    const auto raster = std::make_shared<OpenRaster>(file);
    std::vector<OpenView> layers;
    for (std::size_t k = 0; k < raster->names().size(); ++k)
        layers.push_back([raster, k] { return raster->layer(k); });
    return layers;
}

std::vector<OpenView> views_of(const InputFile& file)
{
    if (is_exr(file))
        return views_of_exr(file);
    if (is_tiff(file))
        return views_of_tiff(file);
    if (is_jpeg(file))
        return views_of_mpo(file);
    if (is_open_raster(file))
        return layers_of_open_raster(file);
    return {[&file] { return read_stored(file, ""); }};
}

} // namespace

std::unique_ptr<RowReader> read_any(const InputFile& file, const std::string& path)
{
    return as_shown(read_stored(file, path));
}

std::vector<Image> read_list_of_views(const InputFile& file,
                                      const std::function<void(RowReader&)>& take_notices,
                                      std::size_t most)
{
    std::vector<OpenView> views = views_of(file);
    views.resize(std::min(views.size(), most));
    double bytes = 0;
    for (const OpenView& open : views)
        bytes += size_in_bytes(open()->head().image);
    check_memory(bytes);
    std::vector<Image> pictures;
    for (const OpenView& open : views) {
        const auto reader = as_shown(open());
        pictures.push_back(whole_picture(*reader).image);
        take_notices(*reader);
    }
    return pictures;
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
DecodedImage decode_exr(const std::string& bytes)
{
    return decoded(bytes, [](const InputFile& file) { return read_exr(file); });
}
DecodedImage decode_tiff(const std::string& bytes)
{
    return decoded(bytes, [](const InputFile& file) { return read_tiff(file); });
}

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
