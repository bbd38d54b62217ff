// SPDX-License-Identifier: AGPL-3.0-or-later
// Shows a file on a panel that is connected to this machine, by integral lcd.
#ifndef INTEGRAL_STUDIO_PANEL_WINDOW_H
#define INTEGRAL_STUDIO_PANEL_WINDOW_H

#include "integral/batch/child_process.h"
#include "integral/batch/renderer.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace integral {

/// One window at a time; it ends with this object, by Escape, and when another is opened.
class PanelWindow {
public:
    /// Opens a window with the image for `panel`, a name or a .json, of `file`. Returns integral
    /// lcd's message if it ends within a second, else an empty text. For any thread but the first.
    std::string open(const std::string& file, const std::string& panel);

    /// Starts and watches the window. Call it several times a second, from the first thread.
    void work();

private:
    struct Window {
        ScratchFolder scratch; ///< of what integral lcd says
        std::optional<ChildProcess> child;
        std::chrono::steady_clock::time_point began;
    };

    void start();
    void watch();
    void settle(const std::string& problem);

    std::mutex mutex_; ///< guards the next three
    std::condition_variable settled_;
    std::vector<std::string> words_; ///< of integral's command line; empty: nothing is to be opened
    std::optional<std::string> problem_; ///< of the window that open() waits for, once it is known
    std::mutex one_at_a_time_;           ///< held by open()

    std::optional<Window> window_; ///< used by the first thread alone
};

} // namespace integral

#endif
