// SPDX-License-Identifier: AGPL-3.0-or-later
// The studio's live picture (integral/studio/live_view.glsl) without a browser: the renderer's
// name, the time of a picture and, against a frame of the scene, PSNR of the live picture to the
// replay of that frame.
#include "bench/live_drawing.h"
#include "bench/program.h"

#include "build/generated/page_texts.h" // sheet_optics_glsl, live_view_glsl
#include "integral/io/image_file.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace integral::bench {
namespace {

namespace options = boost::program_options;

std::vector<double> numbers(const std::string& text)
{
    std::vector<double> values;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');)
        values.push_back(std::stod(part));
    return values;
}

/// Reads the views of a quilt with depths: all, or the numbers in `chosen`.
Probe probe_of(const std::string& quilt_file, const std::string& depth_file,
               std::vector<double> chosen)
{
    const Views quilt = read_views(quilt_file, true);
    const DepthFrame depths = read_depths(depth_file);
    const FrameMetadata& metadata = depths.metadata;
    if (!metadata.quilt || !metadata.quilt->eyes || !metadata.placement)
        throw UsageError(depth_file + ": has no depths of a quilt of Integral_Quilt");
    const ViewGrid grid = metadata.quilt->grid;
    const Image image = converted(quilt.image, 8, Encoding(), false);
    if (depths.depth.size() != std::size_t(image.width) * image.height)
        throw UsageError(depth_file + ": is not as large as " + quilt_file);
    Probe probe;
    probe.width = image.width / grid.columns;
    probe.height = image.height / grid.rows;
    probe.sheet_distance = metadata.placement->units_per_mm * scene_distance(metadata);
    if (chosen.empty())
        for (int view = 0; view < grid.count(); ++view)
            chosen.push_back(view);
    for (const double view : chosen)
        probe.views.push_back(probe_view(image, depths, int(view)));
    return probe;
}

LivePlacement placement_of(const FrameMetadata& metadata)
{
    LivePlacement placement;
    placement.scene_distance = scene_distance(metadata);
    placement.sheet_distance = metadata.placement->units_per_mm * placement.scene_distance;
    placement.parallax = metadata.parallax ? metadata.parallax->factor : 1;
    return placement;
}

double psnr(const Image& first, const Image& second)
{
    const auto& a = std::get<std::vector<std::uint8_t>>(first.samples);
    const auto& b = std::get<std::vector<std::uint8_t>>(second.samples);
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        sum += (double(a[k]) - b[k]) * (double(a[k]) - b[k]);
    return 10 * std::log10(255.0 * 255 * a.size() / sum);
}

double milliseconds(const std::function<void()>& work)
{
    double least = 1e30;
    for (int run = 0; run < 3; ++run) {
        const auto begun = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begun;
        least = std::min(least, 1e3 * time.count());
    }
    return least;
}

std::string file_text(const std::string& path)
{
    std::ifstream file(path);
    if (!file)
        throw UsageError(path + ": cannot be read");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

int run(int count, char** words)
{
    options::options_description all("options");
    all.add_options()("quilt", options::value<std::string>()->required(), "the probe's pictures")(
        "depths", options::value<std::string>()->required(), "their depths (.exr)")(
        "views", options::value<std::string>()->default_value(""),
        "numbers of the probe's views: 0,4,8")("frame", options::value<std::string>()->required(),
                                               "a frame of the scene")(
        "eye", options::value<std::vector<std::string>>()->default_value({}, ""),
        "x,y,distance, mm")("size", options::value<std::string>()->default_value("480,320"),
                            "of the picture")("samples", options::value<int>()->default_value(3),
                                              "across a pixel")(
        "steps", options::value<int>()->default_value(64), "at most, along a line")(
        "tint", options::value<double>()->default_value(0), "depth budget, mm")(
        "without-sheet", options::bool_switch(), "the eye's rays go on straight")(
        "times", options::bool_switch(), "print the milliseconds of pictures")(
        "shaders", options::value<std::string>()->default_value(""),
        "a folder integral/ whose shaders are used in place of those compiled in")(
        "output,o", options::value<std::string>()->default_value(""),
        "PREFIX: write the pictures PREFIX-live-N.png and PREFIX-exact-N.png");
    const auto arguments = parsed(count, words, all);
    const auto text = [&](const char* name) { return arguments[name].as<std::string>(); };
    const std::string folder = text("shaders");
    LiveDrawing drawing(folder.empty() ? std::string(sheet_optics_glsl) + live_view_glsl
                                       : file_text(folder + "/replay/sheet_optics.glsl") +
                                             file_text(folder + "/studio/live_view.glsl"));
    const Frame frame = read_frame_with_metadata(text("frame"));
    if (!frame.metadata->placement)
        throw UsageError(text("frame") + ": has no placement in a scene");
    drawing.set_probe(probe_of(text("quilt"), text("depths"), numbers(text("views"))));
    const LivePlacement placement = placement_of(*frame.metadata);
    LiveOptions how;
    how.samples = arguments["samples"].as<int>();
    how.steps = arguments["steps"].as<int>();
    how.tint = arguments["tint"].as<double>();
    how.without_sheet = arguments["without-sheet"].as<bool>();

    if (arguments["times"].as<bool>()) {
        std::printf("%s\n", drawing.renderer().c_str());
        for (const auto& [width, height] : {std::pair(480, 320), {960, 640}, {1500, 1000}}) {
            drawing.set_view(width, height, *frame.metadata);
            const double ms = milliseconds(
                [&] { drawing.draw(centre_eye(*frame.metadata), placement, how); });
            std::printf("%dx%d, %d samples a pixel: %.1f ms\n", width, height,
                        how.samples * how.samples, ms);
            std::fflush(stdout);
        }
    }
    const auto size = numbers(text("size"));
    if (size.size() != 2)
        throw UsageError("--size WIDTH,HEIGHT");
    drawing.set_view(int(size[0]), int(size[1]), *frame.metadata);
    int number = 0;
    for (const std::string& eye_text : arguments["eye"].as<std::vector<std::string>>()) {
        const auto eye = numbers(eye_text);
        if (eye.size() != 3)
            throw UsageError("--eye X,Y,DISTANCE");
        View view;
        view.eye = {eye[0], eye[1], eye[2]};
        view.width = int(size[0]);
        view.height = int(size[1]);
        view.samples = how.samples;
        const Image exact = converted(*replay(frame, view), 8, Encoding(), false);
        drawing.draw(view.eye, placement, how);
        const Image live = drawing.picture();
        std::printf("%s %.2f\n", eye_text.c_str(), psnr(live, exact));
        if (!text("output").empty()) {
            const std::string end = "-" + std::to_string(number) + ".png";
            write_frame(text("output") + "-live" + end, {live, std::nullopt});
            write_frame(text("output") + "-exact" + end, {exact, std::nullopt});
        }
        ++number;
    }
    return 0;
}

} // namespace
} // namespace integral::bench

int main(int count, char** words)
{
    return integral::bench::status_of("live_view",
                                      [&] { return integral::bench::run(count, words); });
}
