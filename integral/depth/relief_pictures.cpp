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
GreyDepths depths_within(double limit, double distance)
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

/// The eyes of a pair: a disparity d is seen as the parallax (level - d) pixel / spacing.
struct PairEyes {
    double spacing = 0; ///< mm
    double level = 0;   ///< the disparity in the image plane
};

/// The depths of a pair's nearest and farthest parts. Throws std::invalid_argument if they are not
/// in front of the eye, the nearer one first.
GreyDepths pair_depths(const ReliefRequest& request)
{
    const GreyDepths depths = request.grey.value_or(depths_within(request.limit, request.distance));
    if (!(parallax_of(depths.white, request.distance) <
          parallax_of(depths.black, request.distance)))
        throw std::invalid_argument(
            "--depth-range: a pair's nearest depth comes first, is less than "
            "its farthest, and in front of the eye");
    return depths;
}

/// The eyes for which the ends of a range of disparities are seen at two depths (pair_depths).
/// `pixel`: width of a pixel, mm.
PairEyes eyes_of_pair(DisparityRange range, const GreyDepths& depths, double distance, double pixel)
{
    constexpr double least_range = 0.1; // pixels: a flat picture has no depth to stretch
    const double near = parallax_of(depths.white, distance),
                 far = parallax_of(depths.black, distance);
    const double spacing = pixel * std::max(least_range, range.greatest - range.least) /
                           (far - near);
    return {spacing, range.greatest + near * spacing / pixel};
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

/// Reports the depth of a measured pair to the user, and a poor match.
void tell_pair(const std::string& name, const PairDisparity& pair, const GreyDepths& depths,
               const ReliefRequest& request)
{
    constexpr double few = 0.5;
    request.tell(name + ": depth is measured in the pair; nine tenths of it go from " +
                 depth_text(depths.white, "the image plane") + " to " +
                 depth_text(depths.black, "it"));
    if (pair.matched < few)
        request.tell(name + ": only " + with_decimals(100 * pair.matched, 0) +
                     "% of the pixels match in both pictures; check that they show one scene from "
                     "two places at the same height");
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
    const double across = request.size.x / picture.width, down = request.size.y / picture.height;
    PictureRaster raster;
    raster.pixel = request.fit == Fit::cover ? std::max(across, down) : std::min(across, down);
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

std::vector<float> parallax_of_greys(const Image& picture, const GreyDepths& grey, double distance)
{
    if (has_colours(picture))
        throw std::invalid_argument("the map of depths has colours; give a grey one, or a .pfm or "
                                    ".exr file (integral depth -o FILE.pfm)");
    const float white = parallax_of(grey.white, distance),
                black = parallax_of(grey.black, distance);
    if (!(std::isfinite(white) && std::isfinite(black)))
        throw std::invalid_argument("its white or black is behind the eye");
    std::vector<float> parallax;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            parallax.push_back(black + stored_pixel(picture, x, y).g * (white - black));
    return parallax;
}

GreyDepths grey_depths(const std::string& path, const std::string& white, const std::string& black,
                       const ReliefRequest& request)
{
    if (request.grey)
        return *request.grey;
    if (!(request.limit > 0))
        throw std::invalid_argument(path + " is a grey picture: --depth-range WHITE,BLACK "
                                           "tells which depths its white and black are");
    const GreyDepths depths = depths_within(request.limit, request.distance);
    request.tell(path + ": " + white + " is " + depth_text(depths.white, "the image plane") + ", " +
                 black + " " + depth_text(depths.black, "it") +
                 "; --depth-range WHITE,BLACK sets others");
    return depths;
}

ReliefInput read_own_depth(const std::string& path, const ReliefRequest& request, int threads)
{
    ColoursAndDepth picture = request.own == OwnDepth::beside ? halves_of(path)
                                                              : photograph_of(path);
    const GreyDepths depths = request.own == OwnDepth::beside
                                  ? grey_depths(path, "white", "black", request)
                                  : grey_depths(path, "the nearest depth", "the farthest", request);
    const PictureRaster raster = raster_of(picture.colours, request);
    const Image greys = thinned(picture.greys,
                                raster.factor > 1 ? reduction(picture.greys, request.width) : 1);
    std::vector<ReliefPicture> pictures{relief_picture(picture.colours, raster, threads)};
    ReliefMap map = relief_map(greys.width, greys.height, raster,
                               parallax_of_greys(greys, depths, request.distance), 0);
    map.places = places_over(raster.size, greys.width, greys.height);
    std::vector<ReliefMap> maps{std::move(map)};
    return {Relief(std::move(pictures), std::move(maps), request.distance, raster.size),
            form_of(picture.colours)};
}

ReliefInput relief_of_pair(const std::string& name, Image left, Image right,
                           const ReliefRequest& request, int threads, const Progress& progress)
{
    constexpr int map_width = 480; // pixels: of maps; the pictures may have more
    if (left.width != right.width || left.height != right.height)
        throw std::invalid_argument("its two pictures differ in size");
    const GreyDepths depths = pair_depths(request);
    if (request.input.right_to_left)
        std::swap(left, right);
    PictureRaster raster = raster_of(left, request), of_maps = raster;
    of_maps.factor = reduction(left, map_width);
    PairDisparity pair = pair_disparity(averaged(left, of_maps.factor, threads),
                                        averaged(right, of_maps.factor, threads), threads,
                                        progress);
    tell_pair(name, pair, depths, request);
    const double pixel = of_maps.factor * raster.pixel;
    const PairEyes eyes = eyes_of_pair(pair.range, depths, request.distance, pixel);
    std::vector<ReliefPicture> pictures;
    std::vector<ReliefMap> maps;
    for (const double side : {-0.5, 0.5}) {
        std::vector<float>& map = side < 0 ? pair.left : pair.right;
        for (float& d : map)
            d = float((eyes.level - d) * pixel / eyes.spacing);
        pictures.push_back(relief_picture(side < 0 ? left : right, raster, threads));
        maps.push_back(
            relief_map(pair.width, pair.height, of_maps, std::move(map), pictures.size() - 1));
        place_at(pictures.back(), side * eyes.spacing, side * eyes.level * pixel);
        place_at(maps.back(), side * eyes.spacing, side * eyes.level * pixel);
    }
    // The rectangle that both pictures show.
    const Vec2 size{std::max(pixel, raster.size.x - std::fabs(eyes.level) * pixel), raster.size.y};
    return {Relief(std::move(pictures), std::move(maps), request.distance, size), form_of(left)};
}

} // namespace integral
