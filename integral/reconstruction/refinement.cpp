// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/refinement.h"

#include <algorithm>
#include <limits>

namespace integral {

namespace {

constexpr int first_step = 4;

// For an edge across the pixel's beam: the samples' standard deviation that the contrast predicts,
// divided by the contrast, and the weight of this prediction, as a number of samples. If a fraction
// p of the samples is white and the other samples are black, the standard deviation is sqrt(p(1 -
// p)) times the distance from black to white: 0.4 times on average over p.
constexpr double scatter_of_contrast = 0.4, weight_of_contrast = 4;

// The squared error of n well distributed samples of an edge in four dimensions is proportional to
// n^-1.4, its derivative to n^-2.4; the marginal benefit is the square root of this derivative.
constexpr double order = 1.2;

// Factor of the marginal benefit in its comparison with the threshold. Chosen so that a threshold
// of 0.3 takes about 10 samples at a black and white edge, or 4 if other pixels' samples count too:
// those help a pixel with few samples more than one with many.
double threshold_of_worth(const RefinementRule& rule) { return rule.lent ? 0.5 : 3; }

// The same factor for a pixel's extra samples, if its own mean has a weight of 1. Tuned on
// POV-Ray's sample scenes. Where few pixels need extra samples, the factor at low thresholds is
// what it would be without other pixels' samples; at high thresholds it is larger, since these few
// pixels have most of the error that is left. Where many pixels need extra samples, the factor is
// limited, since no pixel then gains more than its neighbours.
double threshold_of_further(const RefinementRule& rule, double of_many)
{
    const double few = 20 * std::sqrt(rule.threshold), many = std::min(few, 1.5);
    return few + of_many * (many - few);
}

constexpr double greatest_contrast = 3;

int most_samples(const RefinementRule& rule) { return 1 << (2 * rule.depth); }

/// Number of samples to take at once after `tried` ones.
int next_step(int tried) { return tried < first_step ? first_step - tried : tried; }

/// The variance that a contrast predicts, summed over the components, if three of them differ
/// equally.
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

int Refinement::requested() const
{
    if (rule_.method == 1)
        return rule_.depth * rule_.depth - tried_;
    const bool wants = tried_ < first_step ||
                       (tried_ < most_samples(rule_) &&
                        threshold_of_worth(rule_) * marginal_benefit() > rule_.threshold);
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

double Refinement::marginal_benefit() const
{
    if (taken_ == 0)
        return std::numeric_limits<double>::infinity();
    const double seen = scatter(), before = scatter_of_contrast * contrast_;
    const double variance = (taken_ * seen * seen + weight_of_contrast * before * before) /
                            (taken_ + weight_of_contrast);
    return std::sqrt(variance) / std::pow(double(taken_), order);
}

} // namespace integral
