// SPDX-License-Identifier: AGPL-3.0-or-later
// The depth that a process sculpts for a mask's grey: measured, simulated, and found by the loop of
// the thesis's appendix C.
#ifndef INTEGRAL_LABORATORY_RESPONSE_H
#define INTEGRAL_LABORATORY_RESPONSE_H

#include <string>
#include <vector>

namespace integral {

/// The depth (mm) that a grey (0 to 1) gives, through mask, exposure and resist together; linear
/// between samples. Greys rise from sample to sample; depths never fall.
class Response {
public:
    struct Sample {
        double grey, depth;
    };

    /// A straight line from 0 to `deepest` mm at grey 1.
    static Response linear(double deepest);
    /// Throws std::invalid_argument unless there are two or more samples that rise as above.
    explicit Response(std::vector<Sample> samples);

    double depth(double grey) const;
    /// Inverse: the least grey that gives a depth; the first or last grey for depths beyond.
    double grey(double depth) const;
    double least_depth() const { return samples_.front().depth; }
    double deepest() const { return samples_.back().depth; }
    const std::vector<Sample>& samples() const { return samples_; }

private:
    std::vector<Sample> samples_;
};

/// Reads lines "GREY, DEPTH" (or with blanks between); # begins a comment. Throws InputError.
Response read_response(const std::string& path);
/// The text of a file that read_response reads.
std::string response_text(const Response& response);

/// One round of the loop: steps 2 to 5.
struct CalibrationRound {
    /// mm between the sculpted profile and the requested straight line: greatest, and root mean
    /// square.
    double greatest = 0, rms = 0;
};

struct Calibration {
    std::vector<CalibrationRound> rounds;
    Response found; ///< the process's response, as known after the last round
};

/// A table of the rounds' errors.
std::string rounds_text(const Calibration& calibration);

/// The six steps of appendix C with a simulated process: assume a linear response; make the mask of
/// a ramp from the highest point to the lowest; expose; measure the profile; correct the assumed
/// response by it; and repeat. `grey_levels`: of the mask. Stops when a round is no better than the
/// one before, at the latest when all grey levels have been measured.
Calibration calibrate(const Response& process, int grey_levels);

} // namespace integral

#endif
