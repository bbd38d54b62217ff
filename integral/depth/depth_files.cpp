// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/depth_files.h"

#include "integral/base/file_bytes.h"
#include "integral/depth/depth_picture_scale.h"
#include "integral/frame/depth_attribute.h"
#include "integral/io/codecs.h"
#include "integral/io/image_file.h"
#include "integral/io/pfm_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace integral {
namespace {

constexpr float one_surface = 0.15f; ///< disparity: a smaller step lies within one surface

/// The four pixels around a place, and their weights.
struct Corners {
    std::size_t at[4];
    float weight[4];
};

std::optional<Corners> corners_at(const ViewSet& views, Vec2 place)
{
    if (!(place.x >= -0.5 && place.y >= -0.5 && place.x <= views.width - 0.5 &&
          place.y <= views.height - 0.5))
        return std::nullopt;
    const double x = std::clamp(place.x, 0.0, views.width - 1.0),
                 y = std::clamp(place.y, 0.0, views.height - 1.0);
    const int left = std::min(int(x), std::max(0, views.width - 2)),
              top = std::min(int(y), std::max(0, views.height - 2));
    Corners corners;
    for (int k = 0; k < 4; ++k) {
        const int i = std::min(left + k % 2, views.width - 1),
                  j = std::min(top + k / 2, views.height - 1);
        corners.at[k] = std::size_t(j) * views.width + i;
        corners.weight[k] = float((k % 2 ? x - left : 1 - (x - left)) *
                                  (k / 2 ? y - top : 1 - (y - top)));
    }
    return corners;
}

float between(const std::vector<float>& values, const Corners& corners)
{
    float sum = 0;
    for (int k = 0; k < 4; ++k)
        sum += corners.weight[k] * values[corners.at[k]];
    return sum;
}

/// Interpolates linearly within a surface; takes the nearest corner across a step or next to NaN.
float depth_between(const std::vector<float>& values, const Corners& corners)
{
    const auto nearest = std::max_element(corners.weight, corners.weight + 4) - corners.weight;
    const float own = values[corners.at[nearest]];
    for (const std::size_t at : corners.at)
        if (!(std::fabs(values[at] - own) < one_surface))
            return own;
    return between(values, corners);
}

void put(std::string& bytes, const void* value, std::size_t size)
{
    bytes.append(static_cast<const char*>(value), size);
}

/// The text of a .ply file: the points, at known depths, on the lines of sight through the pixels.
std::string ply_of(const UprightMap& map)
{
    if (!map.scale)
        throw std::invalid_argument("points need millimetres, and the views do not say where they "
                                    "were taken from; --eyes would tell");
    const std::vector<float> depths = map.depths();
    std::string points;
    std::size_t count = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const std::size_t at = std::size_t(y) * map.width + x;
            if (!std::isfinite(depths[at]))
                continue;
            const double spread = map.pixel * (map.scale->distance + depths[at]) /
                                  map.scale->distance;
            const float place[] = {float((x - 0.5 * (map.width - 1)) * spread),
                                   float((0.5 * (map.height - 1) - y) * spread), depths[at]};
            put(points, place, sizeof place);
            for (const auto& channel : map.colour)
                points += char(std::lround(255 * std::clamp(channel[at], 0.0f, 1.0f)));
            put(points, &map.confidence[at], sizeof(float));
            ++count;
        }
    return "ply\nformat binary_little_endian 1.0\ncomment millimetres; z is behind the sheet\n"
           "element vertex " +
           std::to_string(count) +
           "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
           "property uchar green\nproperty uchar blue\nproperty float confidence\nend_header\n" +
           points;
}

std::string exr_of(const UprightMap& map, bool as_disparity)
{
    std::vector<float> depths = map.depths(), disparity = map.disparity, known;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        known.push_back(std::isnan(depths[i]) ? 0.0f : 1.0f);
        if (known.back() == 0)
            depths[i] = disparity[i] = 0;
    }
    const bool in_mm = map.scale && !as_disparity;
    std::vector<NamedFloats> channels = {{"A", &known},
                                         {"Y", in_mm ? &depths : &disparity},
                                         {"confidence", &map.confidence},
                                         {"disparity", &disparity}};
    if (map.scale)
        channels.push_back({"Z", &depths});
    return encode_depths(map.width, map.height, channels, in_mm ? depth_in_mm : depth_as_disparity,
                         "");
}

} // namespace

std::vector<float> UprightMap::depths() const
{
    std::vector<float> depths = disparity;
    if (scale)
        for (float& d : depths)
            d = std::isnan(d) ? d : float(scale->mm(d));
    return depths;
}

UprightMap upright_map(const ViewSet& views, const DepthMap& map, double width_mm, double height_mm,
                       int columns)
{
    UprightMap upright;
    const double area = length(views.places.right) * length(views.places.down);
    upright.width = columns > 0 ? columns
                                : std::max(1, int(std::lround(width_mm / std::sqrt(area))));
    upright.pixel = width_mm / upright.width;
    upright.height = std::max(1, int(std::lround(height_mm / upright.pixel)));
    upright.scale = views.scale;
    for (int y = 0; y < upright.height; ++y)
        for (int x = 0; x < upright.width; ++x) {
            const Vec2 point{(x - 0.5 * (upright.width - 1)) * upright.pixel,
                             (0.5 * (upright.height - 1) - y) * upright.pixel};
            const auto corners = corners_at(views, views.places.pixel_at(point));
            upright.disparity.push_back(corners ? depth_between(map.disparity, *corners) : NAN);
            upright.confidence.push_back(corners ? between(map.confidence, *corners) : 0);
            for (std::size_t c = 0; c < 3; ++c)
                upright.colour[c].push_back(corners ? between(views.colours[c], *corners) : 0);
        }
    return upright;
}

bool is_depth_file(const std::string& path)
{
    const std::string extension = extension_of(path);
    return extension == "pfm" || extension == "exr" || extension == "png" || extension == "ply";
}

void write_depth(const std::string& path, const UprightMap& map, bool as_disparity)
{
    const std::string extension = extension_of(path);
    if (extension == "pfm")
        write_pfm(path, {map.width, map.height, as_disparity ? map.disparity : map.depths()});
    else if (extension == "exr")
        write_file(path, exr_of(map, as_disparity));
    else if (extension == "ply")
        write_file(path, ply_of(map));
    else
        write_file(path, encode_png({depth_picture_with_scale(map), "", std::nullopt}));
}

DisparityRange shown_range(const UprightMap& map)
{
    std::vector<float> known;
    for (const float d : map.disparity)
        if (std::isfinite(d))
            known.push_back(d);
    if (known.empty())
        return {-1, 1};
    std::sort(known.begin(), known.end());
    const auto part = [&](double p) {
        return double(known[std::size_t(p * (known.size() - 1.0))]);
    };
    const double least = part(0.005), greatest = part(0.995);
    return {least, std::max(greatest, least + 1e-3)};
}

DisparityRange write_rgbd(const std::string& path, const UprightMap& map)
{
    const DisparityRange range = shown_range(map);
    const double span = range.greatest - range.least;
    Image both = make_image<std::uint16_t>(2 * map.width, map.height, 3, Encoding());
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const std::size_t at = std::size_t(y) * map.width + x;
            store_pixel(both, x, y, {map.colour[0][at], map.colour[1][at], map.colour[2][at], 1});
            const double part = (map.disparity[at] - range.least) / span;
            const float grey = std::isfinite(part) ? float(part) : 0;
            store_pixel(both, map.width + x, y, {grey, grey, grey, 1});
        }
    write_frame(path, Frame{std::move(both), std::nullopt});
    return range;
}

} // namespace integral
