// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/analysis/lattice_candidates.h"

#include "integral/optics/lens_sheet.h"

#include <algorithm>
#include <cmath>

namespace integral {
namespace {

constexpr int most_candidates = 3;

/// Frequencies (cycles/mm) at which a sheet's micro-images repeat near the axis.
std::vector<Vec2> frequencies_of(const LensSheet& sheet, double distance)
{
    const Lattice lattice(sheet);
    const double pitch = sheet.pitch * (1 + sheet.thickness / (sheet.ior * distance));
    const Vec2 u = (1 / pitch) * lattice.across(), v = (1 / pitch) * lattice.along();
    switch (sheet.arrangement) {
    case Arrangement::lenticular: return {u};
    case Arrangement::square: return {u, v};
    case Arrangement::hexagonal: break;
    }
    const double row = 1 / std::sqrt(3.0);
    return {u + row * v, u - row * v, (2 * row) * v};
}

Vec2 frequency_in_scan(Vec2 frequency, const ScanMap& map)
{
    const double c = std::cos(map.rotation), s = std::sin(map.rotation);
    return {(c * frequency.x - s * frequency.y) / map.scale.x,
            -(s * frequency.x + c * frequency.y) / map.scale.y};
}

/// Maps with different rotations and scales; each row has one rotation.
struct CandidateGrid {
    int scales, turns;
    std::vector<LatticeCandidate> all;
    const LatticeCandidate& at(int scale, int turn) const { return all[turn * scales + scale]; }
};

/// Every rotation and scale in the range of the search. The score is the sum of the amplitudes
/// (square roots of the powers) of a few harmonics.
CandidateGrid scored_by_spectrum(const Spectrum& spectrum, const LatticeSearch& search,
                                 const ScanMap& about)
{
    constexpr int harmonics = 3;
    const std::vector<Vec2> frequencies = frequencies_of(search.sheet, search.aperture.distance);
    // Each step moves the highest harmonic by half of the window's resolution.
    const double pixels = search.sheet.pitch * std::min(about.scale.x, about.scale.y);
    const double step = 0.5 * pixels / (harmonics * spectrum.extent());
    CandidateGrid grid;
    grid.scales = 2 * int(std::ceil(search.scale_range / step)) + 1;
    grid.turns = 2 * int(std::ceil(search.turn_range / step)) + 1;
    const auto from_minus_one_to_one = [](int k, int count) {
        return count > 1 ? 2.0 * k / (count - 1) - 1 : 0;
    };
    for (int j = 0; j < grid.turns; ++j)
        for (int i = 0; i < grid.scales; ++i) {
            LatticeCandidate c{about, 0};
            const double factor = 1 + search.scale_range * from_minus_one_to_one(i, grid.scales);
            c.map.scale = factor * about.scale;
            c.map.rotation += search.turn_range * from_minus_one_to_one(j, grid.turns);
            for (const Vec2 frequency : frequencies)
                for (int h = 1; h <= harmonics; ++h)
                    c.score += std::sqrt(
                        spectrum.power(frequency_in_scan(double(h) * frequency, c.map)));
            grid.all.push_back(c);
        }
    return grid;
}

/// Whether no map within two steps each way has a higher score.
bool is_peak(const CandidateGrid& grid, int scale, int turn)
{
    for (int j = std::max(0, turn - 2); j <= std::min(grid.turns - 1, turn + 2); ++j)
        for (int i = std::max(0, scale - 2); i <= std::min(grid.scales - 1, scale + 2); ++i)
            if (!(grid.at(i, j).score <= grid.at(scale, turn).score))
                return false;
    return true;
}

} // namespace

std::vector<LatticeCandidate> candidates_of(const Spectrum& spectrum, const LatticeSearch& search,
                                            const ScanMap& about)
{
    const CandidateGrid grid = scored_by_spectrum(spectrum, search, about);
    std::vector<LatticeCandidate> peaks;
    for (int j = 0; j < grid.turns; ++j)
        for (int i = 0; i < grid.scales; ++i)
            if (is_peak(grid, i, j))
                peaks.push_back(grid.at(i, j));
    std::sort(peaks.begin(), peaks.end(), [](const LatticeCandidate& a, const LatticeCandidate& b) {
        return a.score > b.score;
    });
    peaks.resize(std::min<std::size_t>(peaks.size(), most_candidates));
    return peaks;
}

} // namespace integral
