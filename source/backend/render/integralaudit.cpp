// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/render/integralaudit.h"
#include "backend/lighting/integralambientnoise.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/scene.h"
#include "backend/scene/view.h"
#include "base/integralpicture.h"

#include <algorithm>
#include <cmath>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

constexpr double usual_share = 0.002, picture_share = 0.05;

// Unless a share of the pixels is asked for, an audit takes this part of the frame's rays, but
// examines at least so many pixels, half of them if it knows where errors are expected, and no more
// than most_pixels or usual_share of them.
constexpr double part_of_rays = 0.05;
constexpr double least_pixels = 150, most_pixels = 1000;

// The part of the mean expected error that is added to that of each pixel, as it is not certain.
constexpr double expected_anywhere = 0.5;

// Samples of a pixel. What they err by themselves must be little beside the error to be found,
// which is great where there is one ray a pixel. A picture shows single pixels.
constexpr int samples_after_one_ray = 8, usual_samples = 32;

// The noise of radiosity's points is known so well, as a part of the mean square: found by
// comparing frames of POV-Ray's scenes and of a test with converged ones.
constexpr double unsure_with_radiosity = 0.6;

std::uint64_t Key(int x, int y)
{
    return (std::uint64_t(std::uint32_t(y)) << 32) | std::uint32_t(x);
}

}

IntegralAudit::IntegralAudit(const IntegralView& view, std::uint64_t seed)
    : optics(view.optics),
      counts(view.counts),
      output(view.error.output),
      radiosity(view.error.radiosity),
      of_ambient_noise(view.error.by_halves),
      share(view.error.share),
      picture(view.error.picture),
      rows(view.rows),
      seed(seed)
{
    if (share == 0 && !picture.empty())
        share = picture_share;
}

void IntegralAudit::Note(const POVRect& rect, const std::vector<Colour>& colours)
{
    std::lock_guard<std::mutex> lock(mutex);
    std::size_t index = 0;
    for (int y = rect.top; y <= int(rect.bottom); y++)
        for (int x = rect.left; x <= int(rect.right) && index < colours.size(); x++)
            Note_One(x, y, colours[index++]);
}

void IntegralAudit::Note(const std::vector<Vector2d>& positions, const std::vector<Colour>& colours)
{
    std::lock_guard<std::mutex> lock(mutex);
    for (std::size_t index = 0; index < positions.size() && index < colours.size(); index++)
        Note_One(int(positions[index].x()), int(positions[index].y()), colours[index]);
}

void IntegralAudit::Note_One(int x, int y, const Colour& colour)
{
    if (!rows.Have(y))
        return;
    seen++;
    const std::uint64_t key = Key(x, y), hash = integral::random_bits(seed, key);
    if (hash > threshold)
        return;
    if (!optics->optics
             .map(integral::film_from_pixel(optics->film, {x + 0.5, y + 0.5}), optics->mapping)
             .ray)
    {
        noted.erase(key);
        return;
    }
    Noted& pixel = noted[key];
    pixel.hash = hash;
    pixel.light = {colour.red(), colour.green(), colour.blue()};
    Thin_Out();
}

void IntegralAudit::Expect(const POVRect& rect, const std::vector<float>& squared_errors)
{
    std::lock_guard<std::mutex> lock(mutex);
    std::size_t index = 0;
    for (int y = rect.top; y <= int(rect.bottom); y++)
        for (int x = rect.left; x <= int(rect.right); x++)
        {
            const std::uint64_t key = Key(x, y), hash = integral::random_bits(seed, key);
            const float squared_error = squared_errors[index++];
            if (!rows.Have(y) || hash > threshold)
                continue;
            Noted& pixel = noted[key];
            pixel.hash = hash;
            pixel.expected = squared_error;
        }
}

/// Drops recorded pixels that will not be audited. Keeps twice the requested share of the pixels
/// seen so far, or the minimum number for a small frame if that is more.
void IntegralAudit::Thin_Out()
{
    const double most = std::max(200 * most_pixels,
                                 2 * std::max(share, usual_share) * double(seen));
    if (double(noted.size()) <= most)
        return;
    threshold /= 2;
    for (auto pixel = noted.begin(); pixel != noted.end();)
        pixel = pixel->second.hash > threshold ? noted.erase(pixel) : std::next(pixel);
}

void IntegralAudit::Choose()
{
    chosen = true;
    begun = std::chrono::steady_clock::now();
    const double kept = (double(threshold) + 1) / std::pow(2.0, 64); // fraction of all hashes
    lit_pixels = std::round(noted.size() / kept);
    double rays = 0;
    for (const IntegralTally& tally : counts->tallies)
        rays += double(tally.rays.Get());
    samples = rays < 1.5 * lit_pixels && picture.empty() ? samples_after_one_ray : usual_samples;
    // Of pixels that an earlier render finished (+C) nothing is known. A picture shows all places
    // alike.
    const bool by_errors = share == 0 && picture.empty() &&
                           std::all_of(noted.begin(), noted.end(),
                                       [](const auto& pixel)
                                       {
                                           const float expected = pixel.second.expected;
                                           return expected >= 0 && std::isfinite(expected);
                                       });
    const double most = std::max(most_pixels, usual_share * lit_pixels),
                 usual = std::max(by_errors ? 0.5 * least_pixels : least_pixels,
                                  std::min(most, part_of_rays * rays / samples)),
                 wanted = std::ceil(share > 0 ? share * lit_pixels : usual);
    const std::size_t number = std::min(noted.size(), std::size_t(wanted));
    if (by_errors && number < noted.size())
        Take_By_Errors(Candidates(), number);
    else
        Take_Any(Candidates(), number);
    // Pixels beside each other meet the same objects, which are then in the processor's caches.
    std::sort(pixels.begin(), pixels.end(),
              [](const Pixel& a, const Pixel& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
    noted.clear();
}

/// The recorded pixels, row by row.
std::vector<IntegralAudit::Candidate> IntegralAudit::Candidates() const
{
    std::vector<Candidate> candidates;
    for (const auto& [key, pixel] : noted)
        candidates.push_back(
            {int(std::uint32_t(key)), int(key >> 32), pixel.light, pixel.hash, pixel.expected});
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b)
              { return a.y != b.y ? a.y < b.y : a.x < b.x; });
    return candidates;
}

/// Sets `pixels` to that number of candidates, all of which have the same chance.
void IntegralAudit::Take_Any(std::vector<Candidate> candidates, std::size_t number)
{
    const auto end = candidates.begin() + number;
    std::nth_element(candidates.begin(), end, candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.hash < b.hash; });
    for (auto candidate = candidates.begin(); candidate != end; ++candidate)
        pixels.push_back({candidate->x, candidate->y, candidate->light, 1});
}

/// The same with chances that grow with the expected errors: systematic sampling, by equal steps
/// along the sum of the chances, from a random start.
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
        // One that is longer than a step stands for all the steps in it.
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
        return error;
    error->lit_pixels = (long long)(lit_pixels);
    error->samples = samples;
    picture_failed = !picture.empty() && !Write_Picture();
    error->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun)
                         .count();
    return error;
}

/// Writes a picture of the local error: the frame is divided into squares of about 8 audited
/// pixels, and each is filled with the grey value of its RMS error.
bool IntegralAudit::Write_Picture() const
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

static IntegralAudit *Audit_Of(const Camera& camera)
{
    return camera.Integral_View ? camera.Integral_View->audit.get() : NULL;
}

void Note_Integral_Pixels(const Camera& camera, const POVRect& rect,
                          const std::vector<Colour>& pixels)
{
    if (IntegralAudit *audit = Audit_Of(camera))
        audit->Note(rect, pixels);
}

void Note_Integral_Pixels(const Camera& camera, const std::vector<Vector2d>& positions,
                          const std::vector<Colour>& colours)
{
    if (IntegralAudit *audit = Audit_Of(camera))
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
    IntegralAmbientNoise noise;   // and that of radiosity's points
    radiosity.integralAmbientNoise = &noise;
    while (IntegralAudit::Pixel *pixel = audit->Next())
    {
        const bool brighter = integral::random_bits(0, Key(pixel->x, pixel->y)) & 1;
        integral::Light halves[2] = {};
        const int half = audit->Samples() / 2;
        for (int set = 0; set < 2; set++)
        {
            // The same samples, brighter and darker, differ by nothing but that noise.
            noise.Set_Direction(audit->Of_Ambient_Noise() ? set == 0 : brighter);
            for (int index = 0; index < half; index++)
            {
                Colour colour;
                trace.Integral().Audit(audit->Of_Ambient_Noise() ? 0 : set, index);
                trace(pixel->x, pixel->y, GetViewData()->GetWidth(), GetViewData()->GetHeight(),
                      colour);
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
    radiosity.integralAmbientNoise = NULL;
    radiosity.AfterTile();
}

}
