// SPDX-License-Identifier: AGPL-3.0-or-later
// Decides which picture is shown when.
#include "integral/screen/screen_window.h"

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

/// When pictures come due, in seconds from the first one.
struct Schedule {
    double period, end = INFINITY;
    long long total = std::numeric_limits<long long>::max(); ///< pictures that are due before `end`

    long long due_at(double now) const
    {
        return std::min(static_cast<long long>(now / period + 1e-9), total - 1);
    }

    /// Ends with picture number `count` - 1 at the latest.
    void limit(long long count)
    {
        if (count < total) {
            total = count;
            end = std::min(end, double(count) * period);
        }
    }
};

Schedule schedule_of(const Playing& playing)
{
    Schedule schedule{1 / playing.rate};
    if (playing.seconds > 0) {
        schedule.end = playing.seconds;
        schedule.total = static_cast<long long>(std::ceil(schedule.end / schedule.period - 1e-9));
    }
    return schedule;
}

/// Plays pictures once; its functions share the clock and the report.
class Player {
public:
    Player(ScreenWindow& window, const Playing& playing, const std::function<bool()>& go_on)
        : window_(window),
          go_on_(go_on),
          loops_(playing.source.loop),
          pictures_(playing.source),
          schedule_(schedule_of(playing))
    {
    }

    PlayReport play();

private:
    bool fill();
    double show_due();
    Wish wait_out_pause();

    ScreenWindow& window_;
    const std::function<bool()>& go_on_;
    const bool loops_;
    PicturesAhead pictures_;
    Schedule schedule_;
    PlayReport report_;
    long long newest_ = 0;            ///< number of the last picture shown
    Clock::time_point start_{};       ///< moved later by each pause
    double now_ = 0, last_shown_ = 0; ///< seconds from the start
};

/// Waits until the first pictures are decoded. Returns whether to play them.
bool Player::fill()
{
    while (!pictures_.is_full()) {
        report_.interrupted = !go_on_();
        if (report_.interrupted || window_.wait(duration_of(longest_wait)) == Wish::end)
            return false;
    }
    return true;
}

/// Shows the newest picture that is due, if it is not shown yet. Returns the seconds until the next
/// call is worthwhile.
double Player::show_due()
{
    const double period = schedule_.period;
    const long long due = schedule_.due_at(now_);
    if (due > newest_) {
        const auto ready = pictures_.take(due);
        if (!ready)
            return 0.001; // it is due, but not decoded yet
        window_.show(*ready->picture);
        now_ = last_shown_ = since(start_);
        ++report_.shown;
        report_.dropped += ready->number - newest_ - 1;
        newest_ = ready->number;
        report_.worst_lateness = std::max(report_.worst_lateness, now_ - double(newest_) * period);
    }
    return double(newest_ + 1) * period - now_;
}

/// Waits until the viewer ends the pause or the playing, or go_on returns false. Returns the wish.
Wish Player::wait_out_pause()
{
    const Clock::time_point paused = Clock::now();
    Wish wish;
    do {
        wish = window_.wait(duration_of(longest_wait));
        report_.interrupted = !go_on_();
    } while (wish == Wish::none && !report_.interrupted);
    start_ += Clock::now() - paused;
    return wish;
}

PlayReport Player::play()
{
    if (!fill())
        return report_;
    window_.show(*pictures_.take(0)->picture);
    report_.shown = 1;
    start_ = Clock::now();
    for (;;) {
        now_ = since(start_);
        report_.interrupted = !go_on_();
        if (!loops_)
            schedule_.limit(pictures_.count()); // the end may have been found meanwhile
        if (report_.interrupted || now_ >= schedule_.end)
            break;
        const double wait = show_due();
        Wish wish = window_.wait(
            duration_of(std::clamp(std::min(wait, schedule_.end - now_), 0.0, longest_wait)));
        if (wish == Wish::pause)
            wish = wait_out_pause();
        if (wish == Wish::end || report_.interrupted) {
            now_ = since(start_);
            break;
        }
    }
    report_.dropped += std::max(0LL, schedule_.due_at(now_) - newest_);
    report_.seconds = last_shown_;
    if (report_.shown > 1 && report_.seconds > 0)
        report_.rate = double(report_.shown - 1) / report_.seconds;
    return report_;
}

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
    return Player(window, playing, go_on).play();
}

} // namespace integral
