// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/scene_look.h"

#include "integral/batch/renderer.h"
#include "integral/batch/renderer_options.h"
#include "integral/io/image_file.h"
#include "integral/replay/draft_frame.h"
#include "integral/replay/replay.h"
#include "integral/sheet/sheet_report.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

/// The stripes of a pixel that a lens shows separately: those beside each other across the lenses.
int stripes_across(const FrameMetadata& frame)
{
    const Subpixels::Order order = frame.film.subpixels.order;
    const bool beside = order == Subpixels::rgb || order == Subpixels::bgr,
               below = order == Subpixels::vrgb || order == Subpixels::vbgr;
    return (lenses_lie_across(frame.sheet) ? below : beside) ? 3 : 1;
}

} // namespace

int draft_of_four_views(const FrameMetadata& print)
{
    constexpr double least = 4, most_draft = 100; // of Integral_Draft=
    const LensRowGeometry across = counted(print);
    return int(std::clamp(std::floor(stripes_across(print) * across.period / across.pixel / least),
                          1.0, most_draft));
}

Image look_of_scene(const std::string& scene, const std::vector<std::string>& options,
                    const FrameMetadata& print, const std::string& fit, int longest,
                    const Progress& progress)
{
    const ScratchFolder scratch;
    const std::string picture = scratch.path("look.png");
    std::vector<std::string> words = scene_words(scene, options);
    for (const char* word :
         {"-A", "-P", "Integral_Audit=off", "Integral_Depth_Image=", "Integral_Error_Image="})
        words.push_back(word);
    words.push_back("Integral_Draft=" + std::to_string(draft_of_four_views(print)));
    if (!fit.empty())
        words.push_back("Integral_Fit=" + fit);
    words.push_back("+FN8 +O" + quoted(picture));
    render(scene, words, scratch, progress);
    Frame frame = read_frame_with_metadata(picture);
    if (is_draft(frame))
        frame = *with_final_pixels(frame);
    View view;
    view.eye = centre_eye(*frame.metadata);
    set_view_size(view, frame.metadata->film, longest);
    return *replay(frame, view);
}

} // namespace integral
