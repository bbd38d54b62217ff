// SPDX-License-Identifier: AGPL-3.0-or-later
// What decides when a batch's steps begin and with how much of the machine: order, threads, memory.
#ifndef INTEGRAL_BATCH_BATCH_SCHEDULE_H
#define INTEGRAL_BATCH_BATCH_SCHEDULE_H

#include "integral/batch/batch_folder.h"

#include <list>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace integral {

/// Puts steps of the plan in the order in which they are to begin: the longest first, by what is known of their last run or by their pixels;
/// then the last ones to end do so at nearly the same time. What a frame's steps make of it comes at once.
void sort_longest_first(std::list<int>& steps, const BatchPlan& plan, const BatchFolder& folder);

/// Threads of a step that begins when `others` more could: one while there is enough to do; the last frames have more, so that no core of
/// `at_once` is idle while they end.
int threads_beside(int others, int at_once);

/// Bytes of a program that runs.
struct MemoryUse {
    double expected = 0, now = 0;
};

/// What steps will need of the machine's memory, learnt from those that have ended.
class MemoryForecast {
public:
    /// `limit`: bytes that all together may take; 0: what the machine has free.
    MemoryForecast(const Manifest& manifest, double limit) : manifest_(manifest), limit_(limit) {}

    /// Bytes for a frame of so many pixels; `before` is the step's record of its last run.
    double expected(const BatchStep& step, double pixels, const StepRecord& before) const;
    void learn(const BatchStep& step, const StepRecord& record);

    /// Empty if that many bytes can be had beside what runs; else a sentence's begin: what is needed, and what is left.
    std::string lack(double needed, const std::vector<MemoryUse>& running) const;

private:
    std::pair<StepKind, int> likes(const BatchStep& step) const; ///< steps that need alike: a scene's frames, or all of another kind

    const Manifest& manifest_;
    double limit_;
    std::map<std::pair<StepKind, int>, std::pair<double, double>> most_; ///< bytes, and pixels
};

} // namespace integral

#endif
