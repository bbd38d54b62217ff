// SPDX-License-Identifier: AGPL-3.0-or-later
// The audit of a rendered frame: a random part of its lit pixels is rendered anew, at independent
// samples of all that a pixel stands for, and tells how far the frame is from its converged 4-D
// reference.
#ifndef POVRAY_BACKEND_INTEGRALAUDIT_H
#define POVRAY_BACKEND_INTEGRALAUDIT_H

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <vector>

#include "backend/frame.h"
#include "backend/render/integraltask.h"
#include "base/image/image.h"
#include "base/integraloptions.h"
#include "integral/lightfield/error_estimate.h"

namespace pov
{

class Camera;
struct IntegralView;

/// The audit of one view. Its pixels are those of the smallest hashes of (seed, x, y): the same in
/// whatever order the threads work.
class IntegralAudit
{
public:
    IntegralAudit(const IntegralView& view, std::uint64_t seed);

    /// Independent samples of each audited pixel.
    static constexpr int samples = 16;

    struct Pixel
    {
        int x, y;
        integral::Light rendered;
        double squared_error = 0;
    };

    /// Notes rendered pixels, of the rows that count; the last to come of each is the final one.
    void Note(const POVRect& rect, const std::vector<Colour>& pixels);
    void Note(const std::vector<Vector2d>& positions, const std::vector<Colour>& colours);

    /// The next pixel to audit; nothing once all are taken. The first call chooses them.
    Pixel *Next();

    /// The values of a rendered pixel in the picture file are made of its light by this.
    const integral::OutputCurve& Output() const { return output; }

    /// The frame's error, once all have been audited; nothing where there was next to nothing to
    /// audit. Writes the error picture, if there is to be one.
    std::optional<integral::ErrorEstimate> Result();

    /// Whether the error picture was asked for and could not be written.
    bool Picture_Failed() const { return picture_failed; }

private:
    struct Noted
    {
        std::uint64_t hash;
        integral::Light light;
    };

    void Note_One(int x, int y, const Colour& colour);
    void Thin_Out();
    void Choose();
    bool Write_Picture() const;

    std::shared_ptr<const integral::IntegralCamera> optics;
    integral::OutputCurve output;
    double share;
    std::string picture;
    pov_base::IntegralRows rows;
    std::uint64_t seed;

    std::mutex mutex;
    std::unordered_map<std::uint64_t, Noted> noted; ///< lit pixels whose hash is below the
                                                    ///< threshold
    std::uint64_t threshold = ~std::uint64_t(0);
    long long seen = 0;    ///< pixels that have been noted or passed by
    double lit_pixels = 0; ///< about as many in the frame
    bool chosen = false;
    std::vector<Pixel> pixels; ///< to audit
    std::size_t taken = 0;
    bool picture_failed = false;
    std::chrono::steady_clock::time_point begun;
};

/// To be called with each finished block of a view. No effect without an audit.
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
