// SPDX-License-Identifier: AGPL-3.0-or-later
// Audits a rendered frame: renders a random subset of its lit pixels again with independent samples
// of pixel area and lens cell, and estimates from them the frame's error against the converged 4-D
// reference. With radiosity the noise of the points that it gathered counts, too
// (backend/lighting/integralambientnoise.h). If the error of the frame's samples is known from their
// halves, the audit looks for that noise alone.
#ifndef POVRAY_BACKEND_INTEGRALAUDIT_H
#define POVRAY_BACKEND_INTEGRALAUDIT_H

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "backend/frame.h"
#include "backend/render/integraltask.h"
#include "base/image/image.h"
#include "base/integraloptions.h"
#include "integral/lightfield/error_estimate.h"

namespace pov
{

class Camera;
struct IntegralCounts;
struct IntegralView;

/// The audit of one view. Which pixels it takes follows from random numbers that are hashes of
/// (seed, x, y), and from the errors that are expected of them, so that the choice does not depend
/// on the order in which threads work.
///
/// Where the errors to expect are known, pixels with greater ones are taken more often, and count by
/// the less. Half as many tell the frame's error as well as pixels that are chosen at random.
class IntegralAudit
{
public:
    IntegralAudit(const IntegralView& view, std::uint64_t seed);

    struct Pixel
    {
        int x, y;
        integral::Light rendered;
        double weight; ///< as how much its error counts in the frame's mean
        double squared_error = 0;
    };

    /// What stands for the expected squared error of a pixel of which nothing is known, and of one
    /// that is behind no lens.
    static constexpr float unknown = -1, unlit = -2;

    /// Records rendered pixels if they are in rows that count. If a pixel is recorded again, the
    /// last colour counts. `squared_errors`: those that are expected of the pixels, up to a factor.
    void Note(const POVRect& rect, const std::vector<Colour>& pixels,
              const std::vector<float>& squared_errors);
    /// The same if nothing is known of errors.
    void Note(const POVRect& rect, const std::vector<Colour>& pixels);
    void Note(const std::vector<Vector2d>& positions, const std::vector<Colour>& colours);

    /// The next pixel to audit; null when there is none left. The first call chooses the pixels.
    Pixel *Next();

    /// The number of samples of each audited pixel, in two independent halves. Known after the
    /// first call of Next.
    int Samples() const { return samples; }

    /// Whether only the noise of radiosity's points is looked for.
    bool Of_Ambient_Noise() const { return of_ambient_noise; }

    /// The curve from a rendered pixel's light to its values in the picture file.
    const integral::OutputCurve& Output() const { return output; }

    /// The frame's error, after all pixels have been audited; nothing if there were fewer than 2.
    /// Writes the error picture if one was requested; if that fails, IntegralFrame::Add_Problem has
    /// the reason.
    std::optional<integral::ErrorEstimate> Result();

private:
    /// A lit pixel.
    struct Candidate
    {
        int x, y;
        integral::Light light;
        std::uint64_t hash;
        double expected; ///< its squared error, up to a factor, or `unknown`
    };

    Candidate Candidate_At(int x, int y, const Colour& colour, float expected) const;
    void Note(const std::vector<Candidate>& lit, std::size_t of);
    void Thin_Out();
    void Choose();
    std::vector<Candidate> Take_Candidates();
    void Take_Any(std::vector<Candidate> candidates, std::size_t number);
    void Take_By_Errors(std::vector<Candidate> candidates, std::size_t number);
    std::string Write_Picture() const;
    void Report_Picture(const std::string& error) const;

    std::shared_ptr<const integral::IntegralCamera> optics;
    std::shared_ptr<const IntegralCounts> counts;
    integral::OutputCurve output;
    bool radiosity, of_ambient_noise;
    double share;
    std::string picture;
    pov_base::IntegralRows rows;
    std::uint64_t seed;

    std::mutex mutex;
    /// Of each row, the lit pixels whose hash is at most the threshold, in the order of recording.
    std::vector<std::vector<Candidate>> noted;
    std::size_t noted_number = 0;
    std::uint64_t threshold = ~std::uint64_t(0);
    long long seen = 0;    ///< number of pixels passed to Note
    double lit_pixels = 0; ///< approximate number of lit pixels in the frame
    bool chosen = false;
    int samples = 0;
    std::vector<Pixel> pixels; ///< to audit
    std::size_t taken = 0;
    std::chrono::steady_clock::time_point begun;
};

/// Records the pixels of a finished block of a view. No effect if the view has no audit, or if it is
/// anti-aliased: then the last pass records its blocks itself, with the errors to expect.
void Note_Integral_Pixels(const Camera& camera, const POVRect& rect,
                          const std::vector<Colour>& pixels);
void Note_Integral_Pixels(const Camera& camera, const std::vector<Vector2d>& positions,
                          const std::vector<Colour>& colours);

/// One thread's share of the audit.
class IntegralAuditTask : public IntegralTask
{
public:
    explicit IntegralAuditTask(ViewData *view);
    virtual void Run();

private:
    std::shared_ptr<IntegralAudit> audit;
};

}

#endif
