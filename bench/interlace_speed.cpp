// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures how fast an image for a panel of 3840 x 2160 pixels is interlaced from a quilt of 8 x 6
// views in 4096 x 4096 pixels, with 8 and 16 bits a sample, by a display's published mapping and by
// the optics of slanted lenses. For comparison it copies such an 8-bit image in memory. Uses all
// cores; prints the least of nine alternating runs.
#include "integral/panel/interlace.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <limits>
#include <random>

using namespace integral;

namespace {

constexpr int width = 3840, height = 2160;

LookingGlassCalibration calibration()
{
    LookingGlassCalibration c;
    c.pitch = 47.6;
    c.slope = -5.5;
    c.center = 0.37;
    c.dpi = 283;
    c.width = width;
    c.height = height;
    return c;
}

FrameMetadata geometry()
{
    FrameMetadata m;
    m.film = {width, height, {0.1796, 0.1796}, Subpixels::rgb};
    m.sheet = {Arrangement::lenticular, 0.95, 2.6, 1.52, 9.46, {}};
    m.aperture = *filling_aperture(m.sheet, 900);
    return m;
}

struct Task {
    std::string name;
    std::function<void()> run;
    double seconds = std::numeric_limits<double>::infinity(), processor = seconds;
};

/// Processor seconds of all threads of this program, which do not depend on other work on the
/// machine.
double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

template <class Sample> Image noise()
{
    Image quilt = make_image<Sample>(4096, 4096, 3, {});
    std::mt19937 random(1);
    for (Sample& sample : std::get<std::vector<Sample>>(quilt.samples))
        sample = Sample(random());
    return quilt;
}

const char* word(Neighbours n) { return n == Neighbours::linear ? "linear" : "nearest"; }

} // namespace

int main()
{
    const Image quilt = noise<std::uint8_t>(), deep_quilt = noise<std::uint16_t>();
    const ViewRaster views(quilt, {8, 6}), deep_views(deep_quilt, {8, 6});
    const PanelMapping published = mapping_of(calibration());
    const FrameMetadata own = geometry();
    const auto begun = std::chrono::steady_clock::now();
    const PanelMapping rays = *mapping_of(own, {{own.aperture.width, 0}, own.aperture.distance});
    const std::chrono::duration<double> table = std::chrono::steady_clock::now() - begun;

    Image panel = panel_image(views, width, height),
          deep_panel = panel_image(deep_views, width, height);
    auto& samples = std::get<std::vector<std::uint8_t>>(panel.samples);
    std::vector<std::uint8_t> copy(samples.size(), 1);
    std::vector<Task> tasks{
        {"copy in memory", [&] { std::memcpy(copy.data(), samples.data(), samples.size()); }}};
    for (const bool deep : {false, true})
        for (const PanelMapping* mapping : {&published, &rays})
            for (const Neighbours of_views : {Neighbours::nearest, Neighbours::linear})
                for (const Neighbours of_pixels : {Neighbours::nearest, Neighbours::linear})
                    tasks.push_back({std::string(deep ? "16 bits, " : "8 bits, ") +
                                         (mapping == &rays ? "optics: " : "published: ") +
                                         word(of_views) + " views, " + word(of_pixels) + " pixels",
                                     [&, deep, mapping, of_views, of_pixels] {
                                         interlace(deep ? deep_panel : panel,
                                                   deep ? deep_views : views, *mapping,
                                                   {of_views, of_pixels});
                                     }});
    for (int round = 0; round < 9; ++round)
        for (Task& task : tasks) {
            const auto start = std::chrono::steady_clock::now();
            const double worked = processor_seconds();
            task.run();
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
            task.seconds = std::min(task.seconds, taken.count());
            task.processor = std::min(task.processor, processor_seconds() - worked);
        }
    std::printf("the table of the optics, once a panel: %.1f s\n", table.count());
    std::printf("%-52s %9s %10s %9s %14s\n", "", "ms", "a second", "to copy", "processor ms");
    for (const Task& task : tasks)
        std::printf("%-52s %9.2f %10.1f %9.1f %14.2f\n", task.name.c_str(), 1e3 * task.seconds,
                    1 / task.seconds, task.seconds / tasks[0].seconds, 1e3 * task.processor);
}
