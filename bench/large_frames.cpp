// SPDX-License-Identifier: AGPL-3.0-or-later
// Measures elapsed seconds, processor seconds and peak memory of `integral` commands for a large
// frame, and compares them with decoding the same file and with the picture's raw size.
//
//   large_frames [--size 12000x8400] [--integral PROGRAM] [--folder FOLDER] [--poster MM]
#include "bench/program.h"

#include "integral/base/parallel.h"
#include "integral/io/image_file.h"

#include <png.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace integral::bench {
namespace {

namespace options = boost::program_options;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Processor seconds of this program, which do not depend on other work on the machine.
double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

double seconds_of(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

/// Writes a frame of stripes behind lenses, with some noise. As in a rendered frame, the pixels
/// behind a lens differ, and the file is about a third of the size of the raw picture.
void make_frame(const std::string& path, int width, int height, double lens_pitch, int phase)
{
    FrameMetadata metadata;
    metadata.sheet = {Arrangement::square, lens_pitch, 3.08, 1.6, 0, {0, 0}};
    metadata.film = {width, height, {25.4 / 300, 25.4 / 300}};
    metadata.aperture.distance = 600;
    metadata.aperture.width = metadata.aperture.height = 200;
    const Image form = form_of(8, width, height, 3, Encoding());
    PictureWriter file = PictureWriter::of_frame(path, form, metadata);
    const int most = rows_of_a_band(form);
    for (int first = 0; first < height; first += most) {
        Image band = blank_like(form, width, std::min(most, height - first));
        for_each_row(band.height, 0, [&](int row) {
            const int y = first + row;
            std::uint32_t random = std::uint32_t(y) * 2654435761u + 1;
            unsigned char* to = row_bytes(band, row);
            for (int x = 0; x < width; ++x, to += 3) {
                random = random * 1664525u + 1013904223u;
                const int noise = int(random >> 30),
                          stripe = (x / 15 * 7 + x % 15 * 5 + y / 40 * 11 + phase) & 127;
                to[0] = static_cast<unsigned char>(40 + stripe + noise);
                to[1] = static_cast<unsigned char>(60 + y * 100 / height + noise);
                to[2] = static_cast<unsigned char>(30 + x * 150 / width);
            }
        });
        file.write(band);
    }
    file.finish();
}

/// Processor seconds in which libpng alone reads all rows.
double plain_decode(const std::string& path)
{
    const double start = processor_seconds();
    std::FILE* file = std::fopen(path.c_str(), "rb");
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    if (!file || !info || setjmp(png_jmpbuf(png)))
        throw std::runtime_error(path + ": libpng cannot read it");
    png_init_io(png, file);
    png_read_info(png, info);
    static std::vector<png_byte> row;
    row.resize(png_get_rowbytes(png, info));
    for (png_uint_32 y = png_get_image_height(png, info); y-- > 0;)
        png_read_row(png, row.data(), nullptr);
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
    return processor_seconds() - start;
}

struct Cost {
    double seconds, processor_seconds, bytes;
    int status;
};

/// Runs a program and measures it; its output goes to the file `said`.
Cost cost_of(const std::vector<std::string>& words, const std::string& said)
{
    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const auto start = Clock::now();
    const pid_t child = fork();
    if (child == 0) {
        const int out = open(said.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
        dup2(out, STDOUT_FILENO);
        dup2(out, STDERR_FILENO);
        execv(arguments[0], arguments.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    if (child < 0 || wait4(child, &status, 0, &usage) < 0)
        throw std::runtime_error("no process can be started");
    constexpr double kilobyte = 1024;
    return {seconds_since(start), seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
            double(usage.ru_maxrss) * kilobyte, WIFEXITED(status) ? WEXITSTATUS(status) : -1};
}

int measure(const options::variables_map& arguments)
{
    namespace fs = std::filesystem;
    int width = 0, height = 0;
    if (std::sscanf(arguments["size"].as<std::string>().c_str(), "%dx%d", &width, &height) != 2 ||
        width < 100 || height < 100)
        throw UsageError("--size WxH is expected, 100 pixels at least");
    const std::string program = arguments.count("integral")
                                    ? arguments["integral"].as<std::string>()
                                    : (own_folder().parent_path() / "bin" / "integral").string();
    const fs::path folder = arguments.count("folder")
                                ? fs::path(arguments["folder"].as<std::string>())
                                : own_folder() / "large-frames";
    fs::create_directories(folder);
    const auto in = [&](const char* name) { return (folder / name).string(); };
    const std::string frame = in("frame.png"), other = in("other.png"), between = in("between.png"),
                      said = in("said.txt");
    if (!fs::exists(frame)) { // kept between runs, to measure several programs on the same files
        make_frame(frame, width, height, 1.27, 0); // 15 pixels a lens
        make_frame(other, width, height, 1.27, 1);
        make_frame(between, width, height, 1.124, 0); // 13.28 pixels
    }
    fs::remove(said);
    const double raw = 3.0 * width * height, decode = plain_decode(frame);
    const std::string poster = arguments["poster"].as<std::string>();
    const std::pair<const char*, std::vector<std::string>> runs[] = {
        {"sheet", {"sheet", frame}},
        {"views, whole pixels", {"views", frame, "-o", in("views_qs15x15a1.33.png")}},
        {"views, interpolated", {"views", between, "-o", in("between_qs13x13a1.33.png")}},
        {"views, files", {"views", frame, "--files", "-o", in("view.png")}},
        {"frame, whole pixels",
         {"views", "--to-frame", in("views_qs15x15a1.33.png"), "-o", in("again.png")}},
        {"frame, interpolated",
         {"views", "--to-frame", in("between_qs13x13a1.33.png"), "-o", in("again.png")}},
        {"print, PNG", {"print", frame, "-o", in("page.png")}},
        {"print, TIFF, marks", {"print", frame, "-o", in("page.tiff"), "--marks", "all"}},
        {"print, PDF", {"print", frame, "-o", in("page.pdf")}},
        {"print, tiles", {"print", frame, "-o", in("tile.png"), "--paper", "400x400", "--tile"}},
        {"print, poster",
         {"print", frame, "-o", in("poster.tiff"), "--paper", poster + "x" + poster}},
        {"compare", {"compare", frame, other}},
        {"compare, picture", {"compare", frame, other, "-o", in("difference.png")}},
        {"replay",
         {"replay", frame, "--eye", "0,0,600", "--size", "800x560", "-o", in("eye.png")}}};
    std::printf(
        "%d x %d pixels, 8 bits: %.1f MB raw, %.1f MB as PNG, which libpng decodes in %.2f s\n",
        width, height, raw / 1e6, double(fs::file_size(frame)) / 1e6, decode);
    std::printf("%-22s %8s %10s %10s %8s %8s %6s\n", "command", "seconds", "processors",
                "to libpng", "MB", "to raw", "status");
    std::fflush(stdout);
    for (const auto& [name, words] : runs) {
        std::vector<std::string> all = {program};
        all.insert(all.end(), words.begin(), words.end());
        const Cost cost = cost_of(all, said);
        std::printf("%-22s %8.2f %10.2f %10.2f %8.1f %8.2f %6d\n", name, cost.seconds,
                    cost.processor_seconds, cost.processor_seconds / decode, cost.bytes / 1e6,
                    cost.bytes / raw, cost.status);
        std::fflush(stdout);
    }
    return 0;
}

int run(int count, char** words)
{
    options::options_description all("Options");
    all.add_options()("size", options::value<std::string>()->default_value("12000x8400"),
                      "of the frames, pixels")(
        "integral", options::value<std::string>(),
        "the program that is measured (default: this build's)")(
        "folder", options::value<std::string>(),
        "for frames, which are made once, and outputs (default: beside this program)")(
        "poster", options::value<std::string>()->default_value("5000"), "the poster's sides, mm");
    return measure(parsed(count, words, all));
}

} // namespace
} // namespace integral::bench

int main(int count, char** words)
{
    return integral::bench::status_of("large_frames",
                                      [&] { return integral::bench::run(count, words); });
}
