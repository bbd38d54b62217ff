// SPDX-License-Identifier: AGPL-3.0-or-later
// The depth frame: how far from the sheet the first surface is that the viewer sees in each pixel.
#ifndef POVRAY_BACKEND_INTEGRALDEPTH_H
#define POVRAY_BACKEND_INTEGRALDEPTH_H

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "backend/frame.h"
#include "backend/render/integraltask.h"
#include "integral/lightfield/pixel_sampler.h"

namespace pov
{

class Camera;
struct IntegralView;

/// The depth frame of one view: of each pixel's centre, along the ray through its lens's pole. mm
/// from the sheet's plane, greater than 0 behind it; infinite where there is no surface; NaN where
/// the pixel images nothing.
class IntegralDepth
{
public:
    IntegralDepth(const IntegralView& view, const std::string& file);

    /// A row that no thread has taken yet; false once there is none.
    bool Next_Row(int& row);

    /// Works out a row's depths by `trace`.
    void Find_Row(int row, Trace& trace);

    /// Writes the file; false if that is not possible.
    bool Write() const;

    const std::string& File() const { return file; }

private:
    std::shared_ptr<const integral::IntegralCamera> optics;
    std::shared_ptr<const integral::PixelSampler> sampler;
    std::string file;
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
