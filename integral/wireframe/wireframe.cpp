// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/wireframe/wireframe.h"

#include "integral/wireframe/block_mesh.h"
#include "integral/wireframe/lens_drawing.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>

namespace integral {
namespace {

constexpr int any_channel = -1;

/// Colours that are drawn together: all, or one of a film with striped subpixels.
struct Channel {
    int channel;
    Vec2 shift; ///< pixels, +y down
};

std::vector<Channel> channels_of(const Film& film)
{
    if (film.subpixels == Subpixels::cells)
        throw std::invalid_argument("its film has subpixels in cells; wireframes are drawn for "
                                    "films with stripes or without subpixels");
    if (film.subpixels == Subpixels::none)
        return {{any_channel, {}}};
    std::vector<Channel> channels;
    for (int channel = 0; channel < 3; ++channel)
        channels.push_back({channel, subpixel_shift(film.subpixels, {0.5, 0.5}, channel)});
    return channels;
}

LensRange window_of(const LensPixels& pixels)
{
    LensRange window{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    for (int k = 0; k < pixels.count(); ++k) {
        const LensIndex lens = pixels.lens(k);
        window.i = std::min(window.i, std::int32_t(lens.i));
        window.j = std::min(window.j, std::int32_t(lens.j));
        window.last_i = std::max(window.last_i, std::int32_t(lens.i));
        window.last_j = std::max(window.last_j, std::int32_t(lens.j));
    }
    return window;
}

class FrameDrawing {
public:
    FrameDrawing(const WireframeRequest& request, const Channel& channel, Image& image, int threads)
        : request_(request),
          channel_(channel),
          image_(image),
          pixels_(request.optics, request.film, request.mapping, channel.shift, threads),
          bundles_(bundles_of(request.optics, request.samples)),
          window_(window_of(pixels_)),
          threads_(threads)
    {
    }

    bool draw(const Progress& progress, WireframeCost& cost)
    {
        cost.lenses = std::max(cost.lenses, pixels_.count());
        if (pixels_.count() == 0)
            return true;
        const MeshBlocks blocks(request_, window_);
        std::vector<std::vector<int>> lenses(std::size_t(blocks.count()));
        for (int k = 0; k < pixels_.count(); ++k)
            lenses[std::size_t(blocks.block_of(pixels_.lens(k)))].push_back(k);
        std::mutex adding;
        return for_each_row(
            int(lenses.size()), threads_,
            [&](int number) {
                const BlockMesh block = blocks.block(number);
                VertexFilm vertices(request_, block, channel_.shift);
                LensRaster raster;
                for (const int lens : lenses[std::size_t(number)])
                    draw_lens(lens, blocks.number_in_block(pixels_.lens(lens)), vertices, raster);
                const std::lock_guard<std::mutex> lock(adding);
                cost.projections += vertices.projections() / double(bundles_.size());
            },
            progress);
    }

private:
    void draw_lens(int number, int number_in_block, VertexFilm& vertices, LensRaster& raster)
    {
        const LensIndex lens = pixels_.lens(number);
        raster.begin(pixels_.begin(number), pixels_.end(number));
        std::vector<Colour> light(raster.size());
        for (const RayBundle& bundle : bundles_) {
            vertices.begin(lens, number_in_block, bundle.rays, raster);
            for (const SharpPicture& picture : bundle.pictures) {
                raster.clear();
                LensDrawing(request_, lens, channel_.shift, picture, vertices, raster).draw_all();
                add(raster, float(picture.weight), light);
            }
        }
        raster.for_each_pixel_in(
            raster.box(), [&](std::size_t index, int x, int y) { store(x, y, light[index]); });
    }

    void add(const LensRaster& raster, float weight, std::vector<Colour>& light) const
    {
        for (std::size_t k = 0; k < light.size(); ++k) {
            const Colour c = raster.is_drawn(k) ? raster.colour(k) : request_.background;
            light[k].r += weight * c.r;
            light[k].g += weight * c.g;
            light[k].b += weight * c.b;
        }
    }

    void store(int x, int y, Colour linear)
    {
        if (linear.r == 0 && linear.g == 0 && linear.b == 0)
            return; // black, as the image already is
        if (channel_.channel == any_channel)
            return store_linear(image_, x, y, linear);
        const Colour before = stored_pixel(image_, x, y);
        store_linear(image_, x, y, linear);
        Colour after = stored_pixel(image_, x, y);
        (channel_.channel == 0 ? after.g : after.r) = channel_.channel == 0 ? before.g : before.r;
        (channel_.channel == 2 ? after.g : after.b) = channel_.channel == 2 ? before.g : before.b;
        store_pixel(image_, x, y, after);
    }

    const WireframeRequest& request_;
    const Channel channel_;
    Image& image_;
    LensPixels pixels_;
    std::vector<RayBundle> bundles_;
    LensRange window_;
    int threads_;
};

} // namespace

std::optional<Image> draw_wireframe(const WireframeRequest& request, int bits, int threads,
                                    const Progress& progress, WireframeCost& cost)
{
    const Film& film = request.film;
    Encoding encoding;
    encoding.kind = bits == 32 ? Encoding::Kind::linear : Encoding::Kind::srgb;
    Image image = blank_like(form_of(bits, film.width, film.height, 3, encoding), film.width,
                             film.height);
    const auto channels = channels_of(film);
    for (std::size_t k = 0; k < channels.size(); ++k) {
        FrameDrawing drawing(request, channels[k], image, threads);
        if (!drawing.draw(piece_of(progress, int(k), int(channels.size())), cost))
            return std::nullopt;
    }
    cost.projections /= double(channels.size());
    return image;
}

} // namespace integral
