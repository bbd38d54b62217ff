// SPDX-License-Identifier: AGPL-3.0-or-later
// A picture as a display takes it, and a sequence of them that threads decode ahead of time.
#ifndef INTEGRAL_OUTPUT_SCREEN_PICTURE_H
#define INTEGRAL_OUTPUT_SCREEN_PICTURE_H

#include "integral/lightfield/image.h"

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace integral {

/// Row by row from the top left, each pixel 0xffRRGGBB.
struct ScreenPicture {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
};

/// 8-bit samples as they are, 16-bit ones rounded to 8 bits, linear light as sRGB; over black where
/// there is alpha.
ScreenPicture screen_picture(const Image& image);

/// How many pictures of so many bytes are kept ahead: at most 64, a GB and a quarter of the
/// machine's memory, but at least 2.
int pictures_to_keep(std::size_t bytes_each);

/// Numbers the pictures of a sequence 0, 1, 2 ... and decodes them ahead, `keep` at a time. All of
/// its functions are for one thread.
class PicturesAhead {
public:
    struct Source {
        long long count = 0; ///< of the files
        bool loop = false;   ///< after the last file comes the first again, with the next number
        int keep = 2;        ///< pictures in memory, those that are being decoded among them
        int threads = 1;
        std::function<ScreenPicture(long long file)> load; ///< called by several threads at once
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

    /// Whether as many pictures as can be kept, or all, are ready. Rethrows what `load` threw.
    bool is_full();

    /// The newest picture that is ready up to number `due`, and newer than those taken before;
    /// older ones are given up, and of those up to `due` no other is begun. Rethrows what `load`
    /// threw.
    std::optional<Ready> take(long long due);

private:
    void work();
    bool may_begin() const;

    const Source source_;
    std::mutex mutex_;
    std::condition_variable room_;
    std::map<long long, std::shared_ptr<const ScreenPicture>> ready_;
    std::vector<std::shared_ptr<const ScreenPicture>> files_; ///< all of them, where they can be
                                                              ///< kept: a loop decodes each once
    std::exception_ptr failure_;
    long long next_ = 0, taken_ = -1; ///< numbers
    int begun_ = 0;
    bool stop_ = false;
    std::vector<std::thread> threads_;
};

} // namespace integral

#endif
