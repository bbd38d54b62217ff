// SPDX-License-Identifier: AGPL-3.0-or-later
// Decides how many samples anti-aliasing takes in a pixel, with POV-Ray's threshold, depth and
// methods applied to the light field.
#ifndef INTEGRAL_RECONSTRUCTION_REFINEMENT_H
#define INTEGRAL_RECONSTRUCTION_REFINEMENT_H

#include "integral/reconstruction/light_field_image.h"

namespace integral {

/// The settings of the options +AM, +A and +R.
struct RefinementRule {
    int method = 1; ///< 1: depth^2 samples at once. 2: 4, 8, 16, ... up to 4^depth, as long as the
                    ///< benefit of another sample (marginal_benefit) is above threshold/3, or with
                    ///< `lent` above twice the threshold
    double threshold = 0.3; ///< see least_contrast
    int depth = 3;          ///< 1 to 9
    bool lent = false;      ///< other pixels' samples will count too (reconstruction.h), so
                            ///< that fewer are taken
};

/// The least contrast (LightFieldImage::contrast) at which a pixel is refined.
double least_contrast(const RefinementRule& rule);

/// The approximate number of samples that the rule takes in a pixel with a black and white edge.
double samples_at_edges(const RefinementRule& rule);

/// The expected squared error, summed over the colour's components, of a pixel that is not refined
/// and keeps its first sample. `contrast`: LightFieldImage::contrast of the pixel.
double squared_error_of_one(double contrast);

/// Counts of a pixel's samples: all that were tried, and only those behind the pixel's lens.
struct SamplesTaken {
    static constexpr int most = 65535; ///< the counts end there
    int tried = 1, taken = 1;
};

/// Number of samples to try next in a pixel of a reconstructed frame; 0: none is worth its time.
/// `own_part`: weight (0 to 1) of the mean of the pixel's own samples; the rest of the weight is
/// that of other pixels' samples. `squared_error`: squared difference between that mean and
/// the other pixels' samples, summed over the components. `of_many`: from 0, where few pixels of a
/// block need extra samples, to 1, where many do. Returns 0 with method 1.
int further_samples(const RefinementRule& rule, const SamplesTaken& samples, double squared_error,
                    double own_part, double of_many);

/// Ratio of the squared error of the mean of taken + more samples to that of `taken` samples.
double squared_error_falls(int taken, int more);

/// The refinement of one pixel. The caller adds as many samples as requested() returns, until
/// requested() returns 0.
class Refinement {
public:
    /// `contrast`: LightFieldImage::contrast of the pixel.
    Refinement(const RefinementRule& rule, double contrast);

    /// The number of samples to try next; 0 at the end.
    int requested() const;

    /// Records the colour of a sample that was tried.
    void add(const ComparedColour& colour);

    /// Records a sample that was tried but belongs to another lens than the pixel's.
    void add_none() { ++tried_; }

    /// The samples so far.
    SamplesTaken samples() const { return {tried_, taken_}; }

    /// The standard deviation of the samples, as a colour distance.
    double scatter() const;

    /// The contrast for which scatter() would be the predicted scatter.
    double contrast_shown() const;

    /// The sum over the samples and the components of squared deviations from the samples' mean.
    double squared_deviations() const;

    /// The expected squared error of the samples' mean, summed over the colour's components. At
    /// least 1 sample must have been added.
    double squared_error() const;

    /// The benefit of one more sample, as a colour distance: the square root of the decrease in the
    /// mean's squared error, up to a constant factor. For a given number of samples in a frame, the
    /// error is least if every pixel's last sample has the same benefit. Infinite before the first
    /// sample.
    double marginal_benefit() const;

private:
    const RefinementRule& rule_;
    double contrast_;
    int tried_ = 0, taken_ = 0;
    ComparedColour sum_{}, squares_{};
};

} // namespace integral

#endif
