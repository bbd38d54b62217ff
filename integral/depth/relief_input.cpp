// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/relief_input.h"

#include "integral/base/interrupt.h"
#include "integral/depth/depth_scores.h"
#include "integral/depth/relief_pictures.h"
#include "integral/frame/quilt_name.h"
#include "integral/io/codecs.h"
#include "integral/io/embedded_depth.h"
#include "integral/io/image_file.h"
#include "integral/io/pfm_file.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

/// Numbers of the middle view and the outermost ones, as in ReliefMap::picture.
std::vector<std::size_t> outermost(const ViewSet& views)
{
    std::vector<std::size_t> chosen{0};
    for (int corner = 0; corner < 4; ++corner) {
        const Vec2 way{corner % 2 ? 1.0 : -1.0, corner / 2 ? 1.0 : -1.0};
        std::size_t best = 0;
        double farthest = 0;
        for (std::size_t k = 0; k < views.others.size(); ++k)
            if (const double far = dot(way, views.others[k].shift); far > farthest + 1e-9) {
                farthest = far;
                best = k + 1;
            }
        if (std::find(chosen.begin(), chosen.end(), best) == chosen.end())
            chosen.push_back(best);
    }
    return chosen;
}

const DepthView& view_number(const ViewSet& views, std::size_t k)
{
    return k == 0 ? views.middle : views.others[k - 1];
}

/// The views for measuring the depth of view number `middle`: this view becomes the set's middle
/// view, the views that `quality` does not use are left out, and all are softened (soften).
ViewSet seen_from(const ViewSet& views, std::size_t middle, DepthQuality quality, int threads)
{
    ViewSet set;
    set.width = views.width;
    set.height = views.height;
    set.places = views.places;
    set.scale = views.scale;
    const Vec2 step = view_number(views, middle).shift;
    for (std::size_t k = 0; k <= views.others.size(); ++k) {
        const DepthView& view = view_number(views, k);
        const Vec2 shift = view.shift - step;
        if (k != middle && !is_kept(shift, quality))
            continue;
        DepthView& copy = k == middle ? set.middle : set.others.emplace_back();
        copy = view;
        copy.shift = shift;
    }
    soften(set, threads);
    return set;
}

ReliefMap map_of_view(const ViewSet& views, std::size_t k)
{
    ReliefMap map;
    map.eye = eye_of(views, view_number(views, k));
    map.width = views.width;
    map.height = views.height;
    map.places = views.places;
    map.picture = k;
    return map;
}

std::vector<ReliefMap> measured_maps(const ViewSet& views, DepthQuality quality, int threads,
                                     const Progress& progress)
{
    MultibaselineSettings settings = settings_for(quality);
    const std::vector<std::size_t> chosen = outermost(views);
    std::vector<ReliefMap> maps;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const auto depth = multibaseline(seen_from(views, chosen[i], quality, threads), settings,
                                         threads, piece_of(progress, int(i), int(chosen.size())));
        if (!depth)
            throw Interrupted();
        settings.range = depth->range;
        ReliefMap map = map_of_view(views, chosen[i]);
        for (const float d : depth->disparity)
            map.parallax.push_back(float(-d / views.scale->ratio));
        maps.push_back(std::move(map));
    }
    return maps;
}

std::vector<ReliefMap> maps_of_depth_frame(const DepthInput& input, const std::string& path)
{
    if (!input.frame)
        throw std::invalid_argument(path + " is a depth frame, which is for a frame; views need "
                                           "their middle one's depth, as .pfm");
    const DepthFrame depths = read_depths(path);
    std::vector<ReliefMap> maps;
    for (const std::size_t k : outermost(input.views)) {
        ReliefMap map = map_of_view(input.views, k);
        map.parallax = depths_seen(input.views, *input.frame, depths, map.eye);
        for (float& mm : map.parallax)
            mm = parallax_of(mm, input.views.scale->distance);
        maps.push_back(std::move(map));
    }
    return maps;
}

/// Makes a map larger, centred, up to a size in pixels: each new pixel repeats the nearest old one.
/// Maps of a shape so different that this takes many times their memory stay as they are.
void extend(ReliefMap& map, int width, int height)
{
    constexpr double most = 16; // times the map's own pixels
    if (double(width) * height > most * map.width * map.height)
        return;
    const int left = (width - map.width) / 2, above = (height - map.height) / 2;
    std::vector<float> parallax;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            parallax.push_back(
                map.parallax[std::size_t(std::clamp(y - above, 0, map.height - 1)) * map.width +
                             std::size_t(std::clamp(x - left, 0, map.width - 1))]);
    map.places.first = map.places.at(-left, -above);
    map.parallax = std::move(parallax);
    map.width = width;
    map.height = height;
}

/// A map, and whether it has greys, whose parallax is from 0 (white) to 1 (black).
struct MapOfFile {
    ReliefMap map;
    bool has_greys = false;
};

/// Reads the depth_file as an upright parallax map that is fitted on the whole picture. The map's
/// eye is picture 0's if the caller sets no other.
MapOfFile map_of_file(const ReliefRequest& request, const DecodedDepths* decoded, Vec2 size,
                      double distance)
{
    const std::string& path = request.depth_file;
    MapOfFile read;
    ReliefMap& map = read.map;
    std::vector<float> mm;
    if (decoded) {
        map.width = decoded->width;
        map.height = decoded->height;
        for (std::size_t i = 0; i < decoded->depth.size(); ++i)
            mm.push_back(decoded->imaged[i] > 0 ? decoded->depth[i] : NAN);
    } else if (extension_of(path) == "pfm") {
        FloatMap file = read_pfm(path);
        map.width = file.width;
        map.height = file.height;
        mm = std::move(file.values);
    } else {
        const Image picture = read_frame(path).image;
        map.width = picture.width;
        map.height = picture.height;
        map.parallax = parallax_of_greys(picture);
        read.has_greys = true;
    }
    for (const float z : mm)
        map.parallax.push_back(parallax_of(z, distance));
    const FittedPicture on_picture = fitted(double(map.width) / map.height, size.x / size.y,
                                            request.fit);
    if (on_picture.differs())
        request.tell(path + ": " + fit_text(on_picture, "the picture", "its edges' depth"));
    map.places = places_over({on_picture.size.x * size.x, on_picture.size.y * size.y}, map.width,
                             map.height);
    // The depth at a map's edge extends over the picture beyond it.
    const auto beyond = [](int pixels, double share) {
        return pixels + 2 * int(std::ceil(0.5 * pixels * std::max(0.0, 1 / share - 1)));
    };
    extend(map, beyond(map.width, on_picture.size.x), beyond(map.height, on_picture.size.y));
    return read;
}

/// The depths in an OpenEXR file; nothing for another ending.
std::optional<DecodedDepths> decoded_depths(const std::string& path)
{
    if (extension_of(path) != "exr")
        return std::nullopt;
    try {
        return decode_depths(read_file(path));
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(path + ": " + reason_of(error));
    }
}

/// Whether a file's name or record says that it is a quilt, a view or a frame, also with the
/// geometry in the file `sheet`, if that is not "". Reads no pixels. Throws InputError.
bool is_frame_or_views(const std::string& path, const std::string& sheet = "")
{
    return quilt_in_name(path) || ViewsReader(path, false).head().metadata ||
           FrameReader(path, sheet).frame().metadata;
}

bool is_photograph(const std::vector<std::string>& inputs, const ReliefRequest& request)
{
    return inputs.size() == 1 && !request.depth_file.empty() && !request.input.grid &&
           is_plain_picture(inputs[0], request.input.sheet);
}

/// The two pictures of a stereo pair without a record of their eyes; nothing for other inputs.
std::optional<std::vector<Image>> pair_in(const std::vector<std::string>& inputs,
                                          const ReliefRequest& request)
{
    if (!request.depth_file.empty() || request.input.eyes || request.input.zone ||
        !is_pair_of_files(inputs))
        return std::nullopt;
    if (inputs.size() == 1)
        return read_list_of_views(inputs[0]);
    std::vector<Image> views;
    for (const std::string& input : inputs)
        views.push_back(read_frame(input).image);
    return views;
}

ReliefInput read_photograph(const std::string& path, const ReliefRequest& request, int threads)
{
    const Image image = read_frame(path).image;
    const PictureRaster raster = raster_of(image, request);
    const auto decoded = decoded_depths(request.depth_file);
    if (decoded && !decoded->document.empty())
        throw std::invalid_argument(request.depth_file +
                                    " is a frame's depth frame; a photograph needs its own map");
    std::vector<ReliefPicture> pictures{relief_picture(image, raster, threads)};
    MapOfFile read = map_of_file(request, decoded ? &*decoded : nullptr, raster.size,
                                 request.distance);
    std::vector<ReliefMap> maps{std::move(read.map)};
    return {Relief(std::move(pictures), std::move(maps), request.distance, raster.size),
            form_of(image), read.has_greys ? DepthUnit::none : DepthUnit::mm};
}

void need_scale(const ViewSet& views)
{
    if (!views.scale)
        throw std::invalid_argument(
            "millimetres are not known, because the views have no record of "
            "their eyes; give --eyes (integral depth, and integral views "
            "--to-frame)");
}

} // namespace

bool is_plain_picture(const std::string& path, const std::string& sheet)
{
    return !is_list_of_views(path) && !is_frame_or_views(path, sheet);
}

bool is_pair_of_files(const std::vector<std::string>& inputs)
{
    if (inputs.size() == 1)
        return is_list_of_views(inputs[0]) && read_list_of_views(inputs[0], 3).size() == 2;
    const auto is_no_view = [](const std::string& input) {
        return is_frame_or_views(input) || embedded_depth(input);
    };
    return inputs.size() == 2 && std::none_of(inputs.begin(), inputs.end(), is_no_view);
}

Relief measured_relief(const DepthInput& input, DepthQuality quality, int threads,
                       const Progress& progress)
{
    need_scale(input.views);
    return relief_of(input.views, input.form.encoding,
                     measured_maps(input.views, quality, threads, progress),
                     {input.width, input.height}, threads);
}

ReliefInput read_relief(const std::vector<std::string>& inputs, const ReliefRequest& request,
                        int threads, const Progress& progress)
{
    ReliefInput input = read_unplaced_relief(inputs, request, threads, progress);
    place(input, inputs[0], request);
    return input;
}

void place(ReliefInput& input, const std::string& name, const ReliefRequest& request)
{
    if (input.unit == DepthUnit::ends || (input.unit == DepthUnit::mm && !request.ends))
        return;
    // The picture is as large as the request says, for an eye at the request's distance.
    Relief& relief = input.relief;
    relief.scale(enlargement(relief.size(), request.size, request.fit));
    relief.set_distance(request.distance);
    const ParallaxSpan span = requested_span(request.depth_file.empty() ? name : request.depth_file,
                                             request, request.distance);
    if (input.unit == DepthUnit::mm)
        relief.fit(span);
    else
        relief.move(span);
    if (input.unit == DepthUnit::pair)
        relief.crop_to_common();
}

ReliefInput read_unplaced_relief(const std::vector<std::string>& inputs,
                                 const ReliefRequest& request, int threads,
                                 const Progress& progress)
{
    const bool own = request.own != OwnDepth::none && inputs.size() == 1;
    const bool photograph = !own && is_photograph(inputs, request);
    if ((own || photograph) && request.input.right_to_left)
        throw std::invalid_argument("--right-to-left is for views and pairs; it is one picture");
    if (own)
        return read_own_depth(inputs[0], request, threads);
    if (photograph)
        return read_photograph(inputs[0], request, threads);
    if (auto pair = pair_in(inputs, request))
        return relief_of_pair(inputs[0], std::move((*pair)[0]), std::move((*pair)[1]), request,
                              threads, progress);
    DepthInput input = read_depth_input(inputs, request.input, threads, piece_of(progress, 0, 2));
    if (request.depth_file.empty())
        return {measured_relief(input, request.quality, threads, piece_of(progress, 1, 2)),
                input.form};
    need_scale(input.views);
    const Vec2 size{input.width, input.height};
    const auto decoded = decoded_depths(request.depth_file);
    std::vector<ReliefMap> maps;
    DepthUnit unit = DepthUnit::mm;
    if (decoded && !decoded->document.empty()) {
        maps = maps_of_depth_frame(input, request.depth_file);
    } else {
        MapOfFile read = map_of_file(request, decoded ? &*decoded : nullptr, size,
                                     input.views.scale->distance);
        read.map.eye = eye_of(input.views, input.views.middle);
        if (read.has_greys) {
            const ParallaxSpan range = requested_span(request.depth_file, request,
                                                      input.views.scale->distance);
            for (float& p : read.map.parallax)
                p = float(range.near + (range.far - range.near) * p);
            unit = DepthUnit::ends;
        }
        maps.push_back(std::move(read.map));
    }
    return {relief_of(input.views, input.form.encoding, std::move(maps), size, threads), input.form,
            unit};
}

} // namespace integral
