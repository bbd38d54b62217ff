// SPDX-License-Identifier: AGPL-3.0-or-later
// Tests the order in which threads work on the blocks of a picture in several passes.
#include "integral/reconstruction/pass_schedule.h"

#include <boost/test/unit_test.hpp>
#include <memory>
#include <mutex>
#include <random>
#include <thread>

using namespace integral;

namespace {

constexpr int left = 3, top = 5, width = 70, height = 101, side = 8;

/// The rows from `first` to `last`.
std::vector<bool> rows(int first, int last)
{
    std::vector<bool> result(height);
    std::fill(result.begin() + first, result.begin() + last + 1, true);
    return result;
}

/// Records what has been worked on, pass by pass and pixel by pixel.
class Record {
public:
    explicit Record(std::vector<SchedulePass> passes)
        : passes_(std::move(passes)),
          done_(passes_.size(), std::vector<int>(std::size_t(width) * height)),
          schedule({left, top, left + width - 1, top + height - 1}, side, passes_)
    {
    }

    void work(const PassSchedule::Item& item)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        const PictureBlock& b = item.block;
        const std::size_t pass = std::size_t(item.pass);
        if (pass > 0)
            for (int y = b.top - passes_[pass].reach; y <= b.bottom + passes_[pass].reach; ++y)
                for (int x = 0; x < width; ++x)
                    if (y >= top && y < top + height &&
                        passes_[pass - 1].rows[std::size_t(y - top)])
                        missing += done_[pass - 1][index(left + x, y)] == 0;
        for (int y = b.top; y <= b.bottom; ++y)
            for (int x = b.left; x <= b.right; ++x)
                ++done_[pass][index(x, y)];
    }

    /// Counts, over all passes, the pixels in the pass's rows that it has worked on never, or more
    /// than once.
    int not_once() const
    {
        int number = 0;
        for (std::size_t pass = 0; pass < passes_.size(); ++pass)
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    if (passes_[pass].rows[std::size_t(y)])
                        number += done_[pass][std::size_t(y) * width + x] != 1;
        return number;
    }

    int missing = 0; ///< pixels that an item needed and that were not finished

private:
    static std::size_t index(int x, int y) { return std::size_t(y - top) * width + (x - left); }
    std::vector<SchedulePass> passes_;
    std::vector<std::vector<int>> done_;
    std::mutex mutex_;

public:
    PassSchedule schedule;
};

std::vector<SchedulePass> passes()
{
    return {{rows(0, height - 1), 0}, {rows(9, 90), 11}, {rows(20, 80), 17}, {rows(30, 60), 3}};
}

} // namespace

BOOST_AUTO_TEST_SUITE(reconstruction_pass_schedule)

BOOST_AUTO_TEST_CASE(one_thread_never_waits)
{
    Record record(passes());
    while (const auto item = record.schedule.next()) {
        BOOST_TEST_REQUIRE(record.schedule.is_ready(*item));
        record.work(*item);
        record.schedule.finish(*item);
    }
    BOOST_TEST(record.missing == 0);
    BOOST_TEST(record.not_once() == 0);
}

BOOST_AUTO_TEST_CASE(threads_wait_for_what_they_need)
{
    Record record(passes());
    int waits = 0;
    std::mutex mutex;
    std::vector<std::thread> threads;
    for (unsigned k = 0; k < 5; ++k)
        threads.emplace_back([&, k] {
            std::mt19937 random(k);
            while (const auto item = record.schedule.next()) {
                while (!record.schedule.is_ready(*item)) {
                    const std::lock_guard<std::mutex> lock(mutex);
                    ++waits;
                }
                if (random() % 8 == 0) // some blocks take longer
                    std::this_thread::sleep_for(std::chrono::milliseconds(2));
                record.work(*item);
                record.schedule.finish(*item);
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    BOOST_TEST(record.missing == 0);
    BOOST_TEST(record.not_once() == 0);
}

BOOST_AUTO_TEST_CASE(an_item_is_not_ready_before_what_it_needs)
{
    Record record(passes());
    int held_back = 0;
    PassSchedule::Item kept; // never finished
    bool keeps = false;
    while (const auto item = record.schedule.next()) {
        if (item->pass == 1 && !keeps) {
            kept = *item;
            keeps = true;
            continue;
        }
        const bool ready = record.schedule.is_ready(*item);
        const bool needs = item->pass == 2 && item->block.top - 17 - side < kept.block.bottom;
        held_back += !ready;
        BOOST_TEST((ready || needs || item->pass == 3));
        if (ready)
            record.schedule.finish(*item);
    }
    BOOST_TEST(held_back > 0);
}

BOOST_AUTO_TEST_CASE(the_first_rows_are_finished_early)
{
    // With all rows in four passes, the first block of the last pass comes long before the last of
    // the first.
    std::vector<SchedulePass> all(4, {rows(0, height - 1), 4});
    Record record(all);
    int before = 0;
    bool begun = false;
    while (const auto item = record.schedule.next()) {
        begun = begun || item->pass == 3;
        before += !begun && item->pass == 0;
    }
    BOOST_TEST(before <= 7 * ((width + side - 1) / side));
}

// A block of the last pass that takes long holds the first pass back, so that the rows in use stay
// few.
BOOST_AUTO_TEST_CASE(the_first_pass_waits_for_the_last)
{
    Record record(std::vector<SchedulePass>(4, {rows(0, height - 1), 4}));
    std::optional<PassSchedule::Item> held; // the first block of the last pass
    int lowest = 0;                         // row in which the first pass works
    while (const auto item = record.schedule.next()) {
        if (!record.schedule.is_ready(*item)) {
            BOOST_TEST_REQUIRE(item->pass == 0);
            break;
        }
        if (item->pass == 0)
            lowest = item->block.bottom;
        if (item->pass == 3 && !held)
            held = *item;
        else
            record.schedule.finish(*item);
    }
    BOOST_TEST_REQUIRE(held.has_value());
    BOOST_TEST(lowest < held->block.top + 8 * side);
    BOOST_TEST(lowest < top + height - 1);
}

BOOST_AUTO_TEST_CASE(rows_are_needed_until_their_passes_have_finished)
{
    Record record(passes());
    std::vector<int> before(4, 0);
    int left_behind = 0;
    while (const auto item = record.schedule.next()) {
        for (int pass = 0; pass < 4; ++pass) {
            const int needed = record.schedule.first_needed(pass);
            BOOST_TEST_REQUIRE(needed >= before[std::size_t(pass)]);
            before[std::size_t(pass)] = needed;
            const int reach = passes()[std::size_t(pass)].reach;
            if (item->pass == pass)
                BOOST_TEST_REQUIRE(needed <= item->block.top - reach);
            left_behind += needed > top;
        }
        record.schedule.finish(*item);
    }
    BOOST_TEST(left_behind > 0);
    for (int pass = 0; pass < 4; ++pass)
        BOOST_TEST(record.schedule.first_needed(pass) > top + height);
}

BOOST_AUTO_TEST_SUITE_END()
