// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/image_file.h"

#include "integral/base/memory.h"
#include "integral/base/notices.h"
#include "integral/io/codecs.h"
#include "integral/io/open_raster.h"

#include <algorithm>
#include <new>
#include <unistd.h>

namespace integral {
namespace {

[[noreturn]] void throw_input(const std::string& path, const std::string& what)
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
        throw_input(path, "it cannot be read: " + reason_of(error));
    }
}

void pass_notices(const std::string& path, RowReader& rows)
{
    for (const std::string& notice : rows.take_notices())
        give_notice(display_name(path, "standard input") + ": " + notice);
}

/// An open picture file whose metadata has been read.
struct OpenPicture {
    explicit OpenPicture(const std::string& path) : path(path), file(path) { open(); }
    const DecodedImage& head() const { return rows->head(); }
    void open()
    {
        rows = guarded(path, [&] { return read_any(file, path); });
        pass_notices(path, *rows);
    }
    void read(Image& band)
    {
        guarded(path, [&] { rows->read(band); });
        pass_notices(path, *rows);
    }
    Image whole()
    {
        Image all = guarded(path, [&] { return whole_blank(head().image); });
        read(all);
        return all;
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
        throw_input(path, std::string("its geometry cannot be used: ") + error.what() + help);
    }
}

/// Path of the JSON document next to a picture that carries none itself; empty if there is none.
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

} // namespace

struct FrameReader::Source {
    Source(const std::string& path, const std::string& sheet_file) : picture(path)
    {
        frame.image = picture.head().image;
        const auto metadata = geometry_for(path, sheet_file, picture.head().document);
        if (!metadata)
            return;
        // A separate sheet file does not contain this picture's encoding.
        if (sheet_file.empty() && !picture.head().colours_converted)
            frame.image.encoding = metadata->encoding;
        holds_views = metadata->quilt.has_value();
        if (holds_views)
            return;
        try {
            set_metadata(frame, *metadata);
        } catch (const std::invalid_argument& error) {
            throw_input(path,
                        std::string(error.what()) +
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
        throw_input(
            path, "it holds views of a frame, not a frame; integral views --to-frame makes one of "
                  "them");
    if (!source_->frame.metadata)
        throw_input(path, std::string("it carries no `integral` metadata") + give_sheet +
                              " (integral sheet --json writes one)");
}

void FrameReader::refuse_projection() const
{
    if (source_->frame.metadata && source_->frame.metadata->projection)
        throw_input(source_->picture.path,
                    "frames for a projection lens are not supported here; use integral replay");
}

void FrameReader::read(Image& band) { source_->picture.read(band); }

Frame FrameReader::whole()
{
    Frame frame = source_->frame;
    frame.image.samples = source_->picture.whole().samples;
    return frame;
}

void FrameReader::restart() { source_->picture.open(); }

Frame read_frame(const std::string& path, const std::string& sheet_file)
{
    return FrameReader(path, sheet_file).whole();
}

struct ViewsReader::Source {
    explicit Source(const std::string& path) : picture(path) {}
    OpenPicture picture;
    Views views;
};

ViewsReader::ViewsReader(const std::string& path, bool needs_geometry)
    : source_(std::make_unique<Source>(path))
{
    Views& views = source_->views;
    const DecodedImage& head = source_->picture.head();
    views.image = head.image;
    try {
        views.metadata = geometry_for(path, "", head.document);
    } catch (const InputError&) {
        if (needs_geometry)
            throw;
    }
    if (views.metadata && !head.colours_converted)
        views.image.encoding = views.metadata->encoding;
    if (views.metadata && !views.metadata->quilt)
        views.metadata.reset();
}

ViewsReader::~ViewsReader() = default;

const Views& ViewsReader::head() const { return source_->views; }

void ViewsReader::read(Image& band) { source_->picture.read(band); }

Views ViewsReader::whole()
{
    Views views = source_->views;
    views.image.samples = source_->picture.whole().samples;
    return views;
}

void ViewsReader::check_memory() const
{
    guarded(source_->picture.path, [&] { integral::check_memory(size_in_bytes(head().image)); });
}

Views read_views(const std::string& path, bool needs_geometry)
{
    return ViewsReader(path, needs_geometry).whole();
}

bool is_mpo(const std::string& path) { return extension_of(path) == "mpo"; }

bool is_list_of_views(const std::string& path)
{
    if (is_mpo(path))
        return true;
    if (extension_of(path) != "exr")
        return false;
    const InputFile file(path);
    return guarded(path, [&] { return views_in_exr(file) > 1; });
}

std::vector<Image> read_list_of_views(const std::string& path, std::size_t most)
{
    const InputFile file(path);
    return guarded(path, [&] {
        return read_list_of_views(
            file, [&](RowReader& rows) { pass_notices(path, rows); }, most);
    });
}

std::vector<std::string> names_of_layers(const std::string& path)
{
    const InputFile file(path);
    return guarded(path, [&] {
        if (!is_open_raster(file))
            throw std::runtime_error("it is no OpenRaster file, whose ZIP begins with an "
                                     "uncompressed mimetype; save it by a painting program");
        std::vector<std::string> names = OpenRaster(file).names();
        if (names.empty())
            throw std::runtime_error("none of its layers is visible; show those that the frame is "
                                     "to have");
        return names;
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
        throw_input(path, reason_of(error));
    } catch (const std::exception& error) {
        throw_input(path,
                    std::string("it is neither a JSON document nor a frame: ") + error.what());
    }
    if (!metadata)
        metadata = geometry_for(path, "", document);
    if (!metadata)
        throw_input(path, "it carries no `integral` metadata");
    metadata->quilt.reset();
    return *metadata;
}

DepthFrame read_depths(const std::string& path)
{
    DecodedDepths file = guarded(path, [&] { return decode_depths(read_file(path)); });
    if (file.document.empty())
        throw_input(path, "it carries no `integral` metadata; Integral_Depth_Image=FILE.exr writes "
                          "depth frames that do");
    DepthFrame frame{std::move(file.depth), std::move(file.imaged), parse(path, file.document, ""),
                     std::move(file.eye_distances)};
    if (frame.metadata.film.width != file.width || frame.metadata.film.height != file.height)
        throw_input(path, "its geometry is of a frame of another size");
    return frame;
}

} // namespace integral
