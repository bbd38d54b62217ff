// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/views/rgbd.h"

#include "integral/replay/replay.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

/// The depths as a frame for replay: red is the depth, green is 1 where there is a surface.
Frame as_frame(const DepthFrame& depths)
{
    FrameMetadata metadata = depths.metadata;
    metadata.film.subpixels = Subpixels(); // a pixel's subpixels have one depth
    Image image = make_image<float>(metadata.film.width, metadata.film.height, 3,
                                    {Encoding::Kind::linear, 1});
    metadata.encoding = image.encoding;
    auto& samples = std::get<std::vector<float>>(image.samples);
    for (std::size_t i = 0; i < depths.depth.size(); ++i)
        if (depths.imaged[i] > 0 && std::isfinite(depths.depth[i])) {
            samples[3 * i] = depths.depth[i];
            samples[3 * i + 1] = 1;
        }
    return {std::move(image), metadata};
}

/// The least and the greatest depth. `values` has three numbers for each pixel: a depth, whether
/// there is a surface, and one that is not used. Throws std::invalid_argument without any surface.
std::pair<double, double> range_of_depths(const std::vector<float>& values)
{
    double nearest = HUGE_VAL, farthest = -HUGE_VAL;
    for (std::size_t i = 0; i < values.size(); i += 3)
        if (values[i + 1] > 0) {
            nearest = std::min(nearest, double(values[i]));
            farthest = std::max(farthest, double(values[i]));
        }
    if (!(nearest <= farthest))
        throw std::invalid_argument("no surface is seen in it");
    return {nearest, farthest};
}

} // namespace

std::optional<RgbdPicture> rgbd_picture(const Frame& frame, const DepthFrame& depths, View view,
                                        int threads, const Progress& progress)
{
    const Film &film = frame.metadata->film, &deep = depths.metadata.film;
    if (film.width != deep.width || film.height != deep.height)
        throw std::invalid_argument("it is of a frame of " + std::to_string(deep.width) + "x" +
                                    std::to_string(deep.height) + " pixels, and this has " +
                                    std::to_string(film.width) + "x" + std::to_string(film.height));
    const int width = view.width, height = view.height;
    view.eye = centre_eye(*frame.metadata);
    const auto colours = replay(frame, view, threads, piece_of(progress, 0, 2));
    view.samples = 1; // a mean of depths is the depth of no surface
    const auto seen = replay(as_frame(depths), view, threads, piece_of(progress, 1, 2));
    if (!colours || !seen)
        return std::nullopt;

    const auto& values = std::get<std::vector<float>>(seen->samples);
    const auto [nearest, farthest] = range_of_depths(values);
    const double eye = view.eye.distance, range = 1 / (eye + nearest) - 1 / (eye + farthest);
    const auto part = [&, farthest = farthest](double depth) { // 0: black, 1: white
        return range > 0 ? (1 / (eye + depth) - 1 / (eye + farthest)) / range : 1;
    };
    Image both = form_of(std::min(16, sample_bits(frame.image)), 2 * width, height, 3, Encoding());
    both = blank_like(both, both.width, both.height);
    const LinearReader light(*colours);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            store_linear(both, x, y, light(x, y));
            const float* at = &values[3 * (std::size_t(y) * width + x)];
            const float grey = at[1] > 0 ? float(part(at[0])) : 0;
            store_pixel(both, width + x, y, {grey, grey, grey, 1});
        }
    return RgbdPicture{std::move(both), nearest, farthest};
}

} // namespace integral
