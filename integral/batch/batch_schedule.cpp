// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_schedule.h"

#include "integral/base/number_text.h"
#include "integral/batch/batch_steps.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

namespace integral {
namespace {

constexpr double mebibyte = 1 << 20;

std::string megabytes(double bytes) { return with_decimals(std::ceil(bytes / mebibyte), 0) + " MB"; }

/// Bytes of memory that a step will need: by its pixels, and by what earlier steps of its kind needed, `known` bytes at `known_pixels`.
double memory_for(StepKind kind, double pixels, double known, double known_pixels)
{
    // The renderer keeps 20 bytes a pixel, in files beyond 128 MB; a tool holds the frame, its copy and what it makes.
    const auto guess = [&](double count) { return kind == StepKind::frame ? 32 * mebibyte + std::min(20 * count, 128 * mebibyte) : 32 * mebibyte + 24 * count; };
    if (known <= 0)
        return guess(pixels);
    return std::max(32 * mebibyte, known + guess(pixels) - guess(known_pixels));
}

/// Bytes of memory that programs can still have, by the kernel's account.
double free_memory()
{
    std::ifstream file("/proc/meminfo");
    std::string line;
    while (std::getline(file, line))
        if (line.rfind("MemAvailable:", 0) == 0)
            return std::atof(line.c_str() + 13) * 1024;
    return 1e300; // a kernel that does not say
}

} // namespace

void sort_longest_first(std::list<int>& steps, const BatchPlan& plan, const BatchFolder& folder)
{
    std::map<int, double> cost;
    for (const int i : steps) {
        const BatchStep& step = plan.steps[std::size_t(i)];
        const double seconds = read_record(folder.record(step)).seconds;
        cost[i] = step.frame >= 0 ? 1e300 : seconds > 0 ? seconds : pixels_of(step, "") * 1e-6;
    }
    steps.sort([&](int a, int b) { return cost[a] != cost[b] ? cost[a] > cost[b] : a < b; });
}

int threads_beside(int others, int at_once) { return others + 1 >= at_once ? 1 : (at_once + others) / (others + 1); }

std::pair<StepKind, int> MemoryForecast::likes(const BatchStep& step) const
{
    return {step.kind, step.frame < 0 ? manifest_.jobs[std::size_t(step.job)].scene : -1};
}

double MemoryForecast::expected(const BatchStep& step, double pixels, const StepRecord& before) const
{
    const auto known = most_.find(likes(step));
    if (known != most_.end())
        return memory_for(step.kind, pixels, known->second.first, known->second.second);
    return memory_for(step.kind, pixels, before.memory, before.pixels);
}

void MemoryForecast::learn(const BatchStep& step, const StepRecord& record)
{
    auto& known = most_[likes(step)];
    known = std::max(known, {record.memory, record.pixels});
}

std::string MemoryForecast::lack(double needed, const std::vector<MemoryUse>& running) const
{
    double available = limit_ > 0 ? limit_ : free_memory();
    for (const MemoryUse& one : running)
        available -= limit_ > 0 ? std::max(one.expected, one.now) : std::max(0.0, one.expected - one.now);
    if (needed <= available)
        return "";
    return "it needs about " + megabytes(needed) + " of memory, and " + megabytes(std::max(0.0, available)) + " are left";
}

} // namespace integral
