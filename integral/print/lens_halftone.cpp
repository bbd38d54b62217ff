// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/print/lens_halftone.h"

#include "integral/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace integral {
namespace {

/// The error with which a line of pixels starts, in levels, -0.5 to 0.5. Multiples of the golden
/// ratio are spread evenly over any number of neighbouring lines.
double first_error(int line, int channel)
{
    constexpr double golden = 0.61803398874989485;
    const double place = line * golden + channel / 3.0;
    return place - std::floor(place) - 0.5;
}

float luminance(const Colour& c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }

} // namespace

LensLines::LensLines(const LensSheet& sheet, const Film& film) : width_(film.width)
{
    // The lenses' direction in pixels, downwards.
    const Vec2 along = Lattice(sheet).along();
    Vec2 step{along.x / film.pixel_pitch.x, -along.y / film.pixel_pitch.y};
    if (step.y < 0)
        step = -1.0 * step;
    in_columns_ = std::fabs(step.x) > step.y;
    leftwards_ = in_columns_ && step.x < 0;
    slope_ = in_columns_ ? step.y / std::fabs(step.x) : step.x / step.y;
}

/// Pixels by which a line has moved aside after some steps from the film's edge.
int LensLines::shift(int steps) const { return int(std::floor(steps * slope_ + 0.5)); }

LensLines::Pixel LensLines::further(Pixel p, int steps) const
{
    if (!in_columns_)
        return {p.x + shift(p.y + steps) - shift(p.y), p.y + steps};
    const int column = column_of(p.x);
    return {leftwards_ ? p.x - steps : p.x + steps, p.y + shift(column + steps) - shift(column)};
}

int LensLines::line_of(Pixel p) const
{
    return in_columns_ ? p.y - shift(column_of(p.x)) : p.x - shift(p.y);
}

LensHalftone::LensHalftone(const FrameMetadata& metadata, const HalftoneSettings& settings)
    : width_(metadata.film.width),
      steps_(settings.levels - 1),
      lenticular_(metadata.sheet.arrangement == Arrangement::lenticular),
      lines_(metadata.sheet, metadata.film),
      channels_(settings.grey ? 1 : 3)
{
    if (settings.levels < 2 || settings.levels > most_levels)
        throw std::invalid_argument("a dot has 2 to " + std::to_string(most_levels) + " levels");
    for (int level = 0; level < settings.levels; ++level)
        codes_.push_back(std::uint8_t(std::lround(255 * encode(Encoding(), level / steps_))));
    if (lenticular_)
        for (Channel& channel : channels_)
            channel.seen.emplace(metadata);
    restart();
}

void LensHalftone::restart()
{
    first_ = 0;
    for (std::size_t index = 0; index < channels_.size(); ++index) {
        Channel& channel = channels_[index];
        channel.above.clear();
        for (int x = 0; x < width_; ++x)
            channel.above.push_back(first_error(x, int(index)) / steps_);
        channel.here = channel.above;
        if (channel.seen)
            channel.seen->restart();
    }
}

/// The error of the pixel before this one on its line; at the film's edge, the line's first error.
double LensHalftone::error_along(const Channel& channel, int index, LensLines::Pixel pixel) const
{
    const LensLines::Pixel before = lines_.further(pixel, -1);
    if (before.x < 0 || before.x >= width_ || before.y < 0)
        return first_error(lines_.line_of(pixel), index) / steps_;
    return (before.y < pixel.y ? channel.above : channel.here)[std::size_t(before.x)];
}

/// The part of the neighbouring pixels' errors that goes to pixel x of this row. At the film's left
/// and right edge, what would leave the film goes down.
double LensHalftone::error_around(const Channel& channel, int x) const
{
    const double *above = channel.above.data(), *here = channel.here.data();
    double error = 5 * above[x];
    error += x > 0 ? 7 * here[x - 1] + above[x - 1] : 3 * above[x];
    error += x < width_ - 1 ? 3 * above[x + 1] : 8 * above[x];
    return error / 16;
}

/// Selects the levels of a block by error diffusion.
void LensHalftone::diffuse(Channel& channel, int index, int rows) const
{
    channel.levels.resize(channel.light.size());
    for (int y = 0; y < rows; ++y) {
        for (int k = 0; k < width_; ++k) {
            const int x = lines_.leftwards() ? width_ - 1 - k : k;
            const std::size_t at = std::size_t(y) * width_ + x;
            const double sum = channel.light[at] +
                               (lenticular_ ? error_along(channel, index, {x, first_ + y})
                                            : error_around(channel, x));
            const double level = std::clamp(std::floor(sum * steps_ + 0.5), 0.0, steps_);
            channel.levels[at] = int(level);
            channel.here[std::size_t(x)] = sum - level / steps_;
        }
        std::swap(channel.above, channel.here);
    }
}

/// Moves one level from a pixel to another on its line, wherever this makes the error smaller that
/// eyes see. Returns how many have moved.
int LensHalftone::move_dots(Channel& channel, int rows) const
{
    SeenError& seen = *channel.seen;
    const float step = float(1 / steps_), whole = seen.coupling(0, 0);
    const auto level_at = [&](int x, int y) -> int& {
        return channel.levels[std::size_t(y) * width_ + x];
    };
    int moved = 0;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < width_; ++x) {
            float best = 1e-5f;
            LensLines::Pixel to;
            int change = 0;
            for (const int steps : {-2, -1, 1, 2}) {
                LensLines::Pixel other = lines_.further({x, first_ + y}, steps);
                other.y -= first_;
                if (other.x < 0 || other.x >= width_ || other.y < 0 || other.y >= rows)
                    continue;
                const float difference = seen.at(x, y) - seen.at(other.x, other.y);
                // The error's mean square falls by 2 step times this.
                const float gain = std::fabs(difference) -
                                   step * (whole - seen.coupling(other.x - x, other.y - y));
                if (gain <= best)
                    continue;
                const int up = difference > 0 ? -1 : 1, level = level_at(x, y) + up,
                          other_level = level_at(other.x, other.y) - up;
                if (level < 0 || level > steps_ || other_level < 0 || other_level > steps_)
                    continue;
                best = gain;
                to = other;
                change = up;
            }
            if (change == 0)
                continue;
            level_at(x, y) += change;
            level_at(to.x, to.y) -= change;
            seen.change(x, y, float(change) * step);
            seen.change(to.x, to.y, float(-change) * step);
            ++moved;
        }
    return moved;
}

/// Makes the error of a block smaller that eyes see.
void LensHalftone::search(Channel& channel, int rows) const
{
    constexpr int most_passes = 8;
    std::vector<float> errors(channel.light.size());
    for (std::size_t k = 0; k < errors.size(); ++k)
        errors[k] = float(channel.levels[k] / steps_) - channel.light[k];
    channel.seen->begin(errors, rows);
    for (int pass = 0; pass < most_passes && move_dots(channel, rows) > 0; ++pass) {
    }
    channel.seen->end();
}

Image LensHalftone::apply(const Image& rows)
{
    const LinearReader light(rows);
    const int count = int(channels_.size());
    Image dots = make_image<std::uint8_t>(rows.width, rows.height, count, Encoding());
    for (Channel& channel : channels_)
        channel.light.clear();
    for (int y = 0; y < rows.height; ++y)
        for (int x = 0; x < width_; ++x) {
            const Colour c = light(x, y);
            const float values[] = {count == 1 ? luminance(c) : c.r, c.g, c.b};
            for (int index = 0; index < count; ++index)
                channels_[std::size_t(index)].light.push_back(
                    std::clamp(values[index], 0.0f, 1.0f));
        }
    for_each_row(count, 0, [&](int index) {
        Channel& channel = channels_[std::size_t(index)];
        diffuse(channel, index, rows.height);
        if (channel.seen)
            search(channel, rows.height);
        for (int y = 0; y < rows.height; ++y)
            for (int x = 0; x < width_; ++x)
                row_bytes(dots, y)[x * count + index] = codes_[std::size_t(
                    channel.levels[std::size_t(y) * width_ + x])];
    });
    first_ += rows.height;
    return dots;
}

} // namespace integral
