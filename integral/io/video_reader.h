// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads the pictures of a video with the programs ffmpeg and ffprobe, if they are installed.
#ifndef INTEGRAL_IO_VIDEO_READER_H
#define INTEGRAL_IO_VIDEO_READER_H

#include "integral/base/json.h"
#include "integral/frame/image.h"

#include <memory>
#include <string>
#include <vector>

namespace integral {

/// A video's pictures, one after another: every picture that the file holds, once, 8 bits, turned
/// upright as the file requests. All functions that read throw InputError and Interrupted.
class VideoReader {
public:
    /// Opens a video. `from`: seconds; the first picture is the first one at or after this time.
    /// Throws InputError if the programs are not installed, or if there is no picture.
    explicit VideoReader(const std::string& path, double from = 0);
    ~VideoReader();
    VideoReader(const VideoReader&) = delete;
    VideoReader& operator=(const VideoReader&) = delete;

    const std::string& path() const { return path_; }
    /// Size, sample type and encoding of every picture.
    const Image& form() const { return form_; }
    /// Pictures a second, on average; 30 if the file does not state it.
    double rate() const { return rate_; }
    /// Whether the times between pictures differ.
    bool rate_varies() const { return rate_varies_; }
    /// Number of pictures according to the file; the pictures that can be read may differ. Reads
    /// the whole file, but decodes nothing.
    long long stated_count() const;

    /// Reads the next picture into `picture`, a picture read before or an empty one. Returns false
    /// after the last.
    bool read(Image& picture);

    /// Begins again at the first picture.
    void rewind();

    /// The first line that ffmpeg has printed about faults in the file; empty if there is none.
    std::string fault() const;

private:
    class Decoder; ///< the running program
    Json stream_fields(const std::vector<std::string>& words) const;
    void probe();
    void start();
    bool read_header(Image& form);
    std::vector<std::string> decoder_words() const;
    [[noreturn]] void fail(const std::string& what) const;

    const std::string path_;
    const double from_;
    Image form_;
    double rate_ = 30;
    bool rate_varies_ = false;
    bool guesses_hd_ = false;     ///< the file does not state its colours, and is large
    bool header_is_read_ = false; ///< of the next picture
    bool has_begun_ = false;      ///< a picture has been read since the start
    std::unique_ptr<Decoder> decoder_;
};

/// The first picture of a video at or after this time, s. Throws as VideoReader does.
Image picture_of_video(const std::string& path, double seconds);

} // namespace integral

#endif
