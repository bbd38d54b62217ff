// SPDX-License-Identifier: AGPL-3.0-or-later
// depth_limit FRAME DEPTHS.exr: computes the sampling limit of the thesis's equation (4-2), and
// measures the depth at which the error of method B passes it. Prints four cells of a table, in mm:
// the limit in front of the sheet and where the error passes it, and the same behind.
//
// (4-2): at a depth z a film pixel is pixel / focal length * z wide. Where that is more than the
// pitch of the lenses, neighbouring views differ by more than a pixel, and nothing between the
// samples indicates which belong together. The limit is a difference of one pixel, which is a
// disparity of 1. The error passes it at the depth, outwards from the sheet, at which more than
// half of the pixels are bad (0.07) in two consecutive steps of 0.1 of disparity. Only pixels with
// texture and away from edges count, and steps with 30 of them or more.
#include "integral/depth/depth_input.h"
#include "integral/depth/depth_quality.h"
#include "integral/depth/depth_scores.h"
#include "integral/depth/texture.h"
#include "integral/io/image_file.h"

#include <cmath>
#include <cstdio>

namespace {

using namespace integral;

struct Step {
    int pixels = 0, bad = 0;
    bool counts() const { return pixels >= 30; }
    bool is_bad() const { return 2 * bad > pixels; }
};

constexpr int steps = 40;
constexpr double width = 0.1; // disparity

/// Returns the disparity at which the error passes the limit, on one side (1: in front, -1:
/// behind); if it does not, the scene's last disparity, and sets `beyond` to true.
double passed_at(const ViewSet& views, const DepthMap& map, const std::vector<float>& truth,
                 int side, bool& beyond)
{
    constexpr double least_texture = 0.02; // as in depth_scores
    const Texture texture(views);
    Step of[steps];
    const auto is_edge = [&](int x, int y) {
        const auto at = [&](int i, int j) { return truth[std::size_t(j) * views.width + i]; };
        for (int j = y - 2; j <= y + 2; ++j)
            for (int i = x - 2; i <= x + 2; ++i)
                if (!(std::fabs(at(i, j) - at(x, y)) < 0.3))
                    return true;
        return false;
    };
    for (int y = 2; y < views.height - 2; ++y)
        for (int x = 2; x < views.width - 2; ++x) {
            const std::size_t i = std::size_t(y) * views.width + x;
            const int k = int(side * truth[i] / width);
            if (!(side * truth[i] > 0) || k >= steps || is_edge(x, y) ||
                !(texture.at(x, y) > least_texture))
                continue;
            ++of[k].pixels;
            of[k].bad += std::fabs(map.disparity[i] - truth[i]) > bad_limits[0];
        }
    int last = 0;
    bool before = false;
    for (int k = 0; k < steps; ++k) {
        if (!of[k].counts())
            continue;
        if (before && of[k].is_bad()) {
            beyond = false;
            return side * width * last;
        }
        before = of[k].is_bad();
        last = k;
    }
    beyond = true;
    return side * width * (last + 1);
}

} // namespace

int main(int count, char** words)
{
    if (count != 3) {
        std::fprintf(stderr, "depth_limit: FRAME DEPTHS.exr are expected\n");
        return 2;
    }
    DepthInput input = read_depth_input({words[1]}, {}, 0, {});
    const std::vector<float> truth = true_disparities(input.views, *input.frame,
                                                      read_depths(words[2]));
    soften(input.views, 0);
    keep_views(input.views, DepthQuality::good);
    const auto map = multibaseline(input.views, settings_for(DepthQuality::good), 0, {});
    const DepthScale scale = *input.views.scale;
    for (const int side : {1, -1}) {
        bool beyond = false;
        const double passed = passed_at(input.views, *map, truth, side, beyond);
        const double mm = std::fabs(scale.mm(passed));
        std::printf("| %.0f mm | ", std::fabs(scale.mm(side)));
        if (beyond && mm < 5)
            std::printf("nothing there ");
        else
            std::printf("%s%.0f mm ", beyond ? "> " : "", mm);
    }
    std::printf("|\n");
}
