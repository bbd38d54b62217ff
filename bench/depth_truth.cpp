// SPDX-License-Identifier: AGPL-3.0-or-later
// depth_truth PICTURE NEAREST FARTHEST DISTANCE RATIO OUT.pfm: writes the disparities of a picture
// that shows depth as linear light, from black at NEAREST to white at FARTHEST (mm behind the plane
// without parallax), for eyes DISTANCE mm from that plane and RATIO pixels of it apart.
#include "integral/depth/view_set.h"
#include "integral/io/image_file.h"
#include "integral/io/pfm_file.h"

#include <cstdio>
#include <cstdlib>

int main(int count, char** words)
{
    using namespace integral;
    if (count != 7) {
        std::fprintf(stderr, "depth_truth: six words are expected; the source says which\n");
        return 2;
    }
    const double nearest = std::atof(words[2]), farthest = std::atof(words[3]);
    const DepthScale scale{std::atof(words[4]), std::atof(words[5])};
    const Image image = read_frame(words[1]).image;
    FloatMap map{image.width, image.height, {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            map.values.push_back(float(
                scale.disparity(nearest + stored_pixel(image, x, y).r * (farthest - nearest))));
    write_pfm(words[6], map);
    return 0;
}
