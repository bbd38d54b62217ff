// SPDX-License-Identifier: AGPL-3.0-or-later
// Renders the depth frame: the distance from the sheet to the first surface seen in each pixel.
#ifndef POVRAY_BACKEND_INTEGRALDEPTH_H
#define POVRAY_BACKEND_INTEGRALDEPTH_H

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "backend/frame.h"
#include "backend/render/integraltask.h"
#include "integral/sampling/pixel_sampler.h"
#include "integral/sampling/quilt_sampler.h"

namespace pov
{

class Camera;
struct IntegralView;

/// The depth frame of a frame or a quilt: for each pixel, the depth of the first surface on the ray
/// from the pixel's centre through its lens's pole or, in a quilt, to its view's eye. Depths are in
/// mm from the sheet's plane, > 0 behind it; infinite if there is no surface; NaN if the pixel
/// images nothing.
class IntegralDepth
{
public:
    /// `distances`: the result of Probe_Integral_Depths, which the file contains, too.
    IntegralDepth(const IntegralView& view, const std::string& file,
                  const std::vector<double>& distances);

    /// Sets `row` to a row that no thread has taken yet; false when there is none left.
    bool Next_Row(int& row);

    /// Computes the depths of a row with `trace`.
    void Find_Row(int row, Trace& trace);

    /// Writes the file. If that fails, passes the reason to IntegralFrame::Add_Problem.
    void Write() const;

private:
    std::shared_ptr<const integral::IntegralCamera> optics;
    std::shared_ptr<const integral::PixelSampler> sampler;
    std::shared_ptr<const integral::QuiltSampler> quilt; ///< null: the picture is a frame
    std::string file;
    std::vector<float> distances;
    std::vector<float> depths;
    std::atomic<int> next{0};
};

/// One thread's share of the depth frame.
class IntegralDepthTask : public IntegralTask
{
public:
    explicit IntegralDepthTask(ViewData *view);
    virtual void Run();

private:
    std::shared_ptr<IntegralDepth> depth;
};

}

#endif
