// SPDX-License-Identifier: AGPL-3.0-or-later
// depth_matcher LEFT MIDDLE STEPS LEAST GREATEST TRUTH.pfm BORDER: scores OpenCV's semi-global
// matcher (Hirschmueller 2008; modes of cv::StereoSGBM) on two views of a row, as integral depth
// scores its own maps. LEFT stands STEPS eyes to the left of MIDDLE, whose depth is measured.
// LEAST and GREATEST: range of disparities between neighbouring eyes to search. Pixels without a
// match take the smaller of the disparities on both sides in their row. Prints the percentage of
// bad pixels (all, near edges, with texture), 100 times the mean squared error, the bumpiness of
// planes and the seconds.
#include "integral/depth/depth_scores.h"
#include "integral/io/image_file.h"
#include "integral/io/pfm_file.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace integral;

/// The matcher's result for the middle view, in disparities of neighbouring eyes; NaN where it has
/// none.
std::vector<float> matched(const cv::Mat& left, const cv::Mat& middle, int steps, double least,
                           double greatest)
{
    // A point that is nearer stands farther to the left in the view on the right. The matcher gives
    // the depth of its first picture, so both are mirrored: then the middle one is on the left.
    cv::Mat first, second;
    cv::flip(middle, first, 1);
    cv::flip(left, second, 1);
    const int lowest = int(std::floor(steps * least)) - 1,
              number = (int(std::ceil(steps * greatest)) + 1 - lowest + 15) / 16 * 16;
    constexpr int window = 3, channels = 3;
    const auto matcher = cv::StereoSGBM::create(
        lowest, number, window, 8 * channels * window * window, 32 * channels * window * window, 1,
        63, 10, 100, 32, cv::StereoSGBM::MODE_HH);
    cv::Mat found;
    matcher->compute(first, second, found);
    std::vector<float> disparity;
    for (int y = 0; y < found.rows; ++y)
        for (int x = found.cols - 1; x >= 0; --x) {
            const float d = float(found.at<short>(y, x)) / 16;
            disparity.push_back(d < float(lowest) ? NAN : d / float(steps));
        }
    return disparity;
}

void fill_rows(std::vector<float>& disparity, int width)
{
    for (std::size_t row = 0; row < disparity.size(); row += std::size_t(width))
        for (int x = 0; x < width;) {
            int end = x;
            while (end < width && std::isnan(disparity[row + end]))
                ++end;
            if (end > x) {
                const float before = x > 0 ? disparity[row + x - 1] : HUGE_VALF,
                            after = end < width ? disparity[row + end] : HUGE_VALF;
                for (int i = x; i < end; ++i)
                    disparity[row + i] = std::fmin(before, after);
            }
            x = end + 1;
        }
}

} // namespace

int main(int count, char** words)
{
    if (count != 8) {
        std::fprintf(stderr, "depth_matcher: seven words are expected; the source says which\n");
        return 2;
    }
    const cv::Mat left = cv::imread(words[1]), middle = cv::imread(words[2]);
    if (left.empty() || middle.empty() || left.size() != middle.size()) {
        std::fprintf(stderr, "depth_matcher: %s, %s: not two views of one size\n", words[1],
                     words[2]);
        return 3;
    }
    const auto start = std::chrono::steady_clock::now();
    std::vector<float> disparity = matched(left, middle, std::atoi(words[3]), std::atof(words[4]),
                                           std::atof(words[5]));
    fill_rows(disparity, middle.cols);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    // The scores need the colours of the middle view, and a set with views across and down.
    const Image view = read_frame(words[2]).image;
    const ViewSet set = view_set(std::vector<Image>(9, view), {3, 3}, std::nullopt);
    const DepthScores s = depth_scores(set, disparity, read_pfm(words[6]).values,
                                       std::atoi(words[7]));
    std::printf("%.2f %.2f %.2f %.2f %.2f %.2f\n", s.all.bad[0], s.edges.bad[0], s.texture.bad[0],
                s.all.mse, s.bumpiness, seconds.count());
}
