// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes WebM and MP4 videos of pictures with the program ffmpeg, if it is installed.
#ifndef INTEGRAL_IO_VIDEO_H
#define INTEGRAL_IO_VIDEO_H

#include "integral/base/atomic_file.h"
#include "integral/frame/image.h"

#include <memory>
#include <string>
#include <vector>

namespace integral {

/// Whether a path names a video: it ends in .webm (VP9) or .mp4 (H.264), in any case.
bool is_video(const std::string& path);

/// A video of pictures of the same size: 8 bits, chroma at half resolution (4:2:0), without sound.
/// Nothing is written under its path before finish().
class Video {
public:
    /// `quality`: 0 to 100 (best). `there_and_back`: the pictures are kept in memory until
    /// finish(). Throws OutputError if ffmpeg is not installed.
    Video(const std::string& path, int quality, double pictures_a_second, bool there_and_back);
    ~Video();
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    /// Appends a picture. Throws OutputError if its size differs from the first picture's, if an
    /// MP4's width or height is odd, or if ffmpeg has ended.
    void add(const Image& picture);

    /// Completes the file. With `there_and_back`, the inner pictures follow in reverse order.
    /// Throws OutputError with the first line that ffmpeg printed if ffmpeg fails.
    void finish();

private:
    class Encoder; ///< the running program
    [[noreturn]] void fail(const std::string& what) const;

    std::string path_;
    int quality_;
    double pictures_a_second_;
    bool there_and_back_;
    int width_ = 0, height_ = 0;
    std::vector<Image> kept_;
    std::unique_ptr<AtomicFile> file_;
    std::unique_ptr<Encoder> encoder_; ///< from the first picture on
};

} // namespace integral

#endif
