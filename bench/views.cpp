// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/views.h"

#include "bench/renderer.h"
#include "bench/pictures.h"

#include "integral/compare/compare.h"
#include "integral/io/image_file.h"
#include "integral/optics/lens_mapping.h"
#include "integral/replay/arrange.h"

#include <algorithm>
#include <cmath>

namespace integral::bench {

bool shows_a_row(const Frame& frame)
{
    return frame.metadata->sheet.arrangement == Arrangement::lenticular;
}

std::vector<EyePosition> eyes_of(const Frame& frame, int across)
{
    const Aperture& aperture = frame.metadata->aperture;
    const bool row = shows_a_row(frame);
    std::vector<EyePosition> eyes;
    for (const Eye& eye : eye_grid({}, row ? across * across : across, row ? 1 : across,
                                   {zone * aperture.width, row ? 0 : zone * aperture.height}))
        eyes.push_back({eye.x, eye.y});
    return eyes;
}

Frame inner_part(const Image& image, const ViewForm& form)
{
    return {part_of(image, form.margin, form.margin, image.width - 2 * form.margin,
                    image.height - 2 * form.margin),
            {}};
}

Frame view_of(const Frame& frame, const EyePosition& eye, const ViewForm& form)
{
    View view;
    view.eye = centre_eye(*frame.metadata);
    view.eye.x += eye.x;
    view.eye.y += eye.y;
    const Film& film = frame.metadata->film;
    const double pixel = form.film_pixels * mm_per_inch / dots_per_inch;
    view.width = int(std::lround(film.width * film.pixel_pitch.x / pixel));
    view.height = int(std::lround(film.height * film.pixel_pitch.y / pixel));
    view.samples = form.samples;
    return inner_part(*replay(frame, view, 1), form);
}

Frame perspective_of(const Renderer& renderer, const std::string& scene, const std::string& name,
                     const std::optional<EyePosition>& eye, std::vector<std::string> options,
                     int times, const ViewForm& form)
{
    if (eye)
        options.insert(options.end(), {"Declare=Eye_X=" + std::to_string(eye->x),
                                       "Declare=Eye_Y=" + std::to_string(eye->y)});
    renderer.render(scene, name, std::nullopt, options, times);
    return inner_part(shrunk(read_frame(renderer.picture(name)).image, times * form.film_pixels),
                      form);
}

ViewFigures view_figures(const Frame& view, const Frame& requested)
{
    const Comparison comparison = compare(view, requested);
    return {comparison.psnr, comparison.ssim};
}

ViewFigures mean(const std::vector<ViewFigures>& views)
{
    ViewFigures sum;
    for (const ViewFigures& view : views) {
        sum.psnr += view.psnr / double(views.size());
        sum.ssim += view.ssim / double(views.size());
    }
    return sum;
}

ViewFigures least(const std::vector<ViewFigures>& views)
{
    ViewFigures result = views.front();
    for (const ViewFigures& view : views)
        result = {std::min(result.psnr, view.psnr), std::min(result.ssim, view.ssim)};
    return result;
}

ViewFigures greatest(const std::vector<ViewFigures>& views)
{
    ViewFigures result = views.front();
    for (const ViewFigures& view : views)
        result = {std::max(result.psnr, view.psnr), std::max(result.ssim, view.ssim)};
    return result;
}

double lit_rmse(const Frame& frame, const Frame& reference)
{
    return std::sqrt(lit_squared_error(frame, reference, reference));
}

double lit_squared_error(const Frame& frame, const Frame& a, const Frame& b)
{
    const FrameMetadata& metadata = *frame.metadata;
    const SheetOptics optics(metadata.sheet, metadata.aperture, metadata.render->model);
    double sum = 0;
    long long lit = 0;
    for (int y = 0; y < frame.image.height; ++y)
        for (int x = 0; x < frame.image.width; ++x) {
            if (!optics
                     .map(film_from_pixel(metadata.film, {x + 0.5, y + 0.5}),
                          metadata.render->mapping)
                     .ray)
                continue;
            const Colour own = stored_pixel(frame.image, x, y), first = stored_pixel(a.image, x, y),
                         second = stored_pixel(b.image, x, y);
            sum += (own.r - first.r) * (own.r - second.r) + (own.g - first.g) * (own.g - second.g) +
                   (own.b - first.b) * (own.b - second.b);
            ++lit;
        }
    return lit > 0 ? sum / (3 * lit) : 0;
}

} // namespace integral::bench
