// SPDX-License-Identifier: AGPL-3.0-or-later
// Stores one sample per pixel, from which anti-aliasing finds the pixels that differ from their
// neighbours in the light field. There are two kinds of neighbours: the next pixels behind the same
// lens, which differ in direction, and the pixels of the same direction behind the next lenses,
// which differ in place. Once a pixel is finished, its stored colour can be replaced by the
// finished colour, so that NoiseFilter compares finished pixels with their neighbours.
#ifndef INTEGRAL_RECONSTRUCTION_LIGHT_FIELD_IMAGE_H
#define INTEGRAL_RECONSTRUCTION_LIGHT_FIELD_IMAGE_H

#include "integral/base/four_floats.h"
#include "integral/optics/camera.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace integral {

/// A colour for comparison: red, green, blue and transparency in a perceptual encoding.
using ComparedColour = std::array<double, 4>;

/// A ComparedColour in 8 bytes: colour_levels times its components, clamped to 0 to 65535
/// (components of 0 to 8).
using StoredColour = std::array<std::uint16_t, 4>;
constexpr double colour_levels = 8192;
StoredColour stored_colour(const ComparedColour& colour);

/// Allocates `bytes` bytes of memory, all 0. Throws std::bad_alloc.
std::shared_ptr<void> zeroed_memory(std::size_t bytes);

/// The greatest distance in rows between a pixel and its neighbours.
int refine_margin_rows(const LensSheet& sheet, const Film& film);

/// The first sample of each pixel of a frame, 16 bytes a pixel. Different threads may set different
/// pixels at the same time.
class LightFieldImage {
public:
    /// All pixels are empty at first. `memory`: bytes(camera.film) bytes, all 0, aligned to 4;
    /// null: the object allocates its own.
    explicit LightFieldImage(const IntegralCamera& camera, std::shared_ptr<void> memory = nullptr);

    /// The image of a quilt: pixels have neighbours in their own view alone. A view takes the place
    /// of a lens.
    LightFieldImage(int width, int height, std::shared_ptr<void> memory = nullptr);

    LightFieldImage(LightFieldImage&&) = default;
    LightFieldImage(const LightFieldImage&) = delete;

    /// Bytes of memory for a film's first samples, stored row by row from the top.
    static constexpr std::size_t bytes_a_pixel = 16;
    static std::size_t bytes(const Film& film);

    /// Sets the colour of pixel (x, y) (clamped to 0 to 8), the lens that images it, and the depth
    /// of the surface that it shows: mm from the sheet away from the viewer, or infinite.
    void set(int x, int y, const ComparedColour& colour, LensIndex lens, double depth);

    /// Replaces the colour of a pixel that has been set; it is clamped as before.
    void recolour(int x, int y, const ComparedColour& colour);

    /// The depth that was set; NaN for an empty pixel.
    double depth(int x, int y) const;

    /// The lens that was set, with its indices modulo 2^16; nothing for an empty pixel.
    using StoredLens = std::array<std::uint16_t, 2>;
    std::optional<StoredLens> lens(int x, int y) const
    {
        const Entry* entry = at(x, y);
        return entry ? std::optional(StoredLens{entry->i, entry->j}) : std::nullopt;
    }
    /// A lens as it is stored.
    static StoredLens stored(LensIndex lens)
    {
        return {std::uint16_t(lens.i), std::uint16_t(lens.j)};
    }
    /// A lens in one number, which is quick to compare.
    static std::uint32_t number_of(StoredLens lens)
    {
        return std::uint32_t(lens[0]) << 16 | lens[1];
    }

    /// Contrast of a pixel with its neighbours: the largest value over the axes of the light field.
    /// Along an axis with two neighbours, the value is the difference between twice the pixel's
    /// colour and the sum of the neighbours' colours (a second difference, 0 in a linear gradient).
    /// Along an axis with one neighbour, it is the difference from that neighbour's colour. A
    /// difference is the sum of the components' absolute differences, as in POV-Ray (3 between
    /// black and white). A neighbour is missing if it is empty or not behind the expected lens.
    /// Infinite if all neighbours are missing; -1 for an empty pixel.
    double contrast(int x, int y) const;

    /// The colour of a pixel that is not empty.
    FourFloats colour(int x, int y) const { return encoded(entries_[std::size_t(y) * width_ + x]); }

    /// The colours of the two pixels of the same direction behind the next lenses in the row, one
    /// on either side. Nothing for a missing one; nothing for both if they are more than one row of
    /// pixels away.
    std::array<std::optional<FourFloats>, 2> colours_behind_next_lenses(int x, int y) const;

    /// The lens of a pixel, if all eight pixels around it are behind the same lens and the indices
    /// of the frame's lenses fit in 16 bits.
    std::optional<LensIndex> lens_around(int x, int y) const;

    /// Calls visit(x, y) for each neighbour that is not missing.
    template <class Visit> void for_each_neighbour(int x, int y, Visit visit) const;

    /// The least and the greatest depth among a pixel, which must not be empty, and its neighbours.
    std::array<float, 2> depths_around(int x, int y) const;

private:
    struct Entry {
        StoredColour colour{};
        std::uint16_t i = 0, j = 0; // the lens, modulo 2^16
        float depth = 0;            // +0 marks an empty pixel; a depth of 0 is stored as -0
    };
    static_assert(sizeof(Entry) == bytes_a_pixel);
    /// The step to the next lens along a lattice axis (i, j), and the step in pixels to that lens's
    /// pixel of the same direction (x, y).
    struct Step {
        int i[2], j, x, y; // i[0]: from an even row of lenses; i[1]: from an odd one
    };
    static FourIntegers integers_from(const StoredColour& colour)
    {
        typedef std::uint16_t FourUnsignedShorts __attribute__((vector_size(8)));
        FourUnsignedShorts narrow;
        std::memcpy(&narrow, colour.data(), sizeof narrow);
        return __builtin_convertvector(narrow, FourIntegers);
    }
    static FourFloats encoded(const Entry& entry)
    {
        return float(1 / colour_levels) *
               __builtin_convertvector(integers_from(entry.colour), FourFloats);
    }
    static bool empty(const Entry& entry)
    {
        std::uint32_t bits;
        std::memcpy(&bits, &entry.depth, sizeof bits);
        return bits == 0;
    }
    /// The entry of pixel (x, y); null if it is empty or outside the frame.
    const Entry* at(int x, int y) const
    {
        if (x < 0 || y < 0 || x >= width_ || y >= height_)
            return nullptr;
        const Entry& entry = entries_[std::size_t(y) * width_ + x];
        return empty(entry) ? nullptr : &entry;
    }
    /// The same if the pixel is behind lens (i, j), else null.
    const Entry* at(int x, int y, std::uint16_t i, std::uint16_t j) const
    {
        const Entry* entry = at(x, y);
        return entry && entry->i == i && entry->j == j ? entry : nullptr;
    }

    /// The entry of the pixel that is a step away from (x, y), where `own` is; null if that pixel
    /// is not behind the step's lens.
    const Entry* at_step(const Entry& own, int x, int y, const Step& step) const
    {
        return at(x + step.x, y + step.y, std::uint16_t(own.i + step.i[own.j & 1]),
                  std::uint16_t(own.j + step.j));
    }

    /// Calls visit(a, b) for each axis, with the two neighbours of `own`; null for a missing one.
    template <class Visit> void for_each_axis(const Entry& own, int x, int y, Visit visit) const;

    int width_, height_;
    bool indices_are_whole_; ///< the stored indices are exact, not only modulo 2^16
    std::shared_ptr<void> memory_;
    Entry* entries_;
    std::vector<std::array<Step, 2>> axes_; ///< for each axis, the steps in both directions
};

template <class Visit>
void LightFieldImage::for_each_axis(const Entry& own, int x, int y, Visit visit) const
{
    const auto beside = [&](int dx, int dy) { return at(x + dx, y + dy, own.i, own.j); };
    visit(beside(-1, 0), beside(1, 0));
    visit(beside(0, -1), beside(0, 1));
    for (const auto& axis : axes_)
        visit(at_step(own, x, y, axis[1]), at_step(own, x, y, axis[0]));
}

template <class Visit> void LightFieldImage::for_each_neighbour(int x, int y, Visit visit) const
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
