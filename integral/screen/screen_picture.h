// SPDX-License-Identifier: AGPL-3.0-or-later
// Converts pictures to a display's pixel format; decodes a sequence of them ahead of time in
// threads.
#ifndef INTEGRAL_SCREEN_SCREEN_PICTURE_H
#define INTEGRAL_SCREEN_SCREEN_PICTURE_H

#include "integral/frame/image.h"

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <vector>

namespace integral {

/// A picture in a display's pixel format: row by row from the top left, each pixel 0xffRRGGBB.
struct ScreenPicture {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
};

/// Converts a picture. Keeps 8-bit samples, rounds 16-bit samples to 8 bits, and encodes linear
/// light as sRGB. A picture with alpha is composited over black.
ScreenPicture screen_picture(const Image& image);

/// Number of pictures of `bytes_each` to decode ahead: 2 to 64, if possible within 1 GB and a
/// quarter of the machine's memory.
int pictures_to_keep(std::size_t bytes_each);

/// Decodes the pictures of a sequence, numbered 0, 1, 2 ..., ahead of time in threads of its own.
/// All calls must come from one thread.
class PicturesAhead {
public:
    /// Makes a picture of what was read for it.
    using Completion = std::function<ScreenPicture()>;
    struct Source {
        long long count = 0; ///< number of files; `read` finds it by itself
        bool loop = false;   ///< the first file follows the last one, with the next number
        int keep = 2;        ///< pictures in memory, including those that are being decoded
        int threads = 1;     ///< decoding threads
        std::function<ScreenPicture(long long file)> load; ///< called by several threads at once
        /// In place of `load`, for sequences that can only be read in order: reads file 0, 1, 2 and
        /// so on, and file 0 again for a loop, in one call at a time. Returns nothing after the
        /// last file. Several threads at once call the results. Results for overdue pictures are
        /// never called.
        std::function<Completion(long long file)> read = nullptr;
    };
    struct Ready {
        long long number = 0;
        std::shared_ptr<const ScreenPicture> picture;
    };

    /// Begins to decode.
    explicit PicturesAhead(Source source);
    ~PicturesAhead();
    PicturesAhead(const PicturesAhead&) = delete;
    PicturesAhead& operator=(const PicturesAhead&) = delete;

    /// Whether `keep` pictures, or all, are ready. Rethrows what `load` threw.
    bool is_full();

    /// Number of files; the greatest number there is as long as `read` has not found the end.
    long long count();

    /// Takes the newest ready picture with a number of at most `due` and above all numbers taken
    /// before; nothing if there is none. Drops older pictures. From now on, decoding begins with
    /// picture `due`. Rethrows what `load` or `read` threw.
    std::optional<Ready> take(long long due);

private:
    void work();
    bool decode_next();
    std::shared_ptr<const ScreenPicture> decode(long long number, long long file,
                                                std::unique_lock<std::mutex> turn);
    bool may_begin() const;
    std::size_t file(long long number) const { return std::size_t(number % count_); }

    const Source source_;
    std::mutex turn_; ///< of the thread that reads; locked before mutex_
    std::mutex mutex_;
    long long count_;
    std::condition_variable room_;
    std::map<long long, std::shared_ptr<const ScreenPicture>> ready_;
    /// Each file's picture, decoded once, if all files fit into `keep`; else empty.
    std::vector<std::shared_ptr<const ScreenPicture>> files_;
    std::exception_ptr failure_;
    /// Numbers of the next picture to decode, the last one taken, and the first one not overdue.
    long long next_ = 0, taken_ = -1, due_ = 0;
    std::multiset<std::size_t> begun_; ///< files that are being decoded
    bool stop_ = false;
    std::vector<std::thread> threads_;
};

} // namespace integral

#endif
