// SPDX-License-Identifier: AGPL-3.0-or-later
// How much memory a batch's steps will take, so that together they stay within what there is.
#ifndef INTEGRAL_BATCH_BATCH_MEMORY_H
#define INTEGRAL_BATCH_BATCH_MEMORY_H

#include "integral/batch/plan.h"
#include "integral/batch/step_record.h"
#include "integral/optics/vec.h"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace integral {

/// What the header of a frame's file says.
struct FrameLook {
    bool deep = false;  ///< more than 8 bits a sample
    Vec2 pixel_pitch{}; ///< mm
    double bytes = 0;   ///< of the file
};

/// Throws InputError where it is no integral frame.
FrameLook look_at_frame(const std::string& path);

/// Pixels of the picture that a step makes of a frame whose pixels have this pitch (mm): of a
/// printed page, a view or a sheet of views, a panel's image. Who knows the commands' options tells
/// it.
using OutputPixels = std::function<double(const BatchStep& step, Vec2 pixel_pitch)>;

/// Bytes of a program that runs.
struct MemoryUse {
    double expected = 0, now = 0;
};

/// What steps will need of the machine's memory. Figures measured for every command, format and
/// size bound it from above, but for what a scene itself takes; that is learnt from its frames that
/// have ended.
class MemoryForecast {
public:
    /// `limit`: bytes that all together may take; 0: what the machine has free.
    MemoryForecast(const Manifest& manifest, double limit, OutputPixels output_pixels)
        : manifest_(manifest), limit_(limit), output_pixels_(std::move(output_pixels))
    {
    }

    /// Bytes for a step. `frame` is the path of what it takes, and `pixels` are that frame's, or
    /// those that it makes; `before` is its record of its last run. Throws InputError.
    double expected(const BatchStep& step, const std::string& frame, double pixels,
                    const StepRecord& before);
    /// To be called after a step that was made.
    void learn(const BatchStep& step, const std::string& frame, const StepRecord& record);

    /// Empty if that many bytes can be had beside what runs; else a sentence's begin: what is
    /// needed, and what is left.
    std::string lack(double needed, const std::vector<MemoryUse>& running) const;

private:
    double bound(const BatchStep& step, const std::string& frame, double pixels);

    const Manifest& manifest_;
    double limit_;
    OutputPixels output_pixels_;
    std::map<std::string, double> bounds_;                    ///< by step's name
    std::map<std::string, std::pair<double, double>> learnt_; ///< by likes(): bytes, and their
                                                              ///< bound
};

} // namespace integral

#endif
