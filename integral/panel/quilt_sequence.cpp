// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/quilt_sequence.h"

#include "integral/base/number_text.h"

namespace integral {
namespace {

/// Replaces each sample by its entry in the table. `to` has the size of `from`.
template <class From, class To>
void look_up(const Image& from, const std::vector<To>& table, Image& to, int threads)
{
    const std::size_t row = std::size_t(from.width) * std::size_t(from.channels);
    const From* samples = std::get<std::vector<From>>(from.samples).data();
    To* results = std::get<std::vector<To>>(to.samples).data();
    for_each_row(from.height, threads, [&](int y) {
        const std::size_t first = std::size_t(y) * row;
        for (std::size_t i = first; i < first + row; ++i)
            results[i] = table[samples[i]];
    });
}

} // namespace

QuiltSequence::QuiltSequence(PanelImages& images, const std::string& video, const Image& form)
    : images_(images),
      pictures_(images.pictures_of_video(video)),
      mapping_(images.mapping_for(pictures_)),
      in_light_(blends_light(pictures_.blend, images.options()))
{
    if (form.width < pictures_.grid.columns || form.height < pictures_.grid.rows)
        throw RequestError(video + ": " + size_text(form.width, form.height) + " pixels are not " +
                           size_text(pictures_.grid.columns, pictures_.grid.rows) + " equal views");
    if (in_light_)
        values_ = blended_values(form.encoding);
}

/// The quilt in linear light; its memory may come from spare_.
Image QuiltSequence::light_of(const Image& quilt) const
{
    Image light;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!spare_.empty()) {
            light = std::move(spare_.back());
            spare_.pop_back();
        }
    }
    if (light.width == 0)
        light = make_image<std::uint16_t>(quilt.width, quilt.height, quilt.channels,
                                          {Encoding::Kind::linear, 1});
    look_up<std::uint8_t>(quilt, values_.light, light, images_.options().threads);
    return light;
}

Image QuiltSequence::image_of(const Image& quilt) const
{
    const int threads = images_.options().threads;
    const Panel& panel = images_.panel();
    Image light = in_light_ ? light_of(quilt) : Image();
    const ViewRaster raster(in_light_ ? light : quilt, pictures_.grid);
    Image image = panel_image(raster, panel.film.width, panel.film.height);
    interlace(image, raster, mapping_, pictures_.blend, threads);
    if (!panel.calibration) // a calibration's mapping is for the image as it is sent
        image = images_.as_sent(std::move(image));
    if (!in_light_)
        return image;
    Image stored = make_image<std::uint8_t>(image.width, image.height, image.channels,
                                            quilt.encoding);
    look_up<std::uint16_t>(image, values_.stored, stored, threads);
    const std::lock_guard<std::mutex> lock(mutex_);
    spare_.push_back(std::move(light));
    return stored;
}

} // namespace integral
