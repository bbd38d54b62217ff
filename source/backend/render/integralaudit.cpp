// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralaudit.h"
#include "backend/render/integralsamplers.h"
#include "backend/lighting/integralambientnoise.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"
#include "base/integralframe.h"
#include "base/integralpicture.h"

#include <algorithm>
#include <cmath>
#include <utility>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

constexpr double usual_share = 0.002, picture_share = 0.05;

// Unless a share of the pixels is requested, an audit takes part_of_rays times the frame's rays. The
// lower limit of its pixels is least_pixels, and half of that if expected errors are known. The upper limit is
// the greater of most_pixels and usual_share of the lit pixels.
constexpr double part_of_rays = 0.05;
constexpr double least_pixels = 150, most_pixels = 1000;

// At most so many candidates are recorded for each of most_pixels; in large frames, at most
// fewest_each for each pixel of usual_share. The choice among them, by expected errors, then adds
// about a twentieth, or a fifth, to the variance of the estimate.
constexpr double candidates_each = 20, fewest_each = 5;

// This share of the mean expected error is added to each pixel's expected error, which is uncertain.
constexpr double expected_anywhere = 0.5;

// Number of samples of an audited pixel. The samples' own error must be small compared with the frame's
// error, which is large with one ray a pixel. An error picture, which shows single pixels, always gets
// usual_samples.
constexpr int samples_after_one_ray = 8, usual_samples = 32;

// Uncertainty of the noise of radiosity's points, as a share of its mean square: found by comparing frames of
// POV-Ray's scenes and of a test with converged ones.
constexpr double unsure_with_radiosity = 0.6;

std::uint64_t Key(int x, int y)
{
    return (std::uint64_t(std::uint32_t(y)) << 32) | std::uint32_t(x);
}

}

IntegralAudit::IntegralAudit(const IntegralView& view, std::uint64_t seed)
    : optics(view.optics),
      quilt(view.quilt),
      counts(view.counts),
      output(view.error.output),
      radiosity(view.error.radiosity),
      of_ambient_noise(view.error.by_halves),
      share(view.error.share),
      picture(view.error.picture),
      rows(view.rows),
      seed(seed),
      noted(view.optics->film.height)
{
    if (share == 0 && !picture.empty())
        share = picture_share;
}

void IntegralAudit::Note(const POVRect& rect, const std::vector<Colour>& colours,
                         const std::vector<float>& squared_errors)
{
    std::vector<Candidate> lit;
    std::size_t index = 0;
    for (int y = rect.top; y <= int(rect.bottom); y++)
        for (int x = rect.left; x <= int(rect.right); x++, index++)
            if (squared_errors[index] != unlit && Can_Be_Chosen(x, y))
                lit.push_back(Candidate_At(x, y, colours[index], squared_errors[index]));
    Note(lit, index);
}

void IntegralAudit::Note(const POVRect& rect, const std::vector<Colour>& colours)
{
    std::vector<Candidate> lit;
    std::size_t index = 0;
    for (int y = rect.top; y <= int(rect.bottom); y++)
        for (int x = rect.left; x <= int(rect.right); x++, index++)
            if (Can_Be_Chosen(x, y) && Is_Lit(x, y))
                lit.push_back(Candidate_At(x, y, colours[index], unknown));
    Note(lit, index);
}

void IntegralAudit::Note(const std::vector<Vector2d>& positions, const std::vector<Colour>& colours)
{
    std::vector<Candidate> lit;
    for (std::size_t index = 0; index < positions.size() && index < colours.size(); index++)
    {
        const int x = int(positions[index].x()), y = int(positions[index].y());
        if (Can_Be_Chosen(x, y) && Is_Lit(x, y))
            lit.push_back(Candidate_At(x, y, colours[index], unknown));
    }
    Note(lit, positions.size());
}

/// Whether a lens, or a view of a quilt, shows the pixel's middle.
bool IntegralAudit::Is_Lit(int x, int y) const
{
    const integral::Vec2 middle = integral::film_from_pixel(optics->film, {x + 0.5, y + 0.5});
    return quilt ? quilt->tile(x, y).has_value()
                 : optics->optics.map(middle, optics->mapping).ray.has_value();
}

/// Whether a pixel's hash and row permit its choice. Most pixels of a large frame are left out
/// here, before anything is computed for them.
bool IntegralAudit::Can_Be_Chosen(int x, int y) const
{
    return integral::random_bits(seed, Key(x, y)) <= threshold && rows.Have(y);
}

IntegralAudit::Candidate IntegralAudit::Candidate_At(int x, int y, const Colour& colour,
                                                     float expected) const
{
    return {x,
            y,
            {colour.red(), colour.green(), colour.blue()},
            integral::random_bits(seed, Key(x, y)),
            expected};
}

/// Records `lit`, the lit pixels of a number `of` rendered pixels.
void IntegralAudit::Note(const std::vector<Candidate>& lit, std::size_t of)
{
    std::lock_guard<std::mutex> lock(mutex);
    seen += of;
    for (const Candidate& pixel : lit)
        if (pixel.hash <= threshold) // which may have fallen
        {
            noted[pixel.y].push_back(pixel);
            noted_number++;
        }
    Thin_Out();
}

/// Drops recorded pixels that will not be audited. Retains at most fewest_each times the requested
/// share (or usual_share if greater) of the pixels rendered so far, or candidates_each *
/// most_pixels if that is more.
void IntegralAudit::Thin_Out()
{
    const double most = std::max(candidates_each * most_pixels,
                                 fewest_each * std::max(share, usual_share) * double(seen));
    while (double(noted_number) > most)
    {
        threshold = threshold / 2;
        noted_number = 0;
        for (std::vector<Candidate>& row : noted)
        {
            row.erase(std::remove_if(row.begin(), row.end(),
                                     [&](const Candidate& pixel)
                                     { return pixel.hash > threshold; }),
                      row.end());
            noted_number += row.size();
        }
    }
}

void IntegralAudit::Choose()
{
    chosen = true;
    begun = std::chrono::steady_clock::now();
    const double kept = (double(threshold) + 1) / std::pow(2.0, 64); // fraction of all hashes
    std::vector<Candidate> candidates = Take_Candidates();
    lit_pixels = std::round(candidates.size() / kept);
    double rays = 0;
    for (const ThreadCounters& tally : counts->tallies)
        rays += double(tally.rays.Get());
    samples = rays < 1.5 * lit_pixels && picture.empty() ? samples_after_one_ray : usual_samples;
    // Without anti-aliasing no expected errors are known. An error picture needs equal probabilities.
    const bool by_errors = share == 0 && picture.empty() &&
                           std::all_of(candidates.begin(), candidates.end(),
                                       [](const Candidate& pixel) {
                                           return pixel.expected >= 0 &&
                                                  std::isfinite(pixel.expected);
                                       });
    const double most = std::max(most_pixels, usual_share * lit_pixels),
                 usual = std::max(by_errors ? 0.5 * least_pixels : least_pixels,
                                  std::min(most, part_of_rays * rays / samples)),
                 requested = std::ceil(share > 0 ? share * lit_pixels : usual);
    const std::size_t number = std::min(candidates.size(), std::size_t(requested));
    if (by_errors && number < candidates.size())
        Take_By_Errors(std::move(candidates), number);
    else
        Take_Any(std::move(candidates), number);
    // Neighbouring pixels meet the same objects, which are then in the processor's caches.
    std::sort(pixels.begin(), pixels.end(),
              [](const Pixel& a, const Pixel& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
}

/// Returns the recorded pixels, row by row, and clears the record.
std::vector<IntegralAudit::Candidate> IntegralAudit::Take_Candidates()
{
    std::vector<Candidate> candidates;
    candidates.reserve(noted_number);
    for (std::vector<Candidate>& row : noted)
    {
        const auto before = [](const Candidate& a, const Candidate& b) { return a.x < b.x; };
        std::stable_sort(row.begin(), row.end(), before);
        for (std::size_t k = 0; k < row.size(); k++)
            if (k + 1 == row.size() || row[k + 1].x != row[k].x) // the last colour counts
                candidates.push_back(row[k]);
        row = {};
    }
    return candidates;
}

/// Sets `pixels` to `number` candidates, chosen with equal probability.
void IntegralAudit::Take_Any(std::vector<Candidate> candidates, std::size_t number)
{
    const auto end = candidates.begin() + number;
    std::nth_element(candidates.begin(), end, candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.hash < b.hash; });
    for (auto candidate = candidates.begin(); candidate != end; ++candidate)
        pixels.push_back({candidate->x, candidate->y, candidate->light, 1});
}

/// Sets `pixels` to about `number` candidates, chosen with probabilities that grow with the expected errors:
/// systematic sampling, in equal steps along the sum of the probabilities, from a random start.
void IntegralAudit::Take_By_Errors(std::vector<Candidate> candidates, std::size_t number)
{
    const auto mean = [&]
    {
        double sum = 0;
        for (const Candidate& candidate : candidates)
            sum += candidate.expected;
        return sum / double(candidates.size());
    };
    const double anywhere = expected_anywhere * mean();
    for (Candidate& candidate : candidates)
        candidate.expected += anywhere > 0 ? anywhere : 1;
    const double middle = mean(), step = middle * double(candidates.size()) / double(number);
    double next = step * std::ldexp(double(integral::random_bits(seed, ~std::uint64_t(0))), -64),
           sum = 0;
    for (const Candidate& candidate : candidates)
    {
        sum += candidate.expected;
        if (sum <= next)
            continue;
        // A candidate that spans several steps is weighted by their number.
        const double steps = std::floor((sum - next) / step) + 1;
        pixels.push_back(
            {candidate.x, candidate.y, candidate.light, steps * middle / candidate.expected});
        next += steps * step;
    }
    for (Pixel& pixel : pixels)
        pixel.weight *= double(pixels.size()) / double(number);
}

IntegralAudit::Pixel *IntegralAudit::Next()
{
    std::lock_guard<std::mutex> lock(mutex);
    if (!chosen)
        Choose();
    return taken < pixels.size() ? &pixels[taken++] : NULL;
}

std::optional<integral::ErrorEstimate> IntegralAudit::Result()
{
    std::lock_guard<std::mutex> lock(mutex);
    integral::ErrorSums sums;
    for (const Pixel& pixel : pixels)
        sums.add(pixel.weight * pixel.squared_error);
    auto error = integral::estimate(sums, integral::ErrorMethod::audit,
                                    radiosity ? unsure_with_radiosity : integral::bias_at_edges);
    if (!error)
    {
        Report_Picture(picture + ": there is no error to draw, as this run has rendered fewer than "
                                 "two lit pixels");
        return error;
    }
    error->lit_pixels = (long long)(lit_pixels);
    error->samples = samples;
    if (!picture.empty())
        Report_Picture(Write_Picture());
    error->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun)
                         .count();
    return error;
}

/// Reports why the requested error picture is missing; no effect if `error` is empty.
void IntegralAudit::Report_Picture(const std::string& error) const
{
    if (!picture.empty() && !error.empty())
        pov_base::IntegralFrame::Add_Problem("Integral_Error_Image", error);
}

/// Writes a picture of the local error: the frame is divided into squares of about 8 audited
/// pixels, and each is filled with the grey value of its RMS error. Returns why it could not be
/// written; empty if it was.
std::string IntegralAudit::Write_Picture() const
{
    const integral::Film& film = optics->film;
    const double area = double(film.width) * film.height;
    const int side = std::max(1, int(std::ceil(std::sqrt(8 * area / pixels.size()))));
    const int across = (film.width + side - 1) / side;
    std::vector<integral::ErrorSums> squares(std::size_t(across) *
                                             ((film.height + side - 1) / side));
    if (pixels.size() >= lit_pixels) // every pixel was audited: squares of one pixel
    {
        std::vector<double> errors(std::size_t(area), 0.0);
        for (const Pixel& pixel : pixels)
            errors[std::size_t(pixel.y) * film.width + pixel.x] = std::sqrt(
                std::max(0.0, pixel.squared_error));
        return pov_base::Write_Integral_Picture(picture, film.width, film.height, errors);
    }
    for (const Pixel& pixel : pixels)
        squares[std::size_t(pixel.y / side) * across + pixel.x / side].add(pixel.squared_error);
    std::vector<double> errors;
    errors.reserve(std::size_t(area));
    for (int y = 0; y < film.height; y++)
        for (int x = 0; x < film.width; x++)
        {
            const integral::ErrorSums& square = squares[std::size_t(y / side) * across + x / side];
            errors.push_back(
                square.pixels > 0 ? std::sqrt(std::max(0.0, square.sum / square.pixels)) : 0.0);
        }
    return pov_base::Write_Integral_Picture(picture, film.width, film.height, errors);
}

/// Records the colours of a view's finished pixels. Returns the audit that is to record them, too;
/// null if there is none.
static IntegralAudit *Note_Colours(const Camera& camera, const std::vector<Colour>& colours)
{
    if (camera.Integral_View)
    {
        IntegralCounts& counts = *camera.Integral_View->counts;
        std::lock_guard<std::mutex> lock(counts.mutex);
        counts.colours.Add(colours);
    }
    return camera.Integral_View && !camera.Integral_View->sampling
               ? camera.Integral_View->audit.get()
               : NULL;
}

void Note_Integral_Pixels(const Camera& camera, const POVRect& rect,
                          const std::vector<Colour>& pixels)
{
    if (IntegralAudit *audit = Note_Colours(camera, pixels))
        audit->Note(rect, pixels);
}

void Note_Integral_Pixels(const Camera& camera, const std::vector<Vector2d>& positions,
                          const std::vector<Colour>& colours)
{
    if (IntegralAudit *audit = Note_Colours(camera, colours))
        audit->Note(positions, colours);
}

IntegralAuditTask::IntegralAuditTask(ViewData *view)
    : IntegralTask(view, false), audit(view->GetCamera().Integral_View->audit)
{
}

void IntegralAuditTask::Run()
{
    radiosity.BeforeTile(0);
    trace.integralShading = NULL; // the error that shared shading causes counts too
    IntegralAmbientNoise noise;   // and so does the noise of radiosity's points
    radiosity.integralAmbient = &noise;
    std::vector<integral::PixelRay> rays;
    while (IntegralAudit::Pixel *pixel = audit->Next())
    {
        const bool brighter = integral::random_bits(0, Key(pixel->x, pixel->y)) & 1;
        integral::Light halves[2] = {};
        const int half = audit->Samples() / 2;
        for (int set = 0; set < 2; set++)
        {
            // The same samples, brighter and darker, differ only by the noise of radiosity's points.
            noise.Set_Direction(audit->Of_Ambient_Noise() ? set == 0 : brighter);
            for (int index = 0; index < half; index++)
            {
                const Colour colour = Trace_Integral_Reference(
                    trace.Integral(), pixel->x, pixel->y, audit->Of_Ambient_Noise() ? 0 : set, index,
                    rays);
                for (int channel = 0; channel < 3; channel++)
                    halves[set][channel] += double(colour[channel]) / half;
                Cooperate();
            }
        }
        pixel->squared_error = audit->Of_Ambient_Noise()
                                   ? integral::halves_error(audit->Output(), halves[0], halves[1],
                                                            1, 1)
                                   : integral::audited_error(audit->Output(), pixel->rendered,
                                                             halves[0], halves[1]);
    }
    radiosity.integralAmbient = NULL;
    radiosity.AfterTile();
}

}
