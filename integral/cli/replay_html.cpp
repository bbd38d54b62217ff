// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/replay_html.h"

#include "integral/base/file_bytes.h"
#include "integral/lightfield/names.h"
#include "integral/replay/replay_page.h"

namespace integral {

bool html_is_wanted(const options::variables_map& arguments)
{
    if (!given(arguments, "html"))
        return false;
    const std::string output = text_of(arguments, "html");
    if (output.empty())
        throw UsageError("--html: the name of a file is expected");
    if (output == text_of(arguments, "output"))
        throw UsageError("--html and -o do not go to the same file");
    for (const char* other : {"stereo", "grid", "path"})
        if (given(arguments, other))
            throw UsageError(std::string("--html and --") + other +
                             " do not go together: the page shows one view");
    for (const char* other : {"anaglyph", "cross-eyed"})
        if (arguments[other].as<bool>())
            throw UsageError(std::string("--html and --") + other +
                             " do not go together: the page shows one view");
    if (text_of(arguments, "lens-model") == name_of(LensModel::full))
        throw UsageError(
            "--html and --lens-model full do not go together: the page has ideal lenses");
    return true;
}

void write_html(const options::variables_map& arguments, const Frame& frame, const View& start)
{
    const Subpixels& subpixels = frame.metadata->film.subpixels;
    if (subpixels != Subpixels::none && subpixels != Subpixels::rgb && subpixels != Subpixels::bgr)
        throw UsageError(std::string("--html shows panels of upright stripes, rgb or bgr, and this "
                                     "frame's subpixels are ") +
                         name_of(subpixels.order) + "; integral replay without --html shows it");
    write_file(text_of(arguments, "html"), replay_page(frame, start));
}

} // namespace integral
