// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/reconstruction/light_field_image.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <utility>

namespace integral {

namespace {

int rounded(double x) { return int(std::lround(x)); }

} // namespace

StoredColour stored_colour(const ComparedColour& colour)
{
    StoredColour stored;
    for (std::size_t k = 0; k < stored.size(); ++k)
        // fmax turns NaN into 0.
        stored[k] = std::uint16_t(std::fmin(std::fmax(colour[k], 0) * colour_levels + 0.5, 65535));
    return stored;
}

std::shared_ptr<void> zeroed_memory(std::size_t bytes)
{
    std::shared_ptr<void> memory(std::calloc(std::max<std::size_t>(1, bytes), 1), std::free);
    if (!memory)
        throw std::bad_alloc();
    return memory;
}

int refine_margin_rows(const LensSheet& sheet, const Film& film)
{
    const Lattice lattice(sheet);
    const Vec2 pole = lattice.pole({0, 0});
    double furthest = 0;
    lattice.for_each_within(pole, 1.001 * sheet.pitch, [&](LensIndex lens) {
        if (lattice.arrangement() == Arrangement::lenticular ||
            length(lattice.pole(lens) - pole) < 1.001 * sheet.pitch)
            furthest = std::max(furthest, std::fabs(lattice.pole(lens).y - pole.y));
    });
    return std::max(1, int(std::lround(furthest / film.pixel_pitch.y)));
}

std::size_t LightFieldImage::bytes(const Film& film)
{
    return bytes_a_pixel * film.width * film.height;
}

LightFieldImage::LightFieldImage(int width, int height, std::shared_ptr<void> memory)
    : width_(width),
      height_(height),
      indices_are_whole_(true),
      memory_(memory ? std::move(memory)
                     : zeroed_memory(bytes_a_pixel * std::size_t(width) * std::size_t(height))),
      entries_(static_cast<Entry*>(memory_.get()))
{
}

LightFieldImage::LightFieldImage(const IntegralCamera& camera, std::shared_ptr<void> memory)
    : LightFieldImage(camera.film.width, camera.film.height, std::move(memory))
{
    const Lattice& lattice = camera.optics.lattice();
    const Vec2 pixel = camera.film.pixel_pitch, pole = lattice.pole({0, 0});
    const double least_step = lattice.arrangement() == Arrangement::lenticular
                                  ? lattice.pitch()
                                  : std::min(lattice.pitch(), lattice.row_spacing());
    indices_are_whole_ = std::hypot(width_ * pixel.x, height_ * pixel.y) < 32000 * least_step;
    const auto add = [&](LensIndex forth_even, LensIndex forth_odd) {
        const Vec2 way = lattice.pole(forth_even) - pole; // (0, 0) is in an even row
        const int x = rounded(way.x / pixel.x), y = rounded(-way.y / pixel.y);
        // If the step changes the row, the step back from an even row is the inverse of the step
        // forth from an odd one.
        const bool turns = forth_even.j != 0;
        const int even = int(forth_even.i), odd = int(forth_odd.i), row = int(forth_even.j);
        axes_.push_back({Step{{even, odd}, row, x, y},
                         Step{{turns ? -odd : -even, turns ? -even : -odd}, -row, -x, -y}});
    };
    add({1, 0}, {1, 0});
    if (lattice.arrangement() == Arrangement::square)
        add({0, 1}, {0, 1});
    if (lattice.arrangement() == Arrangement::hexagonal) {
        add({0, 1}, {1, 1});
        add({-1, 1}, {0, 1});
    }
}

void LightFieldImage::set(int x, int y, const ComparedColour& colour, LensIndex lens, double depth)
{
    Entry& entry = entries_[std::size_t(y) * width_ + x];
    entry.colour = stored_colour(colour);
    entry.i = std::uint16_t(lens.i);
    entry.j = std::uint16_t(lens.j);
    entry.depth = std::isnan(depth) ? std::numeric_limits<float>::infinity() : float(depth);
    if (entry.depth == 0)
        entry.depth = -0.0f;
}

void LightFieldImage::recolour(int x, int y, const ComparedColour& colour)
{
    entries_[std::size_t(y) * width_ + x].colour = stored_colour(colour);
}

double LightFieldImage::depth(int x, int y) const
{
    const Entry& entry = entries_[std::size_t(y) * width_ + x];
    return empty(entry) ? std::numeric_limits<double>::quiet_NaN()
                        : entry.depth + 0.0; // -0 + 0 is 0
}

std::array<std::optional<FourFloats>, 2> LightFieldImage::colours_behind_next_lenses(int x,
                                                                                     int y) const
{
    const Entry* own = at(x, y);
    if (!own || axes_.empty() || std::abs(axes_[0][0].y) > 1)
        return {};
    const auto colour_of = [](const Entry* entry) {
        return entry ? std::optional(encoded(*entry)) : std::nullopt;
    };
    return {colour_of(at_step(*own, x, y, axes_[0][0])),
            colour_of(at_step(*own, x, y, axes_[0][1]))};
}

std::array<float, 2> LightFieldImage::depths_around(int x, int y) const
{
    const Entry& own = entries_[std::size_t(y) * width_ + x];
    std::array<float, 2> range = {own.depth, own.depth};
    const auto include = [&](const Entry* other) {
        if (other)
            range = {std::min(range[0], other->depth), std::max(range[1], other->depth)};
    };
    for_each_axis(own, x, y, [&](const Entry* a, const Entry* b) { include(a), include(b); });
    return range;
}

std::optional<LensIndex> LightFieldImage::lens_around(int x, int y) const
{
    const Entry* own = at(x, y);
    if (!own || !indices_are_whole_)
        return {};
    for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i)
            if (!at(i, j, own->i, own->j))
                return {};
    return LensIndex{std::int16_t(own->i), std::int16_t(own->j)};
}

double LightFieldImage::contrast(int x, int y) const
{
    const Entry* own = at(x, y);
    if (!own)
        return -1;
    const FourIntegers twice = 2 * integers_from(own->colour);
    int most = -1;
    const auto compare = [&](const Entry* a, const Entry* b) {
        if (!a && !b)
            return;
        if (!a || !b)
            a = b = a ? a : b;
        const FourIntegers way = twice - integers_from(a->colour) - integers_from(b->colour),
                           far = way > 0 ? way : -way;
        const int sum = far[0] + far[1] + far[2] + far[3];
        most = std::max(most, a == b ? sum / 2 : sum);
    };
    for_each_axis(*own, x, y, compare);
    return most < 0 ? std::numeric_limits<double>::infinity() : double(most) / colour_levels;
}

} // namespace integral
