// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/studio/panel_window.h"

#include "integral/base/file_bytes.h"

namespace integral {

std::string PanelWindow::open(const std::string& file, const std::string& panel)
{
    const std::lock_guard one(one_at_a_time_);
    std::unique_lock lock(mutex_);
    words_ = {own_program(), "lcd", file, "--panel", panel, "--show", "auto"};
    problem_.reset();
    // The first thread may be at its end, and answers no longer.
    settled_.wait_for(lock, std::chrono::seconds(5), [&] { return problem_.has_value(); });
    return problem_.value_or("the window is not open yet; try again");
}

void PanelWindow::work()
{
    try {
        start();
        watch();
    } catch (const std::exception& error) {
        window_.reset();
        settle(error.what());
    }
}

/// Starts what open() requests.
void PanelWindow::start()
{
    std::vector<std::string> words;
    {
        const std::lock_guard lock(mutex_);
        words.swap(words_);
    }
    if (words.empty())
        return;
    window_.emplace();
    window_->began = std::chrono::steady_clock::now();
    window_->child.emplace(words, ".", window_->scratch.path("said.txt"));
}

void PanelWindow::watch()
{
    constexpr auto time_to_fail = std::chrono::seconds(1);
    if (!window_)
        return;
    if (const auto end = window_->child->ended()) {
        settle(end->status == 0 ? "" : reason_in(read_file(window_->scratch.path("said.txt"))));
        window_.reset();
    } else if (std::chrono::steady_clock::now() - window_->began > time_to_fail)
        settle("");
}

void PanelWindow::settle(const std::string& problem)
{
    const std::lock_guard lock(mutex_);
    if (!problem_ && words_.empty()) {
        problem_ = problem;
        settled_.notify_all();
    }
}

} // namespace integral
