// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/laboratory/scene_pictures.h"

#include "integral/base/number_text.h"
#include "integral/io/image_file.h"

#include <cmath>
#include <filesystem>

namespace integral {
namespace {

std::string vector_text(Vec3 v)
{
    const auto text = [](double value) { return with_digits(value, 17); };
    return "<" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ">";
}

} // namespace

std::string perspective_camera(const FrameMetadata& geometry, Eye viewer, Vec2 window,
                               Cameras cameras)
{
    // The eye in the scene whose picture the viewer sees.
    const Vec3 in_scene =
        *preimage_of(relief_of(geometry), Vec3{viewer.x, viewer.y, -viewer.distance});
    const Eye eye{in_scene.x, in_scene.y, -in_scene.z};
    const Placement& placement = *geometry.placement;
    const auto scene_way = [&](Vec3 v) {
        return scene_from_sheet(placement, v) - placement.origin;
    };
    const Vec3 to_middle{-eye.x, -eye.y, eye.distance};
    Vec3 direction = to_middle, right{1, 0, 0}, up{0, 1, 0};
    if (cameras == Cameras::converging) { // turned to the middle, with the same field of view
        direction = (eye.distance / length(to_middle)) * to_middle;
        right = {eye.distance, 0, eye.x};
        right = (1 / length(right)) * right;
        up = cross(direction, right);
        up = (1 / length(up)) * up;
    }
    return "camera { perspective location " +
           vector_text(scene_from_sheet(placement, {eye.x, eye.y, -eye.distance})) + " direction " +
           vector_text(scene_way(direction)) + " right " +
           vector_text(scene_way(window.x * right)) + " up " +
           vector_text(scene_way(window.y * up)) + " }\n";
}

ScenePictures::ScenePictures(const std::string& scene, std::vector<std::string> words)
    : scene_(scene), text_(read_file(scene)), words_(std::move(words))
{
}

Frame ScenePictures::frame(const std::string& path, const Progress& progress) const
{
    std::vector<std::string> words = scene_words(scene_, words_);
    for (const std::string& word : {"+O\"" + path + "\"", std::string("+FN"), std::string("-P")})
        words.push_back(word);
    render(scene_, words, scratch_, progress);
    Frame frame = read_frame(path);
    if (!frame.metadata || !frame.metadata->placement)
        throw InputError(scene_ + ": its camera is not integral; Integral_Camera=\"lens_sheet { "
                                  "lenticular pitch 1.27 thickness 3.08 ior 1.6 } film { dpi 300 "
                                  "}\" behind the scene makes it so");
    return frame;
}

Image ScenePictures::picture(const std::string& camera, int width, int height,
                             const Progress& progress) const
{
    // POV-Ray takes the last of several cameras in a scene.
    const std::string scene = scratch_.path("scene.pov"), path = scratch_.path("picture.png");
    write_file(scene, text_ + "\n" + camera);
    std::vector<std::string> words = scene_words(scene);
    const std::string folder = std::filesystem::path(scene_).parent_path().string();
    words.push_back("+L\"" + (folder.empty() ? "." : folder) + "\"");
    words.insert(words.end(), words_.begin(), words_.end());
    for (const std::string& word : {"+W" + std::to_string(width), "+H" + std::to_string(height),
                                    "+O\"" + path + "\"", std::string("+FN8"), std::string("-UA"),
                                    std::string("-P"), std::string("Integral_Camera=")})
        words.push_back(word);
    render(scene_ + " by a perspective camera", words, scratch_, progress);
    return read_frame(path).image;
}

} // namespace integral
