// SPDX-License-Identifier: AGPL-3.0-or-later
// Judges frames as they are seen, by an eye that moves past the sheet. For each frame it prints
// three RMS errors in comparison with a converged frame: of the frame's lit pixels, of the views
// through a pupil, and of the changes from one view to the next. Errors that stand still in the
// frame but move before the eye (steps on surfaces, crawling outlines) show in the last figure.
#include "bench/program.h"
#include "bench/views.h"

#include "integral/io/image_file.h"
#include "integral/replay/arrange.h"

#include <cmath>
#include <cstdio>

namespace {

using namespace integral;
using namespace integral::bench;

constexpr int eyes = 25;                  // along the way
constexpr double way = 0.8;               // part of the aperture's width
constexpr double pupil_ratio = 4 / 300.0; // diameter of the pupil to the eye's distance
constexpr int view_width = 150;

std::vector<Frame> views_of(const Frame& frame)
{
    std::vector<Frame> views;
    View view;
    const Film& film = frame.metadata->film;
    view.width = view_width;
    view.height = int(std::lround(view_width * film.height * film.pixel_pitch.y /
                                  (film.width * film.pixel_pitch.x)));
    view.samples = 6;
    for (int k = 0; k < eyes; ++k) {
        view.eye = centre_eye(*frame.metadata);
        view.pupil = pupil_ratio * view.eye.distance;
        view.eye.x += (double(k) / (eyes - 1) - 0.5) * way * frame.metadata->aperture.width;
        views.push_back({*replay(frame, view, 1), {}});
    }
    return views;
}

/// Root mean square of difference(view, x, y), which returns three colour differences, over all
/// pixels of the views. `form` has a view's size.
template <class Difference> double rms(int views, const Image& form, Difference difference)
{
    double sum = 0;
    for (int k = 0; k < views; ++k)
        for (int y = 0; y < form.height; ++y)
            for (int x = 0; x < form.width; ++x)
                for (const double part : difference(k, x, y))
                    sum += part * part;
    return std::sqrt(sum / (3.0 * views * form.width * form.height));
}

std::array<double, 3> less(const Frame& a, const Frame& b, int x, int y)
{
    const Colour p = stored_pixel(a.image, x, y), q = stored_pixel(b.image, x, y);
    return {double(p.r) - q.r, double(p.g) - q.g, double(p.b) - q.b};
}

int run(const std::vector<std::string>& files)
{
    if (files.size() < 2)
        throw UsageError("moving_eye REFERENCE FRAME...: a converged frame and others of the same "
                         "scene are expected");
    const Frame reference = read_frame_with_metadata(files[0]);
    if (!reference.metadata)
        throw UsageError(files[0] + ": has no geometry; render it with povray-integral");
    const std::vector<Frame> requested = views_of(reference);
    const Image& form = requested[0].image;
    const auto change = [&](const std::vector<Frame>& views, int k, int x, int y) {
        return less(views[k + 1], views[k], x, y);
    };
    const double moves = rms(eyes - 1, form,
                             [&](int k, int x, int y) { return change(requested, k, x, y); });
    std::printf("| frame | error of the frame | of the views | of the change from view to view, in "
                "terms of the change (%.4f) |\n|---|---|---|---|\n",
                moves);
    for (std::size_t file = 1; file < files.size(); ++file) {
        const Frame frame = read_frame_with_metadata(files[file]);
        if (!same_form(frame.image, reference.image) || !frame.metadata)
            throw UsageError(files[file] + ": is no frame of the reference's size and form");
        const std::vector<Frame> seen = views_of(frame);
        const double views = rms(
            eyes, form, [&](int k, int x, int y) { return less(seen[k], requested[k], x, y); });
        const double changes = rms(eyes - 1, form, [&](int k, int x, int y) {
            auto difference = change(seen, k, x, y);
            const auto right = change(requested, k, x, y);
            for (int c = 0; c < 3; ++c)
                difference[c] -= right[c];
            return difference;
        });
        std::printf("| %s | %.4f | %.4f | %.3f |\n",
                    std::filesystem::path(files[file]).stem().c_str(), lit_rmse(frame, reference),
                    views, changes / moves);
    }
    return 0;
}

} // namespace

int main(int count, char** words)
{
    return status_of("moving_eye",
                     [&] { return run(std::vector<std::string>(words + 1, words + count)); });
}
