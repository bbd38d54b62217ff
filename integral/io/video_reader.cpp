// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/io/video_reader.h"

#include "integral/base/file_bytes.h"
#include "integral/base/interrupt.h"
#include "integral/base/number_text.h"
#include "integral/base/programs.h"
#include "integral/io/ffmpeg_run.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace integral {
namespace {

using Words = std::vector<std::string>;

Words probe_words(const std::string& path, const Words& more)
{
    Words words = {"ffprobe", "-hide_banner", "-loglevel", "error",           "-protocol_whitelist",
                   "file",    "-of",          "json",      "-select_streams", "V:0"};
    words.insert(words.end(), more.begin(), more.end());
    words.push_back("file:" + path);
    return words;
}

/// Reads a rate such as "30000/1001"; 0 if it is not known.
double rate_in(const Json& stream, const char* field)
{
    int over = 0, under = 0;
    const std::string text = stream.value(field, "");
    return std::sscanf(text.c_str(), "%d/%d", &over, &under) == 2 && over > 0 && under > 0
               ? double(over) / under
               : 0;
}

/// A line of ffmpeg's without the addresses and names that it puts before the fault.
std::string fault_in(const std::string& line, const std::string& path)
{
    const std::size_t bracket = line.rfind("[", 0) == 0 ? line.find("] ") : std::string::npos;
    std::string fault = bracket == std::string::npos ? line : line.substr(bracket + 2);
    const std::string name = "file:" + path + ": ";
    if (fault.rfind(name, 0) == 0)
        fault.erase(0, name.size());
    return fault.substr(0, fault.find_last_not_of(". ") + 1);
}

constexpr double most_pictures_a_second = 1000; // as for --fps
constexpr int hd_width = 1280, hd_height = 577; // videos from here on have the colours of HDTV

bool is_hd(const Json& stream)
{
    return stream.value("width", 0) >= hd_width || stream.value("height", 0) >= hd_height;
}

/// Whether a stream has luma and chroma and does not state their matrix.
bool lacks_matrix(const Json& stream)
{
    return stream.value("pix_fmt", "").rfind("yuv", 0) == 0 &&
           stream.value("color_space", "unknown") == "unknown";
}

} // namespace

/// Runs a program and reads its standard output.
class VideoReader::Decoder {
public:
    explicit Decoder(const Words& words)
    {
        int ends[2] = {-1, -1};
        if (pipe2(ends, O_CLOEXEC) != 0)
            throw InputError(words[0] + ": " + std::strerror(errno));
        output_ = ends[0];
        fcntl(output_, F_SETPIPE_SZ, 1 << 20); // fewer changes of process; no matter if it fails
        program_ = std::make_unique<FfmpegRun>(words, -1, ends[1]);
        close(ends[1]);
    }

    ~Decoder() { close(output_); }

    /// Reads `count` bytes. Returns how many there were: fewer only at the end of the output.
    std::size_t read(void* bytes, std::size_t count)
    {
        std::size_t done = 0;
        pollfd ready{output_, POLLIN, 0};
        while (program_->has_started() && done < count) {
            stop_if_interrupted();
            if (poll(&ready, 1, 100) <= 0)
                continue;
            const ssize_t got = ::read(output_, static_cast<char*>(bytes) + done, count - done);
            if (got == 0 || (got < 0 && errno != EINTR))
                break;
            done += got > 0 ? std::size_t(got) : 0;
        }
        return done;
    }

    FfmpegRun& program() { return *program_; }

private:
    int output_ = -1;
    std::unique_ptr<FfmpegRun> program_;
};

VideoReader::VideoReader(const std::string& path, double from) : path_(path), from_(from)
{
    if (!program_on_path("ffmpeg") || !program_on_path("ffprobe"))
        fail("to read a video, the programs ffmpeg and ffprobe are needed, which are not installed "
             "(Debian's package ffmpeg)");
    if (access(path.c_str(), R_OK) != 0)
        fail(std::string("cannot be read: ") + std::strerror(errno));
    probe();
    start();
}

VideoReader::~VideoReader() = default;

void VideoReader::fail(const std::string& what) const { throw InputError(path_ + ": " + what); }

/// Asks ffprobe for a field of the video's stream. Throws InputError if there is no video.
Json VideoReader::stream_fields(const Words& words) const
{
    Decoder probe(probe_words(path_, words));
    std::string text(1 << 16, ' ');
    text.resize(probe.read(text.data(), text.size()));
    const std::string trouble = probe.program().end();
    if (!trouble.empty())
        fail("it is not a video, or it is torn: " + fault_in(trouble, path_));
    const Json document = parse_json(text);
    if (!document.contains("streams") || document["streams"].empty())
        fail("it contains no pictures");
    return document["streams"][0];
}

void VideoReader::probe()
{
    const Json stream = stream_fields(
        {"-show_entries", "stream=avg_frame_rate,r_frame_rate,color_space,pix_fmt,width,height"});
    const double mean = rate_in(stream, "avg_frame_rate"), finest = rate_in(stream, "r_frame_rate");
    const double rate = mean > 0 ? mean : finest;
    if (rate > 0 && rate <= most_pictures_a_second)
        rate_ = rate;
    rate_varies_ = mean > 0 && finest > 0 && std::fabs(finest / mean - 1) > 0.05;
    guesses_hd_ = lacks_matrix(stream) && is_hd(stream);
}

long long VideoReader::stated_count() const
{
    const Json stream = stream_fields(
        {"-count_packets", "-show_entries", "stream=nb_read_packets"});
    return std::atoll(stream.value("nb_read_packets", "0").c_str());
}

/// The decoder writes each picture as a PPM, which states its size. Its filters number the
/// pictures anew, at an even rate: otherwise ffmpeg would repeat or leave out pictures.
std::vector<std::string> VideoReader::decoder_words() const
{
    Words words = {
        "ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-protocol_whitelist", "file"};
    if (from_ > 0)
        words.insert(words.end(), {"-ss", with_decimals(from_, 6)});
    const std::string matrix = guesses_hd_ ? "in_color_matrix=bt709:" : "";
    words.insert(words.end(), {"-i", "file:" + path_, "-map", "0:V:0", "-vf",
                               "settb=1/25,setpts=N,scale=" + matrix +
                                   "flags=bilinear+accurate_rnd+full_chroma_int,format=rgb24",
                               "-r", "25", "-c:v", "ppm", "-f", "image2pipe", "-"});
    return words;
}

void VideoReader::start()
{
    decoder_.reset();
    decoder_ = std::make_unique<Decoder>(decoder_words());
    has_begun_ = false;
    header_is_read_ = read_header(form_);
    if (header_is_read_)
        return;
    const std::string trouble = decoder_->program().end();
    if (trouble.empty())
        fail(from_ > 0 ? "it contains no picture at or after " + with_digits(from_, 6) + " s"
                       : "it contains no pictures");
    fail("ffmpeg cannot decode it: " + fault_in(trouble, path_));
}

void VideoReader::rewind()
{
    if (has_begun_)
        start();
}

/// Reads a picture's header. Returns false at the end of the output.
bool VideoReader::read_header(Image& form)
{
    std::string header;
    for (int lines = 0; lines < 3;) {
        char next = 0;
        if (header.size() > 40 || decoder_->read(&next, 1) != 1)
            return false;
        header += next;
        lines += next == '\n' ? 1 : 0;
    }
    int width = 0, height = 0;
    if (std::sscanf(header.c_str(), "P6 %d %d 255", &width, &height) != 2 || width < 1 ||
        height < 1)
        fail("ffmpeg writes pictures that are not PPM");
    form = form_of(8, width, height, 3, Encoding());
    return true;
}

bool VideoReader::read(Image& picture)
{
    Image form = form_;
    if (!header_is_read_ && !read_header(form)) {
        const std::string trouble = decoder_->program().end();
        if (!trouble.empty())
            fail("ffmpeg cannot decode it: " + fault_in(trouble, path_));
        return false;
    }
    if (!same_form(form, form_))
        fail("its pictures differ in size");
    if (!same_form(picture, form_))
        picture = blank_like(form_, form_.width, form_.height);
    auto& samples = std::get<std::vector<std::uint8_t>>(picture.samples);
    header_is_read_ = false;
    has_begun_ = true;
    if (decoder_->read(samples.data(), samples.size()) != samples.size())
        fail("ffmpeg ended within a picture");
    return true;
}

std::string VideoReader::fault() const
{
    return fault_in(decoder_->program().first_error(), path_);
}

Image picture_of_video(const std::string& path, double seconds)
{
    VideoReader video(path, seconds);
    Image picture;
    video.read(picture);
    return picture;
}

} // namespace integral
