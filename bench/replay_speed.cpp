// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures the speed of replay for a frame of 2480 x 3508 pixels (A4 at 300 dpi): views of 1000 x
// 1400 pixels per second, and conversion to parallel views and back. For comparison it copies the
// frame's samples in memory, both over an existing picture and into a new one. Uses all cores;
// prints the least of five alternating runs.
#include "integral/replay/replay.h"
#include "integral/views/parallel_views.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

using namespace integral;

namespace {

Frame noise(const LensSheet& sheet)
{
    constexpr int width = 2480, height = 3508;
    Frame frame;
    frame.image = make_image<std::uint8_t>(width, height, 3, {});
    std::mt19937 random(1);
    for (std::uint8_t& sample : std::get<std::vector<std::uint8_t>>(frame.image.samples))
        sample = std::uint8_t(random());
    FrameMetadata metadata;
    metadata.sheet = sheet;
    metadata.film = {width, height, {mm_per_inch / 300, mm_per_inch / 300}};
    metadata.aperture = *filling_aperture(sheet, 400);
    set_metadata(frame, metadata);
    return frame;
}

struct Task {
    const char* name;
    std::function<void()> run;
    double seconds = std::numeric_limits<double>::infinity();
};

} // namespace

int main()
{
    struct {
        const char* name;
        LensSheet sheet;
    } sheets[] = {{"lenticular 1.27", {}},
                  {"square 1.27", {Arrangement::square, 1.27, 3.08, 1.6, 0, {}}},
                  {"hexagonal 1.124", {Arrangement::hexagonal, 1.124, 3.23, 1.675, 0, {}}}};
    for (const auto& [name, sheet] : sheets) {
        const Frame frame = noise(sheet);
        const auto& samples = std::get<std::vector<std::uint8_t>>(frame.image.samples);
        std::vector<std::uint8_t> copy(samples.size());
        const ViewGrid grid = natural_views(*frame.metadata);
        const auto views = *parallel_views(frame, grid);
        const auto seen = [&](int times, double pupil, LensModel model) {
            View view{centre_eye(*frame.metadata), 1000, 1400, times};
            view.pupil = pupil;
            view.model = model;
            replay(frame, view);
        };
        Task tasks[] = {
            {"copy in memory", [&] { std::memcpy(copy.data(), samples.data(), samples.size()); }},
            {"copy into a new picture",
             [&] {
                 const auto fresh = samples;
                 copy[0] = fresh[fresh.size() / 2];
             }},
            {"replay, 1 sample", [&] { seen(1, 0, LensModel::extended_pinhole); }},
            {"replay, 3 x 3 samples", [&] { seen(3, 0, LensModel::extended_pinhole); }},
            {"replay, 3 x 3, a pupil of 5 mm", [&] { seen(3, 5, LensModel::extended_pinhole); }},
            {"replay, 3 x 3, full lenses", [&] { seen(3, 0, LensModel::full); }},
            {"parallel views", [&] { parallel_views(frame, grid); }},
            {"frame from views", [&] { frame_from_parallel_views(views, *frame.metadata, grid); }}};
        for (int round = 0; round < 5; ++round)
            for (Task& task : tasks) {
                const auto begun = std::chrono::steady_clock::now();
                task.run();
                const std::chrono::duration<double> taken = std::chrono::steady_clock::now() -
                                                            begun;
                task.seconds = std::min(task.seconds, taken.count());
            }
        std::printf("%-16s %-31s %9s %10s %9s\n", name, "", "ms", "a second", "to copy");
        for (const Task& task : tasks)
            std::printf("%-16s %-31s %9.2f %10.2f %9.1f\n", "", task.name, 1e3 * task.seconds,
                        1 / task.seconds, task.seconds / tasks[0].seconds);
    }
}
