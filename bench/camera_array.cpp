// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/camera_array.h"

#include "integral/base/parallel.h"
#include "integral/io/image_file.h"
#include "integral/replay/arrange.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>

namespace integral::bench {

namespace {

constexpr int renderers = 6; // that run at the same time

std::string padded(int number, std::size_t digits)
{
    const std::string text = std::to_string(number);
    return std::string(digits > text.size() ? digits - text.size() : 0, '0') + text;
}

} // namespace

std::vector<EyePosition> CameraArray::eyes() const
{
    std::vector<EyePosition> result;
    for (const Eye& eye : eye_grid({}, columns, rows, {width, height}))
        result.push_back({eye.x, eye.y});
    return result;
}

void render(const Renderer& renderer, const std::string& scene,
            const std::vector<std::string>& options, const CameraArray& array,
            const std::function<void(const Image&, int)>& see)
{
    const int count = array.columns * array.rows;
    // At least two pictures for each renderer: it numbers the files of an animation only, and one
    // picture is no animation.
    const int parts = std::clamp(count / 2, 1, renderers);
    std::mutex seeing;
    const auto declare = [](const char* name, double value) {
        return std::string("Declare=") + name + "=" + std::to_string(value);
    };
    for_each_row(parts, parts, [&](int part) {
        const int first = int((long long)(count)*part / parts);
        const int pictures = int((long long)(count) * (part + 1) / parts) - first;
        Renderer own = renderer;
        own.work_folder += "/array-" + std::to_string(part);
        std::filesystem::create_directories(own.work_folder);
        std::vector<std::string> words = options;
        words.insert(words.end(),
                     {"+W" + std::to_string(array.picture_width),
                      "+H" + std::to_string(array.picture_height),
                      declare("Array_Columns", array.columns), declare("Array_Rows", array.rows),
                      declare("Array_Width", array.width), declare("Array_Height", array.height),
                      declare("Array_First", first), "+KFI1", "+KFF" + std::to_string(pictures)});
        own.render(scene, "array", std::nullopt, words);
        const std::size_t digits = pictures > 1 ? std::to_string(pictures).size() : 0;
        for (int k = 0; k < pictures; ++k) {
            const std::string path = own.picture("array" + (digits ? padded(k + 1, digits) : ""));
            const Image picture = read_frame(path).image;
            std::filesystem::remove(path);
            const std::lock_guard<std::mutex> lock(seeing);
            see(picture, first + k);
        }
    });
}

GatheredFrame::GatheredFrame(const Frame& like)
    : like_(like),
      optics_(like.metadata->sheet, like.metadata->aperture, LensModel::extended_pinhole),
      film_(std::size_t(like.image.width) * like.image.height)
{
}

void GatheredFrame::add(const Image& picture, const EyePosition& eye)
{
    const Film& film = like_.metadata->film;
    const Film window{picture.width,
                      picture.height,
                      {film.width * film.pixel_pitch.x / picture.width,
                       film.height * film.pixel_pitch.y / picture.height}};
    const LinearReader read(picture);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const Vec2 point = film_from_pixel(window, {x + 0.5, y + 0.5});
            const Vec3 to_eye{eye.x - point.x, eye.y - point.y, -like_.metadata->aperture.distance};
            const Vec2 pixel = pixel_from_film(
                film, optics_.film_point_seen(point, (1 / length(to_eye)) * to_eye));
            if (!(pixel.x >= 0 && pixel.x < film.width && pixel.y >= 0 && pixel.y < film.height))
                continue;
            const Colour c = read(x, y);
            Light& light = film_[std::size_t(pixel.y) * film.width + std::size_t(pixel.x)];
            light = {light.r + c.r, light.g + c.g, light.b + c.b, light.rays + 1};
        }
}

Frame GatheredFrame::frame() const
{
    Frame result{blank_like(like_.image, like_.image.width, like_.image.height), like_.metadata};
    for (int y = 0; y < result.image.height; ++y)
        for (int x = 0; x < result.image.width; ++x) {
            const Light& light = film_[std::size_t(y) * result.image.width + x];
            const double part = light.rays ? 1.0 / light.rays : 0;
            store_linear(result.image, x, y,
                         {float(part * light.r), float(part * light.g), float(part * light.b), 1});
        }
    return result;
}

double GatheredFrame::missing() const
{
    int lit = 0, without = 0;
    for (int y = 0; y < like_.image.height; ++y)
        for (int x = 0; x < like_.image.width; ++x) {
            const Colour c = stored_pixel(like_.image, x, y);
            if (c.r == 0 && c.g == 0 && c.b == 0)
                continue;
            ++lit;
            without += film_[std::size_t(y) * like_.image.width + x].rays == 0;
        }
    return double(without) / std::max(lit, 1);
}

double GatheredFrame::rays_a_pixel() const
{
    double rays = 0;
    int reached = 0;
    for (const Light& light : film_) {
        rays += light.rays;
        reached += light.rays > 0;
    }
    return rays / std::max(reached, 1);
}

} // namespace integral::bench
