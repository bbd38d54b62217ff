// SPDX-License-Identifier: AGPL-3.0-or-later
// How many samples anti-aliasing gives to a pixel: POV-Ray's threshold, depth and methods, taken to
// the light field.
#ifndef INTEGRAL_LIGHTFIELD_REFINEMENT_H
#define INTEGRAL_LIGHTFIELD_REFINEMENT_H

#include "integral/lightfield/first_samples.h"

namespace integral {

/// What +AM, +A and +R say.
struct RefinementRule {
    int method = 1; ///< 1: depth^2 samples at once. 2: 4, 8, 16, ... and up to 4^depth, while they
                    ///< are worth it
    double threshold = 0.3; ///< contrast from which on a pixel is refined; method 2: also 3 times
                            ///< the least worth
    int depth = 3;          ///< 1 to 9
};

/// About how many samples the rule gives to a pixel in which black and white meet.
double samples_at_edges(const RefinementRule& rule);

/// The refinement of one pixel. To be asked for `wanted` samples, given them, and asked again.
class Refinement {
public:
    /// `contrast`: of the pixel (FirstSamples).
    Refinement(const RefinementRule& rule, double contrast);

    /// How many samples more are to be tried; 0: no more.
    int wanted() const;

    /// A sample was tried, and has this colour.
    void add(const ComparedColour& colour);

    /// A sample was tried, and was not the pixel's lens's own.
    void add_none() { ++tried_; }

    /// The standard deviation of the samples, as a colour distance.
    double scatter() const;

    /// What one more sample is worth, a colour distance: the root of that by which the mean's
    /// squared error falls (but for a constant factor). A frame's error is least, for a number of
    /// samples, where the last sample of every pixel is worth the same. Infinite if there are no
    /// samples.
    double worth() const;

private:
    const RefinementRule& rule_;
    double contrast_;
    int tried_ = 0, taken_ = 0;
    ComparedColour sum_{}, squares_{};
};

} // namespace integral

#endif
