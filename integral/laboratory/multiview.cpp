// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/laboratory/multiview.h"

#include "integral/base/interrupt.h"
#include "integral/compare/compare.h"
#include "integral/io/image_file.h"
#include "integral/laboratory/scene_pictures.h"
#include "integral/replay/arrange.h"
#include "integral/views/parallel_views.h"

#include <algorithm>
#include <stdexcept>

namespace integral {
namespace {

constexpr int eyes_a_view = 4, longer_side_seen = 360, shown_eyes = 5;
constexpr double looked_at = 0.8; // of the zone: nearer its ends parts of pictures are side lobes

void check_sheet(const FrameMetadata& geometry)
{
    if (geometry.sheet.arrangement != Arrangement::lenticular)
        throw std::invalid_argument("multi-view images are compared for lenticular sheets, whose "
                                    "views differ across alone; this sheet's lenses are round");
    if (lenses_lie_across(geometry.sheet))
        throw std::invalid_argument("multi-view images are compared for upright lenses, whose eyes "
                                    "are side by side, and these lie across; give lens_sheet a "
                                    "slant of 45 degrees at most");
    if (!std::isfinite(geometry.aperture.width))
        throw std::invalid_argument("no viewing zone, however wide, fills these lenses; "
                                    "capture_aperture in the camera would limit it");
}

double rmse(const Image& a, const Image& b)
{
    const Frame first{a, std::nullopt}, second{b, std::nullopt};
    ComparisonSettings settings;
    settings.similarity = false;
    Comparer comparer(first, second, settings);
    comparer.add(a, b);
    return comparer.result().rmse;
}

/// Computes the figures of pictures from neighbouring eyes. `truth`: the scene's own pictures.
void measure(SeenFrame& seen, const std::vector<Image>& pictures, const std::vector<Image>& truth)
{
    const double count = double(pictures.size());
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        const double error = rmse(pictures[k], truth[k]);
        seen.mean_error += error / count;
        seen.worst_error = std::max(seen.worst_error, error);
        if (k == 0)
            continue;
        const double jump = rmse(pictures[k - 1], pictures[k]);
        seen.mean_jump += jump / (count - 1);
        seen.greatest_jump = std::max(seen.greatest_jump, jump);
    }
}

/// The steps of compare_multiview.
class FramesComparison {
public:
    FramesComparison(const MultiviewRequest& request, const Progress& progress)
        : request_(request), progress_(progress), scene_(request.scene, request.words)
    {
    }

    MultiviewResult result()
    {
        const Frame integral = scene_.frame(file("integral.png"), piece_of(progress_, 0, 20));
        prepare(*integral.metadata);
        const auto truth = pictures_from(eyes_, {view_.part.width, view_.part.height}, view_.width,
                                         view_.height, Cameras::parallel);
        add("the scene itself", truth, truth, std::nullopt);
        add_frame("integral frame", integral, truth, std::nullopt);
        const auto parallel = views_by(Cameras::parallel);
        add_views("parallel cameras", "parallel.png", Interleaving::to_eyes, parallel, truth);
        add_views("converging cameras", "converging.png", Interleaving::to_eyes,
                  views_by(Cameras::converging), truth);
        add_views("parallel, to infinity", "infinity.png", Interleaving::to_infinity, parallel,
                  truth);
        find_moire();
        write_frame(file("seen.png"), {tiled(shown_, shown_columns(), 4), std::nullopt});
        return result_;
    }

private:
    std::string file(const std::string& name) const { return request_.folder + "/" + name; }

    void prepare(const FrameMetadata& geometry)
    {
        check_sheet(geometry);
        result_.geometry = geometry;
        result_.views = request_.views > 0 ? request_.views : natural_views(geometry).columns;
        if (result_.views < 2)
            throw std::invalid_argument("a lens has less than two pixels, so that there are no "
                                        "views; a finer film or --views would help");
        result_.eyes = request_.eyes > 0
                           ? request_.eyes
                           : int(std::lround(looked_at * eyes_a_view * result_.views));
        result_.eyes = std::min(result_.eyes, most_eyes);
        result_.figures = view_figures(geometry, result_.views);
        // Near the film's edge the eyes see past the film.
        const LensSheet& sheet = geometry.sheet;
        const Vec2 film = size_of(geometry.film);
        const double edge = sheet.pitch +
                            film.x / 2 * sheet.thickness / (sheet.ior * geometry.aperture.distance);
        view_.part = {{}, std::max(film.x - 2 * edge, sheet.pitch), film.y};
        set_view_size(view_, geometry.film, longer_side_seen);
        if (request_.width > 0) {
            view_.width = request_.width;
            view_.height = request_.height;
        }
        eyes_ = eyes(result_.eyes, looked_at);
        renders_ = 1 + result_.eyes + 2 * result_.views;
    }

    /// `count` eyes, each in the middle of an equal part of the zone's central share `part`.
    std::vector<Eye> eyes(int count, double part) const
    {
        const Eye middle = centre_eye(result_.geometry);
        const Vec2 zone = viewing_zone(result_.geometry, middle.distance);
        return eye_grid(middle, count, 1, {part * zone.x, 0});
    }

    std::vector<Image> pictures_from(const std::vector<Eye>& eyes, Vec2 window, int width,
                                     int height, Cameras cameras)
    {
        std::vector<Image> pictures;
        for (const Eye& eye : eyes) {
            stop_if_interrupted();
            pictures.push_back(
                scene_.picture(perspective_camera(result_.geometry, eye, window, cameras), width,
                               height, piece_of(progress_, ++rendered_, renders_)));
        }
        return pictures;
    }

    std::vector<Image> views_by(Cameras cameras)
    {
        const Film& film = result_.geometry.film;
        return pictures_from(eyes(result_.views, 1), size_of(film), film.width, film.height,
                             cameras);
    }

    int shown_columns() const { return std::min(shown_eyes, result_.eyes); }

    void add(const std::string& name, const std::vector<Image>& pictures,
             const std::vector<Image>& truth, std::optional<ViewSwitching> switching)
    {
        SeenFrame seen;
        seen.name = name;
        seen.switching = switching;
        measure(seen, pictures, truth);
        result_.seen.push_back(seen);
        const int columns = shown_columns();
        for (int k = 0; k < columns; ++k)
            shown_.push_back(pictures[std::size_t((2 * k + 1) * result_.eyes / (2 * columns))]);
    }

    void add_frame(const std::string& name, const Frame& frame, const std::vector<Image>& truth,
                   std::optional<ViewSwitching> switching)
    {
        Frame opaque{converted(frame.image, 8, truth[0].encoding, false), frame.metadata};
        opaque.metadata->encoding = opaque.image.encoding;
        auto pictures = replay_each(opaque, view_, eyes_, request_.threads);
        add(name, *pictures, truth, switching);
    }

    void add_views(const std::string& name, const std::string& path, Interleaving interleaving,
                   const std::vector<Image>& views, const std::vector<Image>& truth)
    {
        stop_if_interrupted();
        const Interleaver interleaver(result_.geometry, interleaving, request_.threads);
        const Frame frame = interleaver.frame(views);
        write_frame(file(path), frame);
        add_frame(
            name, frame, truth,
            view_switching(interleaver, result_.geometry, result_.views, eyes_, request_.threads));
    }

    void find_moire()
    {
        const Interleaver interleaver(result_.geometry, Interleaving::to_eyes, request_.threads);
        const Image moire = moire_picture(interleaver, result_.geometry, result_.views,
                                          request_.threads);
        write_frame(file("moire.png"), {moire, std::nullopt});
        result_.moire = stripes_period(moire, result_.geometry);
    }

    const MultiviewRequest& request_;
    const Progress& progress_;
    ScenePictures scene_;
    MultiviewResult result_;
    View view_;
    std::vector<Eye> eyes_;
    std::vector<Image> shown_; // the pictures of seen.png, row by row
    int rendered_ = 0, renders_ = 1;
};

} // namespace

MultiviewResult compare_multiview(const MultiviewRequest& request, const Progress& progress)
{
    return FramesComparison(request, progress).result();
}

} // namespace integral
