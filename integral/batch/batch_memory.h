// SPDX-License-Identifier: AGPL-3.0-or-later
// Forecasts the memory that a batch's steps will take, so that concurrent steps fit into the
// machine's memory.
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

/// Counts the pixels of the picture that a step makes from a frame with this pixel pitch (mm): a
/// printed page, a view or a sheet of views, a panel's image. The caller provides it, because only
/// the commands know their options.
using OutputPixels = std::function<double(const Manifest& manifest, const BatchStep& step,
                                          Vec2 pixel_pitch)>;

/// Memory of a running program, bytes.
struct MemoryUse {
    double expected = 0, now = 0;
};

/// Forecasts the memory of steps. For every command and format, computes an upper bound from
/// picture sizes and measured figures. The bounds leave out the scene's own memory, which is learnt
/// from the scene's finished frames.
class MemoryForecast {
public:
    /// `limit`: bytes for all programs together; 0: the machine's free memory.
    MemoryForecast(const Manifest& manifest, double limit, OutputPixels output_pixels)
        : manifest_(manifest), limit_(limit), output_pixels_(std::move(output_pixels))
    {
    }

    /// Bytes that a step will need. `frame` is the path of the step's input frame, "" if none;
    /// `pixels` is the number of pixels of the step's input or output frame; `before` is the record
    /// of the step's last run. Throws InputError if the frame cannot be read.
    double expected(const BatchStep& step, const std::string& frame, double pixels,
                    const StepRecord& before);
    /// Uses the memory in a finished step's record for the forecast of other steps.
    void learn(const BatchStep& step, const std::string& frame, const StepRecord& record);

    /// Empty if `needed` bytes are free besides the running programs; else the beginning of a
    /// sentence with the memory needed and the memory left.
    std::string lack(double needed, const std::vector<MemoryUse>& running) const;

private:
    double bound(const BatchStep& step, const std::string& frame, double pixels);

    /// Bytes that a measured step took, and the bound that was computed for it.
    struct Learnt {
        double bytes = 0, bound = 0;
    };

    const Manifest& manifest_;
    double limit_;
    OutputPixels output_pixels_;
    std::map<std::string, double> bounds_; ///< by step name, for steps that read a frame
    std::map<std::string, Learnt> learnt_; ///< by memory_group()
};

} // namespace integral

#endif
