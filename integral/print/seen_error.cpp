// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/seen_error.h"

#include "integral/base/constants.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr double least_coupling = 0.01; // of R(0); smaller values are left out

double square(double x) { return x * x; }

/// An eye's window on the film, mm: standard deviations of Gaussians.
struct Window {
    double across = 0;           ///< across the lenses, and along them without the eye's own blur
    double sharp = 0, broad = 0; ///< the two parts of the eye's blur

    /// The window's autocorrelation at a distance across and along the lenses, mm.
    double autocorrelation(double x, double y) const
    {
        constexpr double broad_share = 0.3;
        const auto along = [&](double blur) {
            return std::exp(-square(y) / (4 * (square(across) + square(blur))));
        };
        return std::exp(-square(x / across) / 4) * (along(sharp) + broad_share * along(broad)) /
               (1 + broad_share);
    }
};

/// The window of an eye at the viewing distance. `across`, `along`: the extents of a pixel.
Window window_of(const FrameMetadata& m, double across, double along)
{
    constexpr double pupil = 4, printed_dot = 0.04; // diameters, mm
    constexpr double minute = radians_per_degree / 60;
    const double distance = viewer_distance(m);
    Window window;
    // The standard deviation of a disc is a quarter of its diameter; a square's square is 1/12.
    window.across = std::sqrt(square(pupil * m.sheet.thickness / (m.sheet.ior * distance) / 4) +
                              square(printed_dot / 4) + square(across) / 12);
    window.across = std::min(window.across, 3 * across);
    // Far eyes average over more pixels than a search needs to look at.
    window.sharp = std::min(0.93 * minute * distance, 3 * along);
    window.broad = std::min(2.54 * minute * distance, 8 * along);
    return window;
}

} // namespace

SeenError::SeenError(const FrameMetadata& m) : width_(m.film.width)
{
    const Lattice lattice(m.sheet);
    const Vec2 pixel = m.film.pixel_pitch;
    const auto extent = [&](Vec2 direction) {
        return std::hypot(direction.x * pixel.x, direction.y * pixel.y);
    };
    const Window window = window_of(m, extent(lattice.across()), extent(lattice.along()));
    const auto value = [&](int dx, int dy) {
        const Vec2 film{dx * pixel.x, -dy * pixel.y};
        return window.autocorrelation(dot(film, lattice.across()), dot(film, lattice.along()));
    };
    const int far = int(4 * std::max(window.broad, window.across) / std::min(pixel.x, pixel.y)) + 1;
    std::vector<Taps> down; // rows from 0 on; R is the same at opposite distances
    for (int dy = 0; dy <= far; ++dy) {
        Taps row;
        for (int dx = -far; dx <= far; ++dx)
            if (value(dx, dy) >= least_coupling) {
                if (row.values.empty())
                    row.first = dx;
                row.values.push_back(float(value(dx, dy)));
            }
        if (row.values.empty())
            break;
        down.push_back(row);
    }
    reach_ = int(down.size()) - 1;
    taps_.resize(2 * down.size() - 1);
    for (int dy = 0; dy <= reach_; ++dy) {
        const Taps& row = down[std::size_t(dy)];
        Taps& opposite = taps_[std::size_t(reach_ - dy)];
        opposite.first = -(row.first + int(row.values.size()) - 1);
        opposite.values.assign(row.values.rbegin(), row.values.rend());
        taps_[std::size_t(reach_ + dy)] = row;
    }
    restart();
}

float SeenError::coupling(int dx, int dy) const
{
    if (std::abs(dy) > reach_)
        return 0;
    const Taps& row = taps(dy);
    const int at = dx - row.first;
    return at >= 0 && at < int(row.values.size()) ? row.values[std::size_t(at)] : 0;
}

void SeenError::restart()
{
    rows_ = 0;
    sums_.assign(std::size_t(reach_) * width_, 0);
}

void SeenError::begin(const std::vector<float>& errors, int rows)
{
    rows_ = rows;
    sums_.resize(std::size_t(rows + reach_) * width_, 0);
    for (int y = 0; y < rows; ++y)
        for (int dy = std::max(-y, -reach_); dy <= reach_; ++dy) {
            const float* from = errors.data() + std::size_t(y) * width_;
            float* to = sums_.data() + std::size_t(y + dy) * width_;
            const Taps& row = taps(dy);
            for (std::size_t k = 0; k < row.values.size(); ++k) {
                const int dx = row.first + int(k);
                const float value = row.values[k];
                for (int x = std::max(0, -dx); x < std::min(width_, width_ - dx); ++x)
                    to[x + dx] += value * from[x];
            }
        }
}

void SeenError::change(int x, int y, float by)
{
    for (int dy = std::max(-y, -reach_); dy <= reach_; ++dy) {
        const Taps& row = taps(dy);
        float* to = sums_.data() + std::size_t(y + dy) * width_;
        const int first = x + row.first, last = first + int(row.values.size());
        for (int column = std::max(first, 0); column < std::min(last, width_); ++column)
            to[column] += by * row.values[std::size_t(column - first)];
    }
}

void SeenError::end()
{
    sums_.erase(sums_.begin(), sums_.begin() + std::ptrdiff_t(rows_) * width_);
    rows_ = 0;
}

} // namespace integral
