// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/open_raster.h"

#include "integral/base/interrupt.h"
#include "integral/base/memory.h"
#include "integral/io/as_shown.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <zip.h>

namespace integral {
namespace {

/// Name and content of the first entry of an OpenRaster file's ZIP.
constexpr char media_type[] = "mimetypeimage/openraster";
constexpr std::uint64_t media_type_at = 30;

struct CloseZip {
    void operator()(zip_t* zip) const { zip_discard(zip); }
};
struct CloseEntry {
    void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};

/// Bytes that outlive the reader of their PNG.
class ArchivedPng : public RowReader {
public:
    explicit ArchivedPng(std::string bytes)
        : bytes_(std::move(bytes)), file_(InputFile::of_bytes(bytes_)), rows_(read_png(file_))
    {
        head_ = rows_->head();
    }
    void read(Image& band) override { rows_->read(band); }
    std::vector<std::string> take_notices() override { return rows_->take_notices(); }

private:
    std::string bytes_;
    InputFile file_;
    std::unique_ptr<RowReader> rows_;
};

/// Draws `picture` over floats that are premultiplied as they are encoded, as painting programs do.
void draw_over(const Image& picture, int left, int top, double opacity, Image& canvas)
{
    auto& to = std::get<std::vector<float>>(canvas.samples);
    const int first = std::max(0, -left), last = std::min(picture.width, canvas.width - left);
    for (int y = std::max(0, -top); y < std::min(picture.height, canvas.height - top); ++y)
        for (int x = first; x < last; ++x) {
            Colour c = stored_pixel(picture, x, y);
            if (!picture.premultiplied)
                c = {c.r * c.a, c.g * c.a, c.b * c.a, c.a};
            float* pixel = &to[first_sample(canvas, left + x, top + y)];
            const float own = float(opacity), below = 1 - own * c.a;
            const float light[] = {c.r, c.g, c.b, c.a};
            for (int k = 0; k < 4; ++k)
                pixel[k] = own * light[k] + below * pixel[k];
        }
}

Image blank_canvas(int width, int height)
{
    Image canvas = whole_blank(form_of(32, width, height, 4, Encoding{}));
    canvas.premultiplied = true; // as encoded: see draw_over
    return canvas;
}

} // namespace

struct OpenRaster::Archive {
    std::string bytes;
    std::unique_ptr<zip_t, CloseZip> zip;

    /// The bytes of an entry. Throws std::runtime_error.
    std::string entry(const std::string& name) const
    {
        constexpr double deflate_ratio = 1100;
        zip_stat_t about;
        zip_stat_init(&about);
        if (zip_stat(zip.get(), name.c_str(), 0, &about) != 0 || !(about.valid & ZIP_STAT_SIZE))
            throw std::runtime_error("it has no " + name);
        check_plausible_size(double(about.size), double(bytes.size()), deflate_ratio);
        check_memory(double(about.size));
        const std::unique_ptr<zip_file_t, CloseEntry> file(
            zip_fopen_index(zip.get(), about.index, 0));
        std::string content(about.size, '\0');
        if (!file || zip_fread(file.get(), content.data(), about.size) != zip_int64_t(about.size))
            throw std::runtime_error("its " + name + " cannot be read");
        return content;
    }

    /// Throws std::runtime_error, and Interrupted.
    Image picture(const std::string& name) const
    {
        constexpr double most_pixels = 1e10; // of all layers: minutes
        stop_if_interrupted();
        const auto reader = as_shown(std::make_unique<ArchivedPng>(entry(name)));
        const Image& form = reader->head().image;
        decoded_pixels += double(form.width) * form.height;
        if (decoded_pixels > most_pixels)
            throw std::runtime_error("its layers have more than 1e10 pixels together");
        return whole_picture(*reader).image;
    }

    mutable double decoded_pixels = 0;
};

/// Draws a layer, or what is inside a group, when the first row is read.
class OpenRaster::LayerReader : public RowReader {
public:
    LayerReader(std::shared_ptr<const Archive> archive, const StackedLayer& layer, int width,
                int height)
        : archive_(std::move(archive)), layer_(layer)
    {
        head_.image = form_of(bits_of(layer), width, height, 4, Encoding{});
    }

    void read(Image& band) override
    {
        if (next_ == 0) {
            Image canvas = blank_canvas(head_.image.width, head_.image.height);
            draw(layer_, 0, 0, canvas);
            whole_ = unmultiplied(canvas);
        }
        band.samples = rows_of(whole_, next_, band.height).samples;
        next_ += band.height;
    }

private:
    /// The most bits of any picture inside.
    int bits_of(const StackedLayer& layer) const
    {
        stop_if_interrupted();
        if (!layer.source.empty())
            return sample_bits(ArchivedPng(archive_->entry(layer.source)).head().image);
        int bits = 8;
        for (const StackedLayer& inside : layer.inside)
            if (inside.visible)
                bits = std::max(bits, bits_of(inside));
        return bits;
    }

    void draw(const StackedLayer& layer, int left, int top, Image& canvas) const
    {
        if (layer.blending != "svg:src-over")
            throw std::runtime_error("its layer \"" + layer.name + "\" is blended by " +
                                     layer.blending +
                                     ", which needs the layer below; merge the two");
        left += layer.left;
        top += layer.top;
        if (!layer.source.empty()) {
            draw_over(archive_->picture(layer.source), left, top, layer.opacity, canvas);
            return;
        }
        Image group = blank_canvas(canvas.width, canvas.height);
        for (auto inside = layer.inside.rbegin(); inside != layer.inside.rend(); ++inside)
            if (inside->visible)
                draw(*inside, left, top, group);
        draw_over(group, 0, 0, layer.opacity, canvas);
    }

    /// The canvas's colours divided by alpha, in the picture's form.
    Image unmultiplied(const Image& canvas) const
    {
        Image picture = whole_blank(head_.image);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                Colour c = stored_pixel(canvas, x, y);
                if (c.a > 0)
                    c = {c.r / c.a, c.g / c.a, c.b / c.a, c.a};
                store_pixel(picture, x, y, c);
            }
        return picture;
    }

    std::shared_ptr<const Archive> archive_;
    StackedLayer layer_;
    Image whole_;
    int next_ = 0;
};

bool is_open_raster(const InputFile& file)
{
    return file.beginning(2) == "PK" &&
           file.part(media_type_at, sizeof media_type - 1) == media_type;
}

OpenRaster::OpenRaster(const InputFile& file)
{
    const auto archive = std::make_shared<Archive>();
    check_memory(double(file.size()));
    archive->bytes = file.part(0, file.size());
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(archive->bytes.data(), archive->bytes.size(), 0,
                                                    &error);
    if (source)
        archive->zip.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
    if (!archive->zip) {
        const std::string reason = zip_error_strerror(&error);
        zip_error_fini(&error);
        if (source)
            zip_source_free(source);
        throw std::runtime_error("it is broken: as a ZIP, " + reason);
    }
    LayerStack stack = layer_stack_of(archive->entry("stack.xml"));
    width_ = stack.width;
    height_ = stack.height;
    std::vector<StackedLayer>& all = stack.root.inside;
    for (auto layer = all.rbegin(); layer != all.rend(); ++layer)
        if (layer->visible)
            layers_.push_back(std::move(*layer));
    archive_ = archive;
}

std::vector<std::string> OpenRaster::names() const
{
    std::vector<std::string> names;
    for (const StackedLayer& layer : layers_)
        names.push_back(layer.name);
    return names;
}

std::unique_ptr<RowReader> OpenRaster::layer(std::size_t index) const
{
    return std::make_unique<LayerReader>(archive_, layers_.at(index), width_, height_);
}

std::unique_ptr<RowReader> OpenRaster::merged() const
{
    return std::make_unique<ArchivedPng>(archive_->entry("mergedimage.png"));
}

} // namespace integral
