// SPDX-License-Identifier: AGPL-3.0-or-later
// integral combine: frames of one sheet and film, merged by their depth.
#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/cli/command.h"
#include "integral/cli/progress.h"
#include "integral/cli/thread_options.h"
#include "integral/cli/values.h"
#include "integral/io/image_file.h"
#include "integral/views/combine.h"

namespace integral {
namespace {

constexpr int most_frames = 256;

struct CombineOptions : CommonOptions {
    std::optional<std::string> output, depth, output_depth;
    std::optional<int> bits;
    bool json = false;
    ThreadOptions threads;
};

void declare(options::options_description& all, CombineOptions& o)
{
    add(all, "output,o", o.output, "FRAME", "the merged frame: .png, .exr or .tiff");
    add(all, "depth", o.depth, "FILE,...",
        "the depth frames (.exr), one for each frame (default: NAME-depth.exr beside NAME.png)");
    add(all, "output-depth", o.output_depth, "FILE.exr",
        "the merged frame's depth frame, so that more can be combined with it");
    add(all, "json", o.json, "print the figures as JSON");
    add(all, "bits", o.bits, "N",
        "8 or 16 for PNG and TIFF (default: the highest bit depth of the frames)");
    declare(all, o.threads);
}

/// The files of --depth; none if it is not given. Throws UsageError.
std::vector<std::string> depth_files(const CombineOptions& o)
{
    if (!o.depth)
        return {};
    const std::vector<std::string> files = parts_between_commas(*o.depth);
    if (files.size() != o.inputs.size())
        throw_usage("depth", *o.depth,
                    "a depth frame for each of the " + std::to_string(o.inputs.size()) +
                        " frames, separated by commas,");
    for (const std::string& file : files)
        if (file.empty())
            throw_usage("depth", *o.depth, "a file's name before and after each comma");
    return files;
}

std::string figures_text(const CombineOptions& o, const CombinedShares& shares)
{
    std::string text;
    for (std::size_t k = 0; k < shares.size(); ++k)
        text += o.inputs[k] + " is the nearest in " + with_decimals(100 * shares[k], 1) +
                "% of the pixels.\n";
    return text;
}

std::string figures_json(const CombineOptions& o, const CombinedShares& shares)
{
    Json json = {{"frames", Json::array()}};
    for (std::size_t k = 0; k < shares.size(); ++k)
        json["frames"].push_back({{"frame", o.inputs[k]}, {"nearest", shares[k]}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

int run(const CombineOptions& o)
{
    CombineRequest request;
    request.frames = o.inputs;
    request.depths = depth_files(o);
    request.output = needed_output(o.output, "FRAME");
    request.depth_output = o.output_depth.value_or("");
    request.bits = bits_given(o.bits);
    request.threads = o.threads.count();
    format_for(request.output);
    if (o.output_depth)
        check_depth_name("output-depth", *o.output_depth);
    check_outputs({o.output, o.output_depth});
    const CombinedShares shares = write_combined(request, progress_bar("combine"));
    print_figures(o.json ? figures_json(o, shares) : figures_text(o, shares),
                  request.output == "-");
    return exit_done;
}

} // namespace

const Command combine_command = {
    "combine",
    "frames of one sheet and film, merged by their depth: the nearer covers the farther",
    "FRAME FRAME... -o FRAME [--depth FILE,FILE...] [--output-depth FILE.exr]",
    R"(Merges frames that were made for one sheet, film and viewer, by their depth frames: at each
pixel the nearest frame covers those behind it (thesis 6.1), and lets them through where it
is transparent. Renders with Integral_Depth_Image, layers and merged frames can be combined
in any order; where frames show no surface, the first one's background counts.
)",
    2,
    most_frames,
    described<CombineOptions>,
    run_with<CombineOptions, run>};

} // namespace integral
