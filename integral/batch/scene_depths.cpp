// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/scene_depths.h"

#include "integral/batch/renderer.h"
#include "integral/batch/renderer_options.h"
#include "integral/io/image_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace integral {
namespace {

/// The draft number that leaves a few thousand pixels. Among three candidates, takes the one whose
/// neighbouring pixels differ most in position behind their lenses: with equal positions, all
/// pixels would show one view, or none.
int draft_of_few_pixels(const Film& film, double lens_pitch)
{
    constexpr double few = 8000;
    constexpr int most_draft = 100; // of Integral_Draft=
    const int least = int(std::ceil(std::sqrt(double(film.width) * film.height / few)));
    if (least <= 1)
        return 1;
    const auto from_same_place = [&](int draft) {
        const double lenses = draft * film.pixel_pitch.x / lens_pitch;
        return std::fabs(lenses - std::round(lenses));
    };
    int best = least;
    for (int draft = least + 1; draft <= least + 2; ++draft)
        if (from_same_place(draft) > from_same_place(best))
            best = draft;
    return std::min(best, most_draft);
}

/// Film of the print, from its draft. Its size is exact to half a draft pixel.
Film print_film(const FrameMetadata& metadata)
{
    Film film = metadata.film;
    const int draft = metadata.render ? metadata.render->draft : 1;
    film.width *= draft;
    film.height *= draft;
    film.pixel_pitch = (1.0 / draft) * film.pixel_pitch;
    return film;
}

InputError no_integral_camera(const std::string& scene)
{
    return InputError(scene + ": its camera is not integral; Integral_Camera=\"lens_sheet{...} "
                              "film{...}\" after it makes it so");
}

/// The metadata of a scene's frame. Renders only row 2, because +ER1 would mean all rows.
FrameMetadata frame_of(const std::string& scene, std::vector<std::string> words,
                       const ScratchFolder& scratch)
{
    const std::string row = scratch.path("row.png");
    for (const std::string& word : {std::string("+SR2 +ER2"), "+FN8 +O" + quoted(row)})
        words.push_back(word);
    render(scene, words, scratch);
    const FrameReader reader(row);
    if (!reader.frame().metadata || !reader.frame().metadata->render)
        throw no_integral_camera(scene);
    return *reader.frame().metadata;
}

} // namespace

SceneDepths depths_of_scene(const std::string& path, const std::vector<std::string>& options,
                            bool all_pixels, const Progress& progress)
{
    if (extension_of(path) == "exr") {
        SceneDepths read{read_depths(path), std::nullopt};
        if (!all_pixels)
            read.depths.metadata.film = print_film(read.depths.metadata);
        return read;
    }
    if (!names_scene(path))
        throw InputError(path + ": it is no scene (.pov, .ini) and no depth frame (.exr); a "
                                "micro-image frame holds no depths: "
                                "Integral_Depth_Image=FILE.exr writes them beside it");
    const ScratchFolder scratch;
    const std::string depths = scratch.path("depths.exr"), colours = scratch.path("colours.png");
    std::vector<std::string> words = scene_words(path, options);
    for (const char* word : {"-A", "-P", "+Q1", "Integral_Audit=off", "Integral_Draft=1"})
        words.push_back(word);
    std::optional<FrameMetadata> print;
    if (!all_pixels) {
        print = frame_of(path, words, scratch);
        words.push_back("Integral_Draft=" +
                        std::to_string(draft_of_few_pixels(print->film, print->sheet.pitch)));
    }
    words.push_back("+FN8 +O" + quoted(colours));
    words.push_back("Integral_Depth_Image=" + quoted(depths));
    render(path, words, scratch, progress);
    if (!std::filesystem::exists(depths))
        throw no_integral_camera(path);
    SceneDepths read{read_depths(depths), std::nullopt};
    if (print)
        read.depths.metadata = *print;
    else if (std::filesystem::exists(colours))
        read.colours = read_frame(colours);
    return read;
}

} // namespace integral
