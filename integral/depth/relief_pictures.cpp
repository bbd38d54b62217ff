// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/relief_pictures.h"

#include "integral/base/number_text.h"
#include "integral/depth/averaged.h"
#include "integral/depth/stereo_pair.h"
#include "integral/io/embedded_depth.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace integral {
namespace {

/// The depths, equal in parallax, that `limit` mm behind the image plane implies before and behind
/// it.
DepthSpan depths_within(double limit, double distance)
{
    const double parallax = limit / (distance + limit);
    return {-distance * parallax / (1 + parallax), limit};
}

/// Text of a depth: "3.8 mm behind it", or "in front of it".
std::string depth_text(double mm, const std::string& plane)
{
    return with_decimals(std::fabs(mm), 1) + " mm " + (mm < 0 ? "in front of " : "behind ") + plane;
}

/// A map of pixels on a raster, for the picture with that index.
ReliefMap relief_map(int width, int height, const PictureRaster& raster,
                     std::vector<float> parallax, std::size_t picture)
{
    ReliefMap map;
    map.width = width;
    map.height = height;
    map.places = raster.places();
    map.parallax = std::move(parallax);
    map.picture = picture;
    return map;
}

/// Moves one of a pair's pictures, or its map, to its eye, and sideways by `shift` mm.
template <class Seen> void place_at(Seen& seen, double eye, double shift)
{
    seen.eye = {eye, 0};
    seen.places.first.x += shift;
}

/// A picture, and its depths as greys.
struct ColoursAndDepth {
    Image colours, greys;
};

ColoursAndDepth halves_of(const std::string& path)
{
    const Image both = read_frame(path).image;
    const int width = both.width / 2;
    if (width < 1)
        throw std::invalid_argument("it has no right half with depths");
    return {part_of(both, 0, 0, width, both.height),
            part_of(both, both.width - width, 0, width, both.height)};
}

ColoursAndDepth photograph_of(const std::string& path)
{
    auto greys = embedded_depth(path);
    if (!greys)
        throw std::invalid_argument("it has no depth inside, as phones store it; --depth FILE or "
                                    "--depth beside name another place");
    return {read_frame(path).image, std::move(*greys)};
}

/// Whether a map of depths has colours: in more than a twentieth of its pixels the channels differ
/// by more than JPEG's losses, also next to the colours of an RGBD picture's left half.
bool has_colours(const Image& map)
{
    constexpr float lost = 16.0F / 255;
    constexpr int share = 20;
    std::int64_t coloured = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const auto c = stored_pixel(map, x, y);
            coloured += std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}) > lost;
        }
    return coloured * share > std::int64_t(map.width) * map.height;
}

} // namespace

PixelPlaces PictureRaster::places() const
{
    const double step = factor * pixel;
    return {{-0.5 * size.x + 0.5 * step, 0.5 * size.y - 0.5 * step}, {step, 0}, {0, -step}};
}

PixelPlaces places_over(Vec2 size, int width, int height)
{
    const Vec2 pixel{size.x / width, size.y / height};
    return {
        {-0.5 * (width - 1) * pixel.x, 0.5 * (height - 1) * pixel.y}, {pixel.x, 0}, {0, -pixel.y}};
}

PictureRaster raster_of(const Image& picture, const ReliefRequest& request)
{
    PictureRaster raster;
    raster.pixel = enlargement({double(picture.width), double(picture.height)}, request.size,
                               request.fit);
    raster.size = {picture.width * raster.pixel, picture.height * raster.pixel};
    raster.factor = request.width > 0 ? reduction(picture, request.width) : 1;
    return raster;
}

ReliefPicture relief_picture(const Image& picture, const PictureRaster& raster, int threads)
{
    const Image small = averaged(picture, raster.factor, threads);
    ReliefPicture made;
    made.width = small.width;
    made.height = small.height;
    made.places = raster.places();
    const LinearReader light(small);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            const Colour c = light(x, y);
            made.light[0].push_back(c.r);
            made.light[1].push_back(c.g);
            made.light[2].push_back(c.b);
        }
    return made;
}

float parallax_of(double mm, double distance)
{
    if (std::isinf(mm) && mm > 0)
        return 1;
    return mm > -distance ? float(mm / (distance + mm)) : NAN;
}

std::vector<float> parallax_of_greys(const Image& picture)
{
    if (has_colours(picture))
        throw std::invalid_argument("the map of depths has colours; give a grey one, or a .pfm or "
                                    ".exr file (integral depth -o FILE.pfm)");
    std::vector<float> parallax;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            parallax.push_back(1 - stored_pixel(picture, x, y).g);
    return parallax;
}

ParallaxSpan requested_span(const std::string& path, const ReliefRequest& request, double distance)
{
    const auto range_of = [&](const DepthSpan& depths) {
        return ParallaxSpan{parallax_of(depths.near, distance), parallax_of(depths.far, distance)};
    };
    if (request.ends) {
        const ParallaxSpan range = range_of(*request.ends);
        if (!(std::isfinite(range.near) && std::isfinite(range.far)))
            throw std::invalid_argument("--depth-range: one of its depths is behind the eye");
        return range;
    }
    if (!(request.limit > 0))
        throw std::invalid_argument(path + " is a grey picture: --depth-range WHITE,BLACK "
                                           "tells which depths its white and black are");
    const DepthSpan depths = depths_within(request.limit, distance);
    const bool as_greys = request.own == OwnDepth::beside || !request.depth_file.empty();
    request.tell(path + ": " + (as_greys ? "white" : "the nearest depth") + " is " +
                 depth_text(depths.near, "the image plane") + ", " +
                 (as_greys ? "black " : "the farthest ") + depth_text(depths.far, "it") +
                 "; --depth-range WHITE,BLACK sets others");
    return range_of(depths);
}

ReliefInput read_own_depth(const std::string& path, const ReliefRequest& request, int threads)
{
    ColoursAndDepth picture = request.own == OwnDepth::beside ? halves_of(path)
                                                              : photograph_of(path);
    const PictureRaster raster = raster_of(picture.colours, request);
    const Image& greys = picture.greys;
    std::vector<ReliefPicture> pictures{relief_picture(picture.colours, raster, threads)};
    ReliefMap map = relief_map(greys.width, greys.height, raster, parallax_of_greys(greys), 0);
    map.places = places_over(raster.size, greys.width, greys.height);
    std::vector<ReliefMap> maps{std::move(map)};
    return {Relief(std::move(pictures), std::move(maps), request.distance, raster.size),
            form_of(picture.colours), DepthUnit::none};
}

ReliefInput relief_of_pair(const std::string& name, Image left, Image right,
                           const ReliefRequest& request, int threads, const Progress& progress)
{
    constexpr int map_width = 480;    // pixels: of maps; the pictures may have more
    constexpr double least_range = 1; // pixels: a flat picture has no depth to stretch
    constexpr double few = 0.5;       // of the pixels
    if (left.width != right.width || left.height != right.height)
        throw std::invalid_argument("its two pictures differ in size");
    if (request.input.right_to_left)
        std::swap(left, right);
    PictureRaster raster = raster_of(left, request), of_maps = raster;
    of_maps.factor = reduction(left, map_width);
    PairDisparity pair = pair_disparity(averaged(left, of_maps.factor, threads),
                                        averaged(right, of_maps.factor, threads), threads,
                                        progress);
    if (pair.matched < few)
        request.tell(name + ": only " + with_decimals(100 * pair.matched, 0) +
                     "% of the pixels match in both pictures; check that they show one scene from "
                     "two places at the same height");
    // A disparity d is seen as the parallax (greatest - d) / range.
    const double pixel = of_maps.factor * raster.pixel, greatest = pair.range.greatest,
                 range = std::max(least_range, greatest - pair.range.least);
    std::vector<ReliefPicture> pictures;
    std::vector<ReliefMap> maps;
    for (const double side : {-0.5, 0.5}) {
        std::vector<float>& map = side < 0 ? pair.left : pair.right;
        for (float& d : map)
            d = float((greatest - d) / range);
        pictures.push_back(relief_picture(side < 0 ? left : right, raster, threads));
        maps.push_back(
            relief_map(pair.width, pair.height, of_maps, std::move(map), pictures.size() - 1));
        place_at(pictures.back(), side * range * pixel, side * greatest * pixel);
        place_at(maps.back(), side * range * pixel, side * greatest * pixel);
    }
    return {Relief(std::move(pictures), std::move(maps), request.distance, raster.size),
            form_of(left), DepthUnit::pair};
}

} // namespace integral
