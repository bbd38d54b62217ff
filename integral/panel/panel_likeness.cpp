// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/panel/panel_likeness.h"

#include "integral/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

bool close(double a, double b)
{
    return std::fabs(a - b) <= 1e-9 * std::max({1.0, std::fabs(a), std::fabs(b)});
}

bool nearly_equal(double a, double b) { return a == b || std::fabs(a - b) <= 0.01 * b; }

} // namespace

FrameLikeness likeness(const FrameMetadata& frame, const FrameMetadata& panel)
{
    const LensSheet &a = frame.sheet, &b = panel.sheet;
    const Film &ours = frame.film, &theirs = panel.film;
    return {a.arrangement == b.arrangement && close(a.pitch, b.pitch) &&
                close(a.thickness, b.thickness) && close(a.ior, b.ior) && close(a.slant, b.slant) &&
                close(a.offset.x, b.offset.x) && close(a.offset.y, b.offset.y),
            ours.width == theirs.width && ours.height == theirs.height,
            close(ours.pixel_pitch.x, theirs.pixel_pitch.x) &&
                close(ours.pixel_pitch.y, theirs.pixel_pitch.y),
            same_layout(ours.subpixels, theirs.subpixels)};
}

std::optional<std::string> near_miss(const FrameMetadata& frame, const FrameMetadata& panel)
{
    const FrameLikeness like = likeness(frame, panel);
    if (!like.nearly())
        return std::nullopt;
    if (!like.size)
        return "it has " + size_text(frame.film.width, frame.film.height) +
               " pixels and the panel " + size_text(panel.film.width, panel.film.height);
    return like.lenses ? "its pixels' colours lie otherwise" : "its lenses are not the panel's";
}

std::optional<EyeGrid> eyes_before(const Film& panel, const FrameMetadata& frame, EyeGrid eyes)
{
    if (nearly_equal(frame.film.width * frame.film.pixel_pitch.x,
                     panel.width * panel.pixel_pitch.x) &&
        nearly_equal(frame.film.height * frame.film.pixel_pitch.y,
                     panel.height * panel.pixel_pitch.y))
        return eyes;
    return std::nullopt;
}

std::optional<std::string> other_zone(const Aperture& frame, const Panel& of)
{
    const Aperture& panel = of.aperture;
    const bool lie_across = lenses_lie_across(of.sheet);
    const auto extent = [&](const Aperture& a) { return lie_across ? a.height : a.width; };
    if (nearly_equal(frame.distance, panel.distance) && nearly_equal(extent(frame), extent(panel)))
        return std::nullopt;
    const auto mm = [](double length) { return with_decimals(length, 0) + " mm"; };
    return "it is rendered for eyes " + mm(frame.distance) + " away in a zone " +
           mm(extent(frame)) + (lie_across ? " high" : " wide") + "; the panel's are " +
           mm(panel.distance) + " away in " + mm(extent(panel)) +
           ", and near the ends see neighbouring views; viewing_distance " +
           with_decimals(panel.distance, 0) + " in the camera moves them there";
}

std::optional<std::string> missing_views(const LensSheet& frame, const LensSheet& panel)
{
    const bool round = panel.arrangement != Arrangement::lenticular;
    if (frame.arrangement != Arrangement::lenticular)
        return std::nullopt;
    const bool lie_across = lenses_lie_across(frame);
    if (!round && lie_across == lenses_lie_across(panel))
        return std::nullopt;
    return std::string("its lenses are lenticular and show nothing new from ") +
           (lie_across ? "the side" : "above") + ", as the panel's" +
           (round        ? " round ones do"
            : lie_across ? " upright ones do"
                         : ", which lie across, do");
}

} // namespace integral
