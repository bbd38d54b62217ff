// SPDX-License-Identifier: AGPL-3.0-or-later
// Forecasts how much memory a batch's steps will take, so that those that run at the same time fit
// into the machine's.
#ifndef INTEGRAL_BATCH_BATCH_MEMORY_H
#define INTEGRAL_BATCH_BATCH_MEMORY_H

#include "integral/batch/plan.h"
#include "integral/batch/step_record.h"
#include "integral/optics/vec.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace integral {

/// How many pixels the picture has that a step makes of a frame whose pixels have this pitch (mm):
/// a printed page, a view or a sheet of views, a panel's image. The caller provides it, because
/// only the commands know their options.
using OutputPixels = std::function<double(const Manifest& manifest, const BatchStep& step,
                                          Vec2 pixel_pitch)>;

/// The memory of a program that runs, bytes.
struct MemoryUse {
    double expected = 0, now = 0;
};

/// The memory that steps will need. Figures that were measured for every command and format bound
/// it from above by the sizes of pictures. They leave out what a scene itself takes, which is
/// learnt from those of its frames that have ended.
class MemoryForecast {
public:
    /// `limit`: bytes that all together may take; 0: what the machine has free.
    MemoryForecast(const Manifest& manifest, double limit, OutputPixels output_pixels)
        : manifest_(manifest), limit_(limit), output_pixels_(std::move(output_pixels))
    {
    }

    /// Bytes that a step will need. `frame` is the path of the frame that it reads, "" if none;
    /// `pixels` are those of the frame that it reads or makes; `before` is the record of its last
    /// run. Throws InputError if the frame cannot be read.
    double expected(const BatchStep& step, const std::string& frame, double pixels,
                    const StepRecord& before);
    /// Takes the memory that a step has used, as its record says, for the forecast of others.
    void learn(const BatchStep& step, const std::string& frame, const StepRecord& record);

    /// Empty if `needed` bytes are free beside the programs that run; else the beginning of a
    /// sentence: how much is needed, and how much is left.
    std::string lack(double needed, const std::vector<MemoryUse>& running) const;

private:
    double bound(const BatchStep& step, const std::string& frame, double pixels);

    /// What was learnt: the bytes that a step took, and its bound.
    struct Learnt {
        double bytes = 0, bound = 0;
    };

    const Manifest& manifest_;
    double limit_;
    OutputPixels output_pixels_;
    std::map<std::string, double> bounds_; ///< by a step's name, of steps that read a frame
    std::map<std::string, Learnt> learnt_; ///< by memory_group()
};

} // namespace integral

#endif
