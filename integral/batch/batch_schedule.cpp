// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_schedule.h"

#include "integral/base/number_text.h"
#include "integral/batch/batch_steps.h"

#include <map>

namespace integral {
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

int threads_beside(int others, int at_once)
{
    return others + 1 >= at_once ? 1 : (at_once + others) / (others + 1);
}

} // namespace integral
