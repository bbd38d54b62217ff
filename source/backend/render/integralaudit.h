// SPDX-License-Identifier: AGPL-3.0-or-later
// Audits a rendered frame: renders a random subset of its lit pixels again with independent samples
// of pixel area and lens cell, and estimates from them the frame's error against the converged 4-D
// reference. With radiosity the noise of the points that it gathered counts, too
// (backend/lighting/integralambientnoise.h). If the error of the frame's samples is known from their two
// halves, the audit estimates only the noise of radiosity's points.
#ifndef POVRAY_BACKEND_INTEGRALAUDIT_H
#define POVRAY_BACKEND_INTEGRALAUDIT_H

#include <atomic>
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
#include "integral/frame/error_estimate.h"
#include "integral/sampling/quilt_sampler.h"

namespace pov
{

class Camera;
struct IntegralCounts;
struct IntegralView;

/// The audit of one view. It chooses pixels by hashes of (seed, x, y), which serve as random
/// numbers, and by their expected errors, so that the choice does not depend on the order in which
/// threads work.
///
/// If expected errors are known, pixels with greater expected errors are chosen more often, and weigh less.
/// Half as many pixels then give the frame's error as accurately as pixels chosen with equal probabilities.
class IntegralAudit
{
public:
    IntegralAudit(const IntegralView& view, std::uint64_t seed);

    struct Pixel
    {
        int x, y;
        integral::Light rendered;
        double weight; ///< weight of its error in the frame's mean
        double squared_error = 0;
    };

    /// Values in place of an expected squared error: of a pixel whose error is not known, and of a
    /// pixel behind no lens.
    static constexpr float unknown = -1, unlit = -2;

    /// Records rendered pixels if they are in rows that count (Integral_Rows=). If a pixel is recorded again,
    /// its last colour counts. `squared_errors`: the pixels' expected ones, up to a factor.
    void Note(const POVRect& rect, const std::vector<Colour>& pixels,
              const std::vector<float>& squared_errors);
    /// Does the same without expected errors.
    void Note(const POVRect& rect, const std::vector<Colour>& pixels);
    void Note(const std::vector<Vector2d>& positions, const std::vector<Colour>& colours);

    /// The next pixel to audit; null when there is none left. The first call chooses the pixels.
    Pixel *Next();

    /// The number of samples of each audited pixel, in two independent halves. Known after the
    /// first call of Next.
    int Samples() const { return samples; }

    /// Whether only the noise of radiosity's points is estimated.
    bool Of_Ambient_Noise() const { return of_ambient_noise; }

    /// The curve from a rendered pixel's light to its values in the picture file.
    const integral::OutputCurve& Output() const { return output; }

    /// The frame's error, after all pixels have been audited; nothing if there were fewer than 2.
    /// Writes the error picture if one was requested; if that fails, passes the reason to
    /// IntegralFrame::Add_Problem.
    std::optional<integral::ErrorEstimate> Result();

private:
    /// A lit pixel.
    struct Candidate
    {
        int x, y;
        integral::Light light;
        std::uint64_t hash;
        double expected; ///< its expected squared error, up to a factor, or `unknown`
    };

    bool Is_Lit(int x, int y) const;
    bool Can_Be_Chosen(int x, int y) const;
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
    std::shared_ptr<const integral::QuiltSampler> quilt; ///< null: the picture is a frame
    std::shared_ptr<const IntegralCounts> counts;
    integral::OutputCurve output;
    bool radiosity, of_ambient_noise;
    double share;
    std::string picture;
    pov_base::IntegralRows rows;
    std::uint64_t seed;

    std::mutex mutex;
    /// Lit pixels of each row whose hash is at most the threshold, in the order of recording.
    std::vector<std::vector<Candidate>> noted;
    std::size_t noted_number = 0;
    std::atomic<std::uint64_t> threshold{~std::uint64_t(0)};
    long long seen = 0;    ///< number of pixels passed to Note
    double lit_pixels = 0; ///< approximate number of lit pixels in the frame
    bool chosen = false;
    int samples = 0;
    std::vector<Pixel> pixels; ///< to audit
    std::size_t taken = 0;
    std::chrono::steady_clock::time_point begun;
};

/// Records the colours of a view's finished block for the statistics, and for the view's audit if
/// it has one. Not for the audit of an anti-aliased view: there the last pass records its blocks
/// itself, with their expected errors.
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
