// SPDX-License-Identifier: AGPL-3.0-or-later
// Pictures that eyes see of frames, for Python.
#include "integral/base/interrupt.h"
#include "integral/frame/names.h"
#include "integral/python/arrays.h"
#include "integral/python/calls.h"
#include "integral/python/rooms.h"
#include "integral/replay/draft_frame.h"
#include "integral/replay/fit_part.h"
#include "integral/replay/replay_series.h"

#include <pybind11/stl.h>

namespace integral {
namespace {

constexpr int default_longer_side = 1000; // pixels, as of integral replay

/// The keyword arguments of integral.replay.
struct ReplayWords {
    std::optional<std::array<double, 3>> eye;
    std::optional<std::array<int, 2>> size;
    std::optional<std::array<double, 4>> part;
    std::optional<int> samples;
    Fit fit = Fit::contain;
    bool as_seen = false, raw_draft = false;
};

View view_of(const ReplayWords& words, View view, const FrameMetadata& metadata)
{
    if (view.samples == 0)
        view.samples = words.as_seen ? scattered_samples : default_samples(view);
    view.eye = centre_eye(metadata);
    if (words.eye)
        view.eye = {(*words.eye)[0], (*words.eye)[1], (*words.eye)[2]};
    if (words.part)
        view.part = {{(*words.part)[0], (*words.part)[1]}, (*words.part)[2], (*words.part)[3]};
    if (words.as_seen)
        set_as_seen(view, metadata);
    check_view(view, metadata);
    if (!words.size) {
        set_view_size(view, metadata.film, default_longer_side);
        return view;
    }
    view.width = (*words.size)[0];
    view.height = (*words.size)[1];
    fit_part_to_size(view, metadata, words.fit);
    return view;
}

/// Throws std::invalid_argument for values that no frame can be replayed with.
void check(const ReplayWords& words, const View& view)
{
    constexpr double farthest = 1e9, shortest = 1e-9, longest = 1e6; // mm
    if (words.eye) {
        for (const double place : *words.eye)
            check_number("eye", place, -farthest, farthest);
        if (!((*words.eye)[2] > 0))
            throw std::invalid_argument("the eye's distance must be greater than 0");
    }
    if (words.part)
        for (std::size_t k = 0; k < 4; ++k)
            check_number("part", (*words.part)[k], k < 2 ? -farthest : shortest, farthest);
    check_picture_size(words.size, largest_replay_side);
    check_number("samples", words.samples.value_or(1), 1, 64);
    check_number("pupil", view.pupil, 0, longest);
    check_number("focus", view.focus, -longest, longest);
    check_number("film_gap", view.film_gap, -longest, longest);
    check_number("lens_blur", view.blur, 0, longest);
}

/// The frame that is replayed: a draft is expanded to the print's pixels.
Frame replayed(Frame frame, bool raw_draft, int threads, const Progress& progress)
{
    if (raw_draft || !is_draft(frame))
        return frame;
    auto finer = with_final_pixels(frame, threads, progress);
    if (!finer)
        throw Interrupted();
    return std::move(*finer);
}

py::array replay_frame(const py::object& of_python, const ReplayWords& words, const View& lens,
                       int threads, const py::object& progress)
{
    check(words, lens);
    check_threads(threads);
    Frame frame = frame_with_geometry(of_python);
    return array_of(*result_of_long(progress, [&](const Progress& report) {
        frame = replayed(std::move(frame), words.raw_draft, threads, piece_of(report, 0, 2));
        const View view = view_of(words, lens, *frame.metadata);
        return replay(frame, view, threads, piece_of(report, 1, 2));
    }));
}

} // namespace

void declare_replay(py::module_& module)
{
    module.def("replay", [](const py::object& frame, std::optional<std::array<double, 3>> eye,
                            std::optional<std::array<int, 2>> size, const std::string& fit,
                            std::optional<std::array<double, 4>> part, std::optional<int> samples,
                            double pupil, double focus, double film_gap, double lens_blur,
                            const std::string& lens_model, bool as_seen, bool raw_draft,
                            int threads, const py::object& progress) {
        View view;
        const auto model = kind_named<LensModel>(lens_model);
        if (!model || *model == LensModel::hybrid)
            throw std::invalid_argument("lens_model " + lens_model +
                                        ": extended_pinhole, pinhole or full is expected");
        view.model = *model;
        view.samples = samples.value_or(0);
        view.pupil = pupil;
        view.focus = focus;
        view.film_gap = film_gap;
        view.blur = lens_blur;
        return replay_frame(frame, {eye, size, part, samples, fit_from(fit), as_seen, raw_draft},
                            view, threads, progress);
    });
}

} // namespace integral
