// SPDX-License-Identifier: AGPL-3.0-or-later
// What can be had from a frame: what an eye sees of it (eye.png), an image for a light-field panel
// (panel.png), and the depth of what it shows (depth.png).
//
//     g++ -std=c++17 -O2 use_frame.cpp $(pkg-config --cflags --libs libintegral) -o use_frame
//     ./use_frame frame.png
#include "integral/depth/depth_files.h"
#include "integral/depth/depth_input.h"
#include "integral/depth/depth_quality.h"
#include "integral/io/image_file.h"
#include "integral/panel/interlace.h"
#include "integral/replay/replay.h"
#include "integral/sheet/panel.h"
#include "integral/views/view_input.h"

#include <cstdio>
#include <exception>

using namespace integral;

// What an eye sees that is 30 mm to the right of the middle.
static void replay_frame(const Frame& frame)
{
    View view;
    view.eye = centre_eye(*frame.metadata);
    view.eye.x += 30;
    set_view_size(view, frame.metadata->film, 600);
    write_frame("eye.png", Frame{*replay(frame, view), {}});
}

// Eight eyes' views, interlaced for a panel through the exact optics of its lenses.
static void interlace_for_panel(const Frame& frame)
{
    const ViewGrid grid{8, 1};
    View view;
    set_view_size(view, frame.metadata->film, 480);
    const std::vector<Image> pictures = views_of_eyes(frame, grid, view, 0, {});
    const ViewRaster views(pictures, grid); // refers to the pictures
    const FrameMetadata panel = frame_geometry(*panel_named("thesis-lcd"));
    const EyeGrid eyes{{panel.aperture.width, 0}, panel.aperture.distance};
    const PanelMapping mapping = *mapping_of(panel, eyes);
    Frame image;
    image.image = panel_image(views, mapping.width, mapping.height);
    interlace(image.image, views, mapping);
    set_metadata(image, panel);
    write_frame("panel.png", image);
}

// The depth of what the eye in the middle sees, in mm behind the sheet.
static void measure_depth(const char* path)
{
    DepthInput input = read_depth_input({path}, {}, 0, {});
    soften(input.views, 0); // against aliases
    const auto map = multibaseline(input.views, settings_for(DepthQuality::good), 0, {});
    const UprightMap upright = upright_map(input.views, *map, input.width, input.height, 0);
    write_depth("depth.png", upright);
    const std::vector<float> depths = upright.depths();
    const int middle = upright.height / 2 * upright.width + upright.width / 2;
    std::printf("in the middle %.1f mm, at the left %.1f mm behind the sheet\n", depths[middle],
                depths[middle - upright.width * 2 / 5]);
}

int main(int count, char** words)
try {
    if (count != 2)
        throw std::invalid_argument("usage: use_frame FRAME.png");
    const Frame frame = read_frame_with_metadata(words[1]);
    replay_frame(frame);
    interlace_for_panel(frame);
    measure_depth(words[1]);
} catch (const std::exception& error) {
    std::fprintf(stderr, "use_frame: %s\n", error.what());
    return 1;
}
