// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures how long a comparison of two pictures of 3840 x 2160 pixels takes: plain, with LDR-FLIP
// (8 bits a sample), and with HDR-FLIP (floats). Uses all cores; prints the least of five
// alternating runs, and each time divided by the plain comparison's for that sample type.
#include "integral/compare/comparison_rules.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace integral;

namespace {

template <class Sample> Frame noise(unsigned seed, Encoding encoding, double range)
{
    Frame frame{make_image<Sample>(3840, 2160, 3, encoding), {}};
    std::mt19937 random(seed);
    for (Sample& sample : std::get<std::vector<Sample>>(frame.image.samples))
        sample = Sample(range * double(random() % 256));
    return frame;
}

struct Task {
    std::string name;
    const Frame *a, *b;
    bool flip;
    double seconds = std::numeric_limits<double>::infinity(), processor = seconds;
    int exposures = 0;
};

} // namespace

int main()
{
    const Encoding linear{Encoding::Kind::linear, 1};
    const Frame a = noise<std::uint8_t>(1, {}, 1), b = noise<std::uint8_t>(2, {}, 1),
                bright_a = noise<float>(1, linear, 0.1), bright_b = noise<float>(2, linear, 0.1);
    std::vector<Task> tasks{{"8 bits, plain", &a, &b, false},
                            {"8 bits, with LDR-FLIP", &a, &b, true},
                            {"floats, plain", &bright_a, &bright_b, false},
                            {"floats, with HDR-FLIP", &bright_a, &bright_b, true}};
    for (int round = 0; round < 5; ++round)
        for (Task& task : tasks) {
            ComparisonRules rules;
            rules.flip = task.flip;
            const auto begun = std::chrono::steady_clock::now();
            const std::clock_t worked = std::clock();
            const Comparison comparison = compare(*task.a, *task.b,
                                                  settings_in_memory(rules, *task.a, *task.b));
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
            task.seconds = std::min(task.seconds, taken.count());
            task.processor = std::min(task.processor,
                                      double(std::clock() - worked) / CLOCKS_PER_SEC);
            if (comparison.flip && comparison.flip->settings.exposures)
                task.exposures = comparison.flip->settings.exposures->count;
        }
    std::printf("%-24s %8s %12s %10s %10s\n", "", "s", "processor s", "to plain", "exposures");
    for (std::size_t i = 0; i < tasks.size(); ++i)
        std::printf("%-24s %8.2f %12.2f %10.1f %10d\n", tasks[i].name.c_str(), tasks[i].seconds,
                    tasks[i].processor, tasks[i].seconds / tasks[i / 2 * 2].seconds,
                    tasks[i].exposures);
}
