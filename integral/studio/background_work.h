// SPDX-License-Identifier: AGPL-3.0-or-later
// Runs long work of this program beside others.
#ifndef INTEGRAL_STUDIO_BACKGROUND_WORK_H
#define INTEGRAL_STUDIO_BACKGROUND_WORK_H

#include "integral/base/parallel.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <future>

namespace integral {

/// A function that runs in a thread of its own.
class BackgroundWork {
public:
    /// `function` must throw Interrupted soon after its Progress returns false.
    explicit BackgroundWork(std::function<void(const Progress&)> function)
        : end_(std::async(std::launch::async, [this, function = std::move(function)] {
              function([this](int done, int total) {
                  part_ = double(done) / total;
                  return !stopped_;
              });
          }))
    {
    }
    /// Stops the function, and waits for its end.
    ~BackgroundWork()
    {
        stopped_ = true;
        if (end_.valid())
            end_.wait();
    }
    BackgroundWork(const BackgroundWork&) = delete;
    BackgroundWork& operator=(const BackgroundWork&) = delete;

    /// Whether the function has ended. Then rethrows its exception, if any. Must not be called again
    /// after that.
    bool ended()
    {
        if (end_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            return false;
        end_.get();
        return true;
    }
    double part() const { return part_; } ///< that is done, 0 to 1

private:
    std::atomic<bool> stopped_ = false;
    std::atomic<double> part_ = 0;
    std::future<void> end_; ///< last: the function uses the others
};

} // namespace integral

#endif
