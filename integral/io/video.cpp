// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/video.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"
#include "integral/base/programs.h"
#include "integral/io/ffmpeg_run.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <optional>
#include <sys/socket.h>
#include <unistd.h>

namespace integral {
namespace {

/// The words of ffmpeg's command: pictures from its standard input, encoded into `file`.
std::vector<std::string> words_of(const std::string& path, const std::string& file, int width,
                                  int height, double pictures_a_second, int quality)
{
    const bool webm = extension_of(path) == "webm";
    // The encoders' scale runs from 0 (no visible loss) to 63 or 51.
    const long lossy = std::lround((webm ? 63 : 51) * std::sqrt(1 - quality / 100.0));
    std::vector<std::string> words = {"ffmpeg",
                                      "-hide_banner",
                                      "-loglevel",
                                      "error",
                                      "-y",
                                      "-f",
                                      "rawvideo",
                                      "-pixel_format",
                                      "rgb24",
                                      "-video_size",
                                      std::to_string(width) + "x" + std::to_string(height),
                                      "-framerate",
                                      with_digits(pictures_a_second, 10),
                                      "-i",
                                      "-",
                                      "-vf",
                                      "scale=out_color_matrix=bt709",
                                      "-pix_fmt",
                                      "yuv420p",
                                      "-colorspace",
                                      "bt709",
                                      "-color_primaries",
                                      "bt709",
                                      "-color_trc",
                                      "iec61966-2-1",
                                      "-crf",
                                      std::to_string(lossy)};
    const auto add = [&](std::initializer_list<const char*> more) {
        words.insert(words.end(), more.begin(), more.end());
    };
    if (webm)
        add({"-c:v", "libvpx-vp9", "-b:v", "0", "-row-mt", "1", "-f", "webm"});
    else
        add({"-c:v", "libx264", "-movflags", "+faststart", "-f", "mp4"});
    words.push_back("file:" + file);
    return words;
}

} // namespace

/// Runs ffmpeg as a child process that reads from a socket; if ffmpeg ends, writing to the socket
/// sends no signal that would kill this program.
class Video::Encoder {
public:
    explicit Encoder(const std::vector<std::string>& words)
    {
        int ends[2] = {-1, -1};
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
            throw OutputError(std::string("ffmpeg: ") + std::strerror(errno));
        input_ = ends[0];
        program_.emplace(words, ends[1], -1);
        close(ends[1]);
    }

    ~Encoder()
    {
        if (input_ >= 0)
            close(input_);
    }

    /// Writes to ffmpeg; returns whether it has taken all bytes.
    bool write(const std::uint8_t* bytes, std::size_t count)
    {
        while (program_->has_started() && count > 0) {
            const ssize_t sent = send(input_, bytes, count, MSG_NOSIGNAL);
            if (sent < 0 && errno != EINTR)
                return false;
            stop_if_interrupted();
            bytes += sent > 0 ? sent : 0;
            count -= sent > 0 ? std::size_t(sent) : 0;
        }
        return program_->has_started();
    }

    /// Closes ffmpeg's input and waits for its end. Returns the error; empty if there is none.
    std::string end()
    {
        close(input_);
        input_ = -1;
        return program_->end();
    }

private:
    int input_ = -1;
    std::optional<FfmpegRun> program_;
};

bool is_video(const std::string& path)
{
    const std::string extension = extension_of(path);
    return extension == "webm" || extension == "mp4";
}

Video::Video(const std::string& path, int quality, double pictures_a_second, bool there_and_back)
    : path_(path),
      quality_(quality),
      pictures_a_second_(pictures_a_second),
      there_and_back_(there_and_back)
{
    if (!program_on_path("ffmpeg"))
        fail("a video needs the program ffmpeg, which is not installed (Debian's package ffmpeg); "
             "a name that ends in .webp gives an animation without it");
}

Video::~Video() = default;

void Video::fail(const std::string& what) const { throw OutputError(path_ + ": " + what); }

void Video::add(const Image& picture)
{
    if (!encoder_) {
        width_ = picture.width;
        height_ = picture.height;
        if (extension_of(path_) == "mp4" && (width_ % 2 != 0 || height_ % 2 != 0))
            fail("an MP4 has an even number of pixels both ways, and these pictures have " +
                 std::to_string(width_) + "x" + std::to_string(height_) +
                 "; another --size, or a name that ends in .webm, would do");
        const std::string target = target_of(path_),
                          folder = target.substr(0, target.rfind('/') + 1);
        file_ = std::make_unique<AtomicFile>(folder + unfinished_name("video"), target);
        encoder_ = std::make_unique<Encoder>(
            words_of(path_, file_->name(), width_, height_, pictures_a_second_, quality_));
    }
    if (picture.width != width_ || picture.height != height_)
        fail("the pictures differ in size");
    Image plain = converted(picture, 8, Encoding(), false);
    if (plain.channels == 4) { // over black
        Image opaque = make_image<std::uint8_t>(width_, height_, 3, plain.encoding);
        const LinearReader light(plain);
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x)
                store_linear(opaque, x, y, light(x, y));
        plain = std::move(opaque);
    }
    const auto& samples = std::get<std::vector<std::uint8_t>>(plain.samples);
    if (!encoder_->write(samples.data(), samples.size()))
        fail("ffmpeg failed: " + encoder_->end());
    if (there_and_back_)
        kept_.push_back(std::move(plain));
}

void Video::finish()
{
    if (!encoder_)
        fail("there are no pictures");
    for (std::size_t i = kept_.size(); i-- > 2;) {
        const auto& samples = std::get<std::vector<std::uint8_t>>(kept_[i - 1].samples);
        if (!encoder_->write(samples.data(), samples.size()))
            break; // end() returns the reason
    }
    const std::string trouble = encoder_->end();
    if (!trouble.empty())
        fail("ffmpeg failed: " + trouble);
    if (const int error = file_->finish())
        fail(std::string("it cannot be written: ") + std::strerror(error));
}

} // namespace integral
