// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/pass_schedule.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace integral {

PassSchedule::PassSchedule(PictureBlock area, int side, std::vector<SchedulePass> passes)
    : area_(area),
      side_(side),
      rows_((area.bottom - area.top + side) / side),
      columns_((area.right - area.left + side) / side),
      passes_(std::move(passes)),
      finished_above_(passes_.size())
{
    std::vector<int> delays; // of each pass behind the first pass, in rows of blocks
    for (int pass = 0; pass < int(passes_.size()); ++pass) {
        left_.emplace_back(std::size_t(rows_));
        // One row more, so that no thread has to wait for the last blocks of a row.
        delays.push_back(pass == 0 ? 0 : delays.back() + blocks_around(pass) + 1);
    }
    ahead_ = delays.back();
    for (int step = 0; step < rows_ + ahead_; ++step)
        for (int pass = 0; pass < int(passes_.size()); ++pass)
            if (const int row = step - delays[std::size_t(pass)]; row >= 0 && row < rows_)
                append_row(pass, row);
}

void PassSchedule::append_row(int pass, int row)
{
    const std::vector<bool>& works = passes_[std::size_t(pass)].rows;
    const auto begin = works.begin() + row * side_,
               end = works.begin() + std::min((row + 1) * side_, int(works.size()));
    const auto first = std::find(begin, end, true);
    if (first == end)
        return;
    auto last = end - 1;
    while (!*last)
        --last;
    for (int column = 0; column < columns_; ++column) {
        const int x = area_.left + column * side_;
        items_.push_back(
            {pass,
             {x, area_.top + int(first - works.begin()), std::min(x + side_ - 1, area_.right),
              area_.top + int(last - works.begin())}});
    }
    left_[std::size_t(pass)][std::size_t(row)] = columns_;
}

std::optional<PassSchedule::Item> PassSchedule::next()
{
    const std::size_t index = given_++;
    if (index >= items_.size())
        return {};
    return items_[index];
}

bool PassSchedule::is_ready(const Item& item) const
{
    if (item.pass == 0)
        return first_unfinished(int(passes_.size()) - 1) >= row_of(item) - ahead_;
    const int row = row_of(item), around = blocks_around(item.pass);
    for (int k = std::max(0, row - around); k <= std::min(rows_ - 1, row + around); ++k)
        if (left_[std::size_t(item.pass - 1)][std::size_t(k)] > 0)
            return false;
    return true;
}

int PassSchedule::first_unfinished(int pass) const
{
    std::atomic<int>& finished_above = finished_above_[std::size_t(pass)];
    int row = finished_above;
    while (row < rows_ && left_[std::size_t(pass)][std::size_t(row)] == 0)
        ++row;
    finished_above = row;
    return row;
}

int PassSchedule::first_needed(int pass) const
{
    const int row = first_unfinished(pass);
    return row == rows_ ? std::numeric_limits<int>::max()
                        : area_.top + row * side_ - passes_[std::size_t(pass)].reach;
}

void PassSchedule::finish(const Item& item)
{
    --left_[std::size_t(item.pass)][std::size_t(row_of(item))];
}

} // namespace integral
