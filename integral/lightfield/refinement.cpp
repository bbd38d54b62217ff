// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/lightfield/refinement.h"

#include <algorithm>
#include <limits>

namespace integral {

namespace {

constexpr int first_step = 4;

// For an edge across the pixel's beam: the standard deviation of samples that the contrast
// predicts, and the number of samples as which this prediction counts. If a part p of the samples
// is white and the rest black, the standard deviation is sqrt(p(1 - p)) of their distance, 0.4 on
// average over p.
constexpr double scatter_of_contrast = 0.4, weight_of_contrast = 4;

// The squared error of n well distributed samples of an edge in four dimensions is proportional to
// n^-1.4, its derivative to n^-2.4; worth is the root of that.
constexpr double order = 1.2;

// Chosen so that a threshold of 0.3 takes about 10 samples at a black and white edge, or 4 if other
// pixels' samples count, too: those make more of a few samples than of many.
double threshold_of_worth(const RefinementRule& rule) { return rule.lent ? 0.5 : 3; }

// The same for a pixel's further samples, if all of its own mean counts. Found by trying on sample
// scenes of POV-Ray's: where few pixels need them, it is at low thresholds what it would be without
// other pixels' samples, and at high ones these pixels are worth more, since they have most of the
// error that is left. Where many need them, none is worth more than the pixels beside them.
double threshold_of_further(const RefinementRule& rule, double of_many)
{
    const double few = 20 * std::sqrt(rule.threshold), many = std::min(few, 1.5);
    return few + of_many * (many - few);
}

constexpr double greatest_contrast = 3;

int most_samples(const RefinementRule& rule) { return 1 << (2 * rule.depth); }

/// How many samples are taken at once after those that were tried.
int next_step(int tried) { return tried < first_step ? first_step - tried : tried; }

/// The variance that a contrast predicts, summed over components of which three differ alike.
double variance_of(double contrast)
{
    const double scatter = scatter_of_contrast * std::min(contrast, greatest_contrast);
    return scatter * scatter / 3;
}

} // namespace

double least_contrast(const RefinementRule& rule) { return (rule.lent ? 2 : 1) * rule.threshold; }

double squared_error_of_one(double contrast) { return variance_of(std::max(0.0, contrast)); }

double samples_at_edges(const RefinementRule& rule)
{
    if (rule.method == 1)
        return double(rule.depth) * rule.depth;
    const double contrast = greatest_contrast, worth = rule.threshold / threshold_of_worth(rule);
    return std::min(std::ldexp(1.0, 2 * rule.depth),
                    std::pow(scatter_of_contrast * contrast / worth, 1 / order));
}

Refinement::Refinement(const RefinementRule& rule, double contrast)
    : rule_(rule), contrast_(std::min(contrast, greatest_contrast))
{
}

int further_samples(const RefinementRule& rule, const SamplesTaken& samples, double squared_error,
                    double own_part, double of_many)
{
    if (rule.method == 1 || samples.tried >= std::min(most_samples(rule), SamplesTaken::most))
        return 0;
    const double worth = own_part * std::sqrt(3 * squared_error / samples.taken);
    return threshold_of_further(rule, of_many) * worth > rule.threshold ? next_step(samples.tried)
                                                                        : 0;
}

double squared_error_falls(int taken, int more)
{
    return std::pow(double(taken) / (taken + more), 2 * order - 1);
}

int Refinement::wanted() const
{
    if (rule_.method == 1)
        return rule_.depth * rule_.depth - tried_;
    const bool wants = tried_ < first_step ||
                       (tried_ < most_samples(rule_) &&
                        threshold_of_worth(rule_) * worth() > rule_.threshold);
    return wants ? next_step(tried_) : 0;
}

void Refinement::add(const ComparedColour& colour)
{
    ++tried_;
    ++taken_;
    for (std::size_t k = 0; k < colour.size(); ++k) {
        sum_[k] += colour[k];
        squares_[k] += colour[k] * colour[k];
    }
}

double Refinement::scatter() const
{
    double sum = 0;
    for (std::size_t k = 0; taken_ > 0 && k < sum_.size(); ++k) {
        const double mean = sum_[k] / taken_;
        sum += std::sqrt(std::max(0.0, squares_[k] / taken_ - mean * mean));
    }
    return sum;
}

double Refinement::contrast_shown() const { return scatter() / scatter_of_contrast; }

double Refinement::squared_deviations() const
{
    double sum = 0;
    for (std::size_t k = 0; k < sum_.size(); ++k)
        sum += std::max(0.0, squares_[k] - sum_[k] * sum_[k] / taken_);
    return sum;
}

double Refinement::squared_error() const
{
    const double variance = (squared_deviations() + weight_of_contrast * variance_of(contrast_)) /
                            (taken_ - 1 + weight_of_contrast);
    return variance / std::pow(double(taken_), 2 * order - 1);
}

double Refinement::worth() const
{
    if (taken_ == 0)
        return std::numeric_limits<double>::infinity();
    const double seen = scatter(), before = scatter_of_contrast * contrast_;
    const double variance = (taken_ * seen * seen + weight_of_contrast * before * before) /
                            (taken_ + weight_of_contrast);
    return std::sqrt(variance) / std::pow(double(taken_), order);
}

} // namespace integral
