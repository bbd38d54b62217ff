// SPDX-License-Identifier: AGPL-3.0-or-later
// FLIP: the difference that a person perceives who sees two pictures in turn at one place.
#ifndef INTEGRAL_COMPARE_FLIP_H
#define INTEGRAL_COMPARE_FLIP_H

#include "integral/compare/flip_kernels.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace integral {

struct FlipSettings {
    double ppd = flip_default_ppd; ///< pixels per degree of the viewer's sight, > 0
    /// HDR-FLIP, at these exposures; empty: LDR-FLIP, which clamps light to 0 to 1.
    std::optional<FlipExposures> exposures;
};

/// Figures of a FLIP map, 0 (equal) to 1.
struct FlipFigures {
    double mean = 0;
    /// Pixels up to these values hold a quarter, a half and three quarters of the map's sum.
    double quartiles[3] = {0, 0, 0};
    double greatest = 0;
    int x = 0, y = 0; ///< the first pixel with the greatest value
    FlipSettings settings;
};

/// Rows of linear light: `width` values of each channel for each row.
struct LightRows {
    const float *r, *g, *b;
};

/// Computes FLIP of two pictures that come row by row. Keeps in memory the rows around a band.
class Flip {
public:
    /// Takes `rows` finished rows of the map from row `first` on; width x rows values.
    using TakeMap = std::function<void(int first, int rows, const float* map)>;

    /// Fills `weights` with the weight of each pixel of row y in the figures, >= 0.
    using WeightsOf = std::function<void(int y, float* weights)>;

    /// `take` and `weights_of` may be empty; without weights every pixel weighs 1.
    Flip(int width, int height, const FlipSettings& settings, TakeMap take = {},
         WeightsOf weights_of = {});
    ~Flip();

    /// Takes the next rows of the reference `a` and of `b`: linear sRGB light over black.
    void add(const LightRows& a, const LightRows& b, int rows);

    /// The figures, after all rows have been added. NaN where no pixel has weight.
    FlipFigures result() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace integral

#endif
