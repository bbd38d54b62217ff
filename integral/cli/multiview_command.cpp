// SPDX-License-Identifier: AGPL-3.0-or-later
// integral multiview: compares integral imaging with multi-view images of the same scene.
#include "integral/base/file_bytes.h"
#include "integral/base/folders.h"
#include "integral/base/json.h"
#include "integral/batch/renderer_options.h"
#include "integral/cli/command.h"
#include "integral/cli/progress.h"
#include "integral/cli/thread_options.h"
#include "integral/cli/values.h"
#include "integral/laboratory/multiview_text.h"

#include <iostream>

namespace integral {
namespace {

struct MultiviewOptions : CommonOptions {
    std::optional<std::string> output, size;
    std::optional<int> views, eyes;
    bool json = false;
    ThreadOptions threads;
};

void declare(options::options_description& all, MultiviewOptions& o)
{
    add(all, "output,o", o.output, "FOLDER",
        "for the frames and the pictures (made if it is missing)");
    add(all, "views", o.views, "N",
        "of the multi-view images (default as many as a lens has pixels)");
    add(all, "eyes", o.eyes, "N",
        "across the middle 80% of the viewing zone (default four to a view)");
    add(all, "size", o.size, "WxH", "pixels of what they see (default 360 on the longer side)");
    add(all, "json", o.json, "print the figures as JSON");
    declare(all, o.threads);
}

int whole(const char* option, const std::optional<int>& given, int most)
{
    return given ? in_range(option, *given, 2, most) : 0;
}

MultiviewRequest request_of(const MultiviewOptions& o)
{
    MultiviewRequest request;
    request.scene = o.inputs[0];
    if (extension_of(request.scene) != "pov")
        throw UsageError(request.scene + ": a scene (.pov) is expected; options of povray-integral "
                                         "follow it");
    request.words.assign(o.inputs.begin() + 1, o.inputs.end());
    if (!value_of_option(request.words, "input_file_name", "i").empty() ||
        !value_of_option(request.words, "output_file_name", "o").empty())
        throw UsageError("+I and +O are not for here: the scene stands first, -o names the folder");
    if (!o.output || *o.output == "-")
        throw UsageError("-o FOLDER is missing");
    request.folder = *o.output;
    request.views = whole("views", o.views, most_views);
    request.eyes = whole("eyes", o.eyes, most_eyes);
    read_size("size", o.size, 4096, request.width, request.height);
    request.threads = o.threads.count();
    if (request.threads > 0)
        request.words.push_back("+WT" + std::to_string(request.threads));
    return request;
}

int run(const MultiviewOptions& o)
{
    const MultiviewRequest request = request_of(o);
    read_file(request.scene); // a missing scene fails before a folder is made
    make_folder(request.folder);
    check_writable(request.folder + "/seen.png");
    const MultiviewResult result = usage_checked(request.scene + ": ", [&] {
        return compare_multiview(request, progress_bar("multiview"));
    });
    std::cout << (o.json ? multiview_json(result).dump(2) + "\n" : multiview_text(result));
    return exit_done;
}

} // namespace

const Command multiview_command = {
    "multiview",
    "a scene's frame beside multi-view images of it: crosstalk, flipping, depth, moire",
    "SCENE.pov [+W +H ...] -o FOLDER [--views N] [--eyes N] [--size WxH] [--json]",
    R"(Renders the scene's frame, and its pictures by perspective cameras side by side
that it interleaves for the same lenticular sheet (thesis 5.2): parallel cameras,
whose image plane is the sheet; cameras that converge on the sheet's middle; and
the parallel ones' pictures with the same views behind every lens, as for an eye
at infinity. Prints what closed forms say, and what eyes across the viewing zone
see of each beside the scene's own perspective picture.

FOLDER gets the frames integral.png, parallel.png, converging.png, infinity.png;
seen.png, rows of what five eyes see of the scene itself and of these, in this
order; and moire.png, a flat field that even views show white and odd ones black,
from the border of two views. Words of povray-integral that follow the scene hold
for all pictures; the scene's camera, or Integral_Camera=, has to be integral.
)",
    1,
    1000,
    described<MultiviewOptions>,
    run_with<MultiviewOptions, run>,
    true};

} // namespace integral
