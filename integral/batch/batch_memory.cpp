// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/batch_memory.h"

#include "integral/base/file_bytes.h"
#include "integral/base/memory.h"
#include "integral/base/number_text.h"
#include "integral/batch/batch_steps.h"
#include "integral/batch/renderer_options.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace integral {
namespace {

constexpr double mebibyte = 1 << 20;

/// Memory of a program with the smallest picture, bytes: this program's own memory, which depends
/// on the system's libraries, plus a margin for other programs; at least 24 MiB.
double smallest_program()
{
    constexpr double usual = 24 * mebibyte, margin = 3 * mebibyte;
    static const double bytes = std::max(usual, resident_memory() + margin);
    return bytes;
}

std::string megabytes(double bytes)
{
    return with_decimals(std::ceil(bytes / mebibyte), 0) + " MB";
}

std::string in_small_letters(std::string text)
{
    for (char& c : text)
        c = char(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Whether these options may anti-alias a frame. An .ini file among them is not read; it counts as
/// turning anti-aliasing on.
bool may_antialias(const Names& words)
{
    bool may = false;
    for (const std::string& word : words)
        for (const RendererOption& option : renderer_options_in(word)) {
            const std::string name = in_small_letters(option.name);
            const std::string value = in_small_letters(option.value);
            const bool letters = option.kind == RendererOption::Kind::letters;
            if (option.kind == RendererOption::Kind::path)
                may = true;
            else if (letters && (name == "a" || name.rfind("a0", 0) == 0))
                may = option.on;
            else if (!letters && name == "antialias")
                may = value == "on" || value == "true" || value == "yes" || value == "1";
        }
    return may;
}

/// Upper bound, in pixels, for the picture sizes in all sections of the .ini files on a frame's
/// command line; 0 if these files give no size.
double pixels_in_settings(const BatchStep& step)
{
    double width = 0, height = 0;
    for (const std::string& word : step.words)
        for (const RendererOption& option : renderer_options_in(word)) {
            if (option.kind != RendererOption::Kind::path)
                continue;
            const std::string name = option.value.substr(0, option.value.find('['));
            std::ifstream settings(path_in(step.folder, name));
            for (std::string line; std::getline(settings, line);) {
                line.erase(std::remove(line.begin(), line.end(), ' '), line.end());
                const auto side = [&](const char* keyword, const char* letter) {
                    return std::atof(value_of_option({line}, keyword, letter).c_str());
                };
                width = std::max(width, side("width", "w"));
                height = std::max(height, side("height", "h"));
            }
        }
    return width * height;
}

/// Upper bound of the renderer's memory without the scene, bytes.
double renderer_bound(const BatchStep& step, double pixels)
{
    constexpr double kept_in_memory = 140 * mebibyte; // pixels beyond it go to a file
    double bytes = smallest_program() + std::min(24 * pixels, kept_in_memory);
    if (extension_of(step.output) == "exr")
        bytes += 9 * pixels;
    if (may_antialias(step.words)) {
        // The passes of +A use about 320 rows of a frame at a time, and more where its lenses are
        // higher than a block. A quilt's may use all rows.
        constexpr double most_rows = 1000;
        const bool may_use_all = step.size.width <= 0 ||
                                 !value_of_option(step.words, "integral_quilt", "").empty() ||
                                 !value_of_option(step.words, "render_block_size", "bs").empty();
        const double in_use = may_use_all ? pixels : std::min(pixels, most_rows * step.size.width);
        bytes += 26 * mebibyte + 160 * in_use;
    }
    if (!value_of_option(step.words, "integral_depth_image", "").empty())
        bytes += 12 * pixels;
    if (!value_of_option(step.words, "integral_error_image", "").empty())
        bytes += 18 * pixels;
    return bytes;
}

/// Memory of a command, bytes: per pixel of the frame, per pixel of the output picture, and fixed.
struct PerPixel {
    double frame = 0, output = 0;
    double fixed = 0;
};

PerPixel per_pixel(const BatchStep& step, bool deep)
{
    const std::string format = extension_of(step.output);
    const bool exr = format == "exr";
    switch (step.kind) {
    case StepKind::print: return deep ? PerPixel{24, 8} : PerPixel{12, 4};
    case StepKind::panel:
        return {deep ? 13.0 : 6.0, deep ? exr ? 32.0 : 20.0 : exr ? 26.0 : 9.0, 40 * mebibyte};
    default: break;
    }
    const double frame = format == "html" ? (deep ? 30 : 20) : deep ? 13 : 4;
    // OpenEXR holds some blocks of rows besides the picture; newer versions (Debian 13) hold more.
    return {frame, deep ? 20.0 : exr ? 16.0 : 6.0, exr ? 4 * mebibyte : 0};
}

/// Names the group of steps with similar use of memory: the frames of one scene, or the pictures
/// for one target.
std::string memory_group(const Manifest& manifest, const BatchStep& step)
{
    const int scene = manifest.jobs[std::size_t(step.job)].scene;
    return std::string(name_of(step.kind)) + " " +
           (step.kind == StepKind::frame ? manifest.scenes[std::size_t(scene)].name
                                         : step.target_name);
}

/// Figures from the header of a frame's file.
struct FrameHeader {
    bool deep;        ///< more than 8 bits a sample
    Vec2 pixel_pitch; ///< mm
    double bytes;     ///< size of the file
};

/// Throws InputError if the file is no integral frame.
FrameHeader header_of_frame(const std::string& path)
{
    const PictureHeader header = frame_header(path);
    std::error_code none;
    const double bytes = double(std::filesystem::file_size(path, none));
    return {header.bits > 8, metadata_in(header).film.pixel_pitch, bytes};
}

} // namespace

double MemoryForecast::bound(const BatchStep& step, const std::string& frame, double pixels)
{
    if (step.kind == StepKind::frame)
        return renderer_bound(
            step, step.size.width > 0 ? pixels : std::max(pixels, pixels_in_settings(step)));
    const auto known = bounds_.find(step.name);
    if (known != bounds_.end())
        return known->second;
    const FrameHeader header = header_of_frame(frame);
    const PerPixel each = per_pixel(step, header.deep);
    const double made = output_pixels_(manifest_, step, header.pixel_pitch);
    return bounds_[step.name] = smallest_program() + each.fixed + header.bytes +
                                each.frame * pixels + each.output * made;
}

double MemoryForecast::expected(const BatchStep& step, const std::string& frame, double pixels,
                                const StepRecord& before)
{
    const double most = bound(step, frame, pixels);
    const auto found = learnt_.find(memory_group(manifest_, step));
    if (found == learnt_.end())
        return std::max(most, before.memory);
    const Learnt& known = found->second;
    // For a larger picture, add the difference of the bounds. For a smaller picture, subtract the
    // difference, or scale by the ratio of the bounds if that leaves more.
    const double by_difference = known.bytes + most - known.bound;
    return most > known.bound ? by_difference
                              : std::max(by_difference, known.bytes * most / known.bound);
}

void MemoryForecast::learn(const BatchStep& step, const std::string& frame,
                           const StepRecord& record)
{
    const Learnt here{record.memory, bound(step, frame, record.pixels)};
    Learnt& known = learnt_[memory_group(manifest_, step)];
    if (here.bytes > known.bytes || (here.bytes == known.bytes && here.bound > known.bound))
        known = here;
}

std::string MemoryForecast::lack(double needed, const std::vector<MemoryUse>& running) const
{
    double available = limit_ > 0 ? limit_ : free_memory_of_machine();
    for (const MemoryUse& one : running)
        available -= limit_ > 0 ? std::max(one.expected, one.now)
                                : std::max(0.0, one.expected - one.now);
    if (needed <= available)
        return "";
    return "it needs about " + megabytes(needed) + " of memory, and " +
           megabytes(std::max(0.0, available)) + " are left";
}

} // namespace integral
