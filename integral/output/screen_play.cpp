// SPDX-License-Identifier: AGPL-3.0-or-later
// Decides which picture is shown at which time.
#include "integral/output/screen_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace integral {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Clock::duration duration_of(double seconds)
{
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

constexpr double longest_wait = 0.05; // seconds between calls of go_on

} // namespace

bool show_still(ScreenWindow& window, const ScreenPicture& picture, double seconds,
                const std::function<bool()>& go_on)
{
    window.show(picture);
    const Clock::time_point start = Clock::now();
    while (go_on()) {
        const double left = seconds > 0 ? seconds - since(start) : longest_wait;
        if (left <= 0 || window.wait(duration_of(std::min(left, longest_wait))) == Wish::end)
            return true;
    }
    return false;
}

PlayReport play(ScreenWindow& window, const Playing& playing, const std::function<bool()>& go_on)
{
    PicturesAhead pictures(playing.source);
    PlayReport report;
    while (!pictures.is_full()) {
        report.interrupted = !go_on();
        if (report.interrupted || window.wait(duration_of(longest_wait)) == Wish::end)
            return report;
    }

    const double period = 1 / playing.rate;
    long long total = playing.source.loop ? std::numeric_limits<long long>::max()
                                          : playing.source.count; // that come due
    double end = playing.source.loop ? INFINITY : double(total) * period;
    if (playing.seconds > 0 && playing.seconds < end) {
        end = playing.seconds;
        total = static_cast<long long>(std::ceil(end / period - 1e-9));
    }
    const auto due_at = [&](double now) {
        return std::min(static_cast<long long>(now / period + 1e-9), total - 1);
    };

    window.show(*pictures.take(0)->picture);
    report.shown = 1;
    long long newest = 0;
    Clock::time_point start = Clock::now(); // each pause makes it later
    double last_shown = 0;
    double now = 0;
    for (;;) {
        now = since(start);
        report.interrupted = !go_on();
        if (report.interrupted || now >= end)
            break;
        const long long due = due_at(now);
        double wait = double(newest + 1) * period - now;
        if (due > newest) {
            if (const auto ready = pictures.take(due)) {
                window.show(*ready->picture);
                now = last_shown = since(start);
                ++report.shown;
                report.dropped += ready->number - newest - 1;
                newest = ready->number;
                report.worst_lateness = std::max(report.worst_lateness,
                                                 now - double(newest) * period);
                wait = double(newest + 1) * period - now;
            } else {
                wait = 0.001; // it is due, but not decoded yet
            }
        }
        Wish wish = window.wait(
            duration_of(std::clamp(std::min(wait, end - now), 0.0, longest_wait)));
        if (wish == Wish::pause) {
            const Clock::time_point paused = Clock::now();
            do {
                wish = window.wait(duration_of(longest_wait));
                report.interrupted = !go_on();
            } while (wish == Wish::none && !report.interrupted);
            start += Clock::now() - paused;
        }
        if (wish == Wish::end || report.interrupted) {
            now = since(start);
            break;
        }
    }
    report.dropped += std::max(0LL, due_at(now) - newest);
    report.seconds = last_shown;
    if (report.shown > 1 && report.seconds > 0)
        report.rate = double(report.shown - 1) / report.seconds;
    return report;
}

} // namespace integral
