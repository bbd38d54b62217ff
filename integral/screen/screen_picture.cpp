// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/screen/screen_picture.h"

#include <algorithm>
#include <limits>
#include <unistd.h>

namespace integral {

ScreenPicture screen_picture(const Image& image)
{
    const bool is_linear = image.encoding.kind == Encoding::Kind::linear;
    const bool over_black = image.channels == 4;
    // Colours premultiplied by alpha equal the colours over black.
    if (sample_bits(image) != 8 || is_linear || (over_black && !image.premultiplied))
        return screen_picture(
            converted(image, 8, is_linear ? Encoding() : image.encoding, over_black));
    ScreenPicture picture{image.width, image.height,
                          std::vector<std::uint32_t>(std::size_t(image.width) * image.height)};
    const std::uint8_t* sample = std::get<std::vector<std::uint8_t>>(image.samples).data();
    for (std::uint32_t& pixel : picture.pixels) {
        pixel = 0xff000000u | std::uint32_t(sample[0]) << 16 | std::uint32_t(sample[1]) << 8 |
                sample[2];
        sample += image.channels;
    }
    return picture;
}

int pictures_to_keep(std::size_t bytes_each)
{
    const double memory = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
    const double most = std::min(memory / 4, 1e9);
    return std::clamp(int(most / double(std::max<std::size_t>(bytes_each, 1 << 20))), 2, 64);
}

PicturesAhead::PicturesAhead(Source source)
    : source_(std::move(source)),
      count_(source_.read ? std::numeric_limits<long long>::max() : source_.count)
{
    if (count_ <= source_.keep)
        files_.resize(std::size_t(count_));
    for (int k = 0; k < std::min(source_.threads, source_.keep); ++k)
        threads_.emplace_back([this] { work(); });
}

PicturesAhead::~PicturesAhead()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        stop_ = true;
    }
    room_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
}

bool PicturesAhead::may_begin() const
{
    // A retained file waits for the thread that is already decoding it.
    const bool waits = !files_.empty() && begun_.count(file(next_)) > 0;
    return (source_.loop || next_ < count_) && !waits &&
           int(ready_.size() + begun_.size()) < source_.keep;
}

void PicturesAhead::work()
{
    while (decode_next()) {
    }
}

/// Reads or loads the picture of a file, which is not among files_. Returns nothing if it is
/// overdue or past the end. `turn`: a lock of turn_, held until the picture has been read.
std::shared_ptr<const ScreenPicture> PicturesAhead::decode(long long number, long long file,
                                                           std::unique_lock<std::mutex> turn)
{
    if (!source_.read)
        return std::make_shared<const ScreenPicture>(source_.load(file));
    const Completion complete = source_.read(file);
    bool is_overdue = false;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!complete && number < count_)
            next_ = count_ = number;
        is_overdue = number < due_;
    }
    turn.unlock();
    return complete && !is_overdue ? std::make_shared<const ScreenPicture>(complete()) : nullptr;
}

/// Decodes one picture as soon as there is room. Returns false if decoding is to end.
bool PicturesAhead::decode_next()
{
    std::unique_lock<std::mutex> turn(turn_, std::defer_lock);
    if (source_.read)
        turn.lock();
    std::unique_lock<std::mutex> lock(mutex_);
    room_.wait(lock, [this] { return stop_ || failure_ || may_begin(); });
    if (stop_ || failure_)
        return false;
    const long long number = next_++;
    const std::size_t which = file(number);
    std::shared_ptr<const ScreenPicture> picture = files_.empty() ? nullptr : files_[which];
    const auto begun = begun_.insert(which);
    if (!picture) {
        lock.unlock();
        std::exception_ptr failure;
        try {
            picture = decode(number, static_cast<long long>(which), std::move(turn));
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (failure) {
            failure_ = failure;
            room_.notify_all();
            return false;
        }
    }
    begun_.erase(begun);
    if (!files_.empty())
        files_[which] = picture;
    if (picture && number > taken_)
        ready_.emplace(number, std::move(picture));
    room_.notify_all();
    return true;
}

bool PicturesAhead::is_full()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    if (failure_)
        std::rethrow_exception(failure_);
    return begun_.empty() && !may_begin();
}

long long PicturesAhead::count()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return count_;
}

std::optional<PicturesAhead::Ready> PicturesAhead::take(long long due)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    if (failure_)
        std::rethrow_exception(failure_);
    std::optional<Ready> newest;
    const auto later = ready_.upper_bound(due);
    if (later != ready_.begin()) {
        newest = Ready{std::prev(later)->first, std::prev(later)->second};
        ready_.erase(ready_.begin(), later);
        taken_ = newest->number;
    }
    due_ = std::max(due_, due);
    if (!source_.read)
        next_ = std::max(next_, due); // overdue pictures are not decoded
    room_.notify_all();
    return newest;
}

} // namespace integral
