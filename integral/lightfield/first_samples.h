// SPDX-License-Identifier: AGPL-3.0-or-later
// What anti-aliasing knows of a frame once every pixel has been sampled: which pixels depart from
// what their neighbours in the light field let expect. The neighbours are of two kinds, the two
// domains of an integral image: the next pixels behind the same lens, and the pixels behind the
// next lenses that see in the same direction.
#ifndef INTEGRAL_LIGHTFIELD_FIRST_SAMPLES_H
#define INTEGRAL_LIGHTFIELD_FIRST_SAMPLES_H

#include "integral/optics/camera.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace integral {

/// A colour as anti-aliasing compares it: red, green, blue and transparency, in an encoding that
/// resembles the eye's.
using ComparedColour = std::array<double, 4>;

/// The sum of the four differences: POV-Ray's measure, in which black and white are 3 apart.
double colour_distance(const ComparedColour& a, const ComparedColour& b);

/// How many rows up or down a pixel's neighbours are, at most.
int rows_looked_at(const LensSheet& sheet, const Film& film);

/// First samples of a frame, 16 bytes a pixel. Different pixels may be set from different threads.
class FirstSamples {
public:
    /// All pixels are empty. `memory`: of bytes(camera.film), all 0, aligned to 4; nothing: its
    /// own.
    explicit FirstSamples(const IntegralCamera& camera, std::shared_ptr<void> memory = nullptr);

    FirstSamples(FirstSamples&&) = default;
    FirstSamples(const FirstSamples&) = delete;

    /// How much memory a film's first samples take: rows one after another, from the top.
    static std::size_t bytes(const Film& film);

    /// The colour (kept from 0 to 8) of pixel (x, y), which `lens` images, and the depth of what it
    /// shows: mm from the sheet away from the viewer, or infinite.
    void set(int x, int y, const ComparedColour& colour, LensIndex lens, double depth);

    /// That depth; NaN for an empty pixel.
    double depth(int x, int y) const;

    /// How far a pixel departs from its neighbours: along each axis of the light field the
    /// colour_distance between its double and the sum of its neighbours on either side, so that an
    /// even run of colours does not count; where only one of the two is there, their distance. The
    /// largest of all axes. Neighbours that are empty, or behind a lens that they should not be
    /// behind, are not there. Infinite if none is; -1 for an empty pixel.
    double contrast(int x, int y) const;

    /// Calls visit(x, y) for each neighbour that is there.
    template <class Visit> void for_each_neighbour(int x, int y, Visit visit) const;

private:
    struct Entry {
        std::array<std::uint16_t, 4> colour{};
        std::uint16_t i = 0, j = 0; // the lens, modulo 2^16
        float depth = 0;            // +0: empty; where it is 0 it is kept as -0
    };
    /// The next lens along one of the lattice's axes, and where its pixel of the same direction is.
    struct Step {
        int i[2], j, x, y;
    }; // columns: [0] from an even row, [1] from an odd one
    static bool empty(const Entry& entry);
    const Entry* at(int x, int y) const;
    const Entry* at(int x, int y, std::uint16_t i, std::uint16_t j) const;

    /// Calls visit(a, b) for each axis with the neighbours of `own` on either side, null where
    /// there is none.
    template <class Visit> void for_each_axis(const Entry& own, int x, int y, Visit visit) const;

    int width_, height_;
    std::shared_ptr<void> memory_;
    Entry* entries_;
    std::vector<std::array<Step, 2>> axes_; ///< towards either side
};

template <class Visit>
void FirstSamples::for_each_axis(const Entry& own, int x, int y, Visit visit) const
{
    const auto beside = [&](int dx, int dy) { return at(x + dx, y + dy, own.i, own.j); };
    visit(beside(-1, 0), beside(1, 0));
    visit(beside(0, -1), beside(0, 1));
    for (const auto& axis : axes_) {
        const auto next = [&](const Step& step) {
            return at(x + step.x, y + step.y, std::uint16_t(own.i + step.i[own.j & 1]),
                      std::uint16_t(own.j + step.j));
        };
        visit(next(axis[1]), next(axis[0]));
    }
}

template <class Visit> void FirstSamples::for_each_neighbour(int x, int y, Visit visit) const
{
    const auto one = [&](const Entry* entry) {
        if (entry) {
            const auto index = entry - entries_;
            visit(int(index % width_), int(index / width_));
        }
    };
    if (const Entry* own = at(x, y))
        for_each_axis(*own, x, y, [&](const Entry* a, const Entry* b) { one(a), one(b); });
}

} // namespace integral

#endif
