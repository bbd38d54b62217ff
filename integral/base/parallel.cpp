// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace integral {

Progress piece_of(const Progress& whole, int index, int count)
{
    if (!whole)
        return {};
    return [=](int done, int total) { return whole(index * total + done, count * total); };
}

/// Runs `work` here and in up to `threads` - 1 other threads, and waits for all of them.
static void run_on_threads(int threads, const std::function<void()>& work)
{
    std::vector<std::thread> team;
    for (int i = 1; i < threads; ++i) {
        try {
            team.emplace_back(work);
        } catch (const std::system_error&) {
            break; // no more threads available: continue with those that were started
        }
    }
    work();
    for (auto& thread : team)
        thread.join();
}

bool for_each_row(int rows, int threads, const std::function<void(int row)>& work,
                  const Progress& progress)
{
    std::atomic<int> next{0};
    std::atomic<bool> stop{false};
    std::mutex mutex;
    int done = 0;
    std::exception_ptr failure;

    const auto run = [&] {
        try {
            for (int row; !stop && (row = next++) < rows;) {
                work(row);
                if (!progress)
                    continue;
                const std::lock_guard<std::mutex> lock(mutex);
                if (!progress(++done, rows))
                    stop = true;
            }
        } catch (...) {
            const std::lock_guard<std::mutex> lock(mutex);
            if (!failure)
                failure = std::current_exception();
            stop = true;
        }
    };

    if (threads <= 0)
        threads = int(std::max(1u, std::thread::hardware_concurrency()));
    run_on_threads(std::min(threads, rows), run);
    if (failure)
        std::rethrow_exception(failure);
    return !stop;
}

} // namespace integral
