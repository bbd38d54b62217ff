// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/depth/depth_report.h"

#include "integral/base/file_bytes.h"
#include "integral/base/number_text.h"
#include "integral/io/image_file.h"
#include "integral/io/pfm_file.h"

namespace integral {
namespace {

Json as_json(const RegionScores& scores)
{
    return {{"pixels", scores.pixels},   {"bad_0.07", scores.bad[0]}, {"bad_0.03", scores.bad[1]},
            {"bad_0.01", scores.bad[2]}, {"mse_x_100", scores.mse},   {"q25", scores.lower}};
}

std::string line_of(const char* name, const RegionScores& s)
{
    if (s.pixels == 0)
        return std::string(name) + "none\n";
    std::string line = name;
    for (int k = 0; k < 3; ++k)
        line += with_decimals(s.bad[k], 2) + "% ";
    return line + " MSE x 100 " + with_decimals(s.mse, 3) + "  Q25 " + with_decimals(s.lower, 3) +
           "  of " + counted((long long)s.pixels, "pixel") + "\n";
}

} // namespace

std::vector<float> read_truth(const std::string& path, const DepthInput& input)
{
    const std::string extension = extension_of(path);
    if (extension == "exr") {
        const DepthFrame depths = read_depths(path);
        if (input.frame.has_value() == depths.metadata.quilt.has_value())
            throw std::invalid_argument(
                input.frame ? "it is a quilt's, and the input is a frame; give the frame's own"
                            : "it is a frame's, and the input is views; "
                              "give the depths of a quilt, or a .pfm");
        return input.frame ? true_disparities(input.views, *input.frame, depths)
                           : true_disparities(input.views, depths);
    }
    const FloatMap map = read_pfm(path);
    const ViewSet& views = input.views;
    if (map.width != views.upright_width() || map.height != views.upright_height())
        throw std::invalid_argument("it has " + size_text(map.width, map.height) +
                                    " pixels, and a view " +
                                    size_text(views.upright_width(), views.upright_height()));
    std::vector<float> truth;
    for (int y = 0; y < views.height; ++y)
        for (int x = 0; x < views.width; ++x)
            truth.push_back(map.values[views.upright_pixel(x, y)]);
    return truth;
}

std::string figures_text(const DepthFigures& figures)
{
    std::string text = std::to_string(figures.views) + " views of " +
                       size_text(figures.width, figures.height) + " pixels, disparities from " +
                       with_decimals(figures.range.least, 2) + " to " +
                       with_decimals(figures.range.greatest, 2) + ", " +
                       with_decimals(figures.seconds, 2) + " s\n";
    if (const auto& scores = figures.scores)
        text += "bad beyond 0.07, 0.03, 0.01:\n" + line_of("  all      ", scores->all) +
                line_of("  edges    ", scores->edges) + line_of("  planes   ", scores->planes) +
                line_of("  texture  ", scores->texture) + "  bumpiness of planes " +
                with_decimals(scores->bumpiness, 3) + "\n";
    return text;
}

Json figures_json(const DepthFigures& figures)
{
    Json json = {{"views", figures.views},         {"width", figures.width},
                 {"height", figures.height},       {"far", figures.range.least},
                 {"near", figures.range.greatest}, {"seconds", figures.seconds}};
    if (const auto& scores = figures.scores)
        json["scores"] = {{"all", as_json(scores->all)},
                          {"edges", as_json(scores->edges)},
                          {"planes", as_json(scores->planes)},
                          {"bumpiness", scores->bumpiness},
                          {"texture", as_json(scores->texture)}};
    return json;
}

} // namespace integral
