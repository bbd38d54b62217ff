// SPDX-License-Identifier: AGPL-3.0-or-later
// Halftones a frame for printers that print a dot or none, or dots of a few levels.
//
// A lens magnifies each pixel behind it to its own width, so that ordinary error diffusion, which
// spreads a pixel's error to its neighbours across the lens, spreads it to other views: an eye sees
// the error without its compensation. Here a pixel's error goes to the next pixel of the same view,
// which lies along the lens; there an eye averages over many pixels.
#ifndef INTEGRAL_PRINT_LENS_HALFTONE_H
#define INTEGRAL_PRINT_LENS_HALFTONE_H

#include "integral/frame/image.h"
#include "integral/print/seen_error.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace integral {

constexpr int most_levels = 16;

struct HalftoneSettings {
    int levels = 2;   ///< tones of a dot, 2 to most_levels, in equal steps of linear light
    bool grey = true; ///< one ink, black; else each of R, G and B is halftoned
};

/// Lines of pixels that run along lenticular lenses from edge to edge of a film. Each pixel is on
/// one line, and each line stays within half a pixel of one place behind its lens, at any slant and
/// pixel pitch. A line has one pixel in each row or, where lenses lie more across, in each column.
class LensLines {
public:
    LensLines(const LensSheet& sheet, const Film& film);

    struct Pixel {
        int x = 0, y = 0;
    };

    /// The pixel some steps further on a line, downwards for positive ones. It may lie beyond the
    /// film.
    Pixel further(Pixel pixel, int steps) const;

    /// The number of a pixel's line.
    int line_of(Pixel pixel) const;

    /// Whether a row's pixels follow each other from right to left.
    bool leftwards() const { return leftwards_; }

private:
    int shift(int steps) const;
    int column_of(int x) const { return leftwards_ ? width_ - 1 - x : x; }

    int width_;
    bool in_columns_ = false; ///< one pixel in each column
    bool leftwards_ = false;  ///< lines in columns go down to the left
    double slope_ = 0;        ///< columns per row; or rows per column, >= 0
};

/// Halftones the rows of a frame block by block, from the top.
/// - Lenticular: a pixel's error goes to the next pixel of its line (LensLines). Neighbouring lines
///   have their dots at different places, and so have the channels. Then dots move along their
///   lines, by one or two pixels at a time, while this makes the error smaller that eyes see
///   (SeenError; direct binary search, Analoui and Allebach 1992). So the light of each line in a
///   block differs from the frame's by at most one level.
/// - Square and hexagonal: an eye sees one place behind each lens, and averages over the pixels
///   around this place only. Error goes to the next pixels on all sides (Floyd and Steinberg 1976).
class LensHalftone {
public:
    /// Throws std::invalid_argument if the number of levels is out of range.
    LensHalftone(const FrameMetadata& metadata, const HalftoneSettings& settings);

    static constexpr int block_rows = 64;

    /// Halftones the frame's next block_rows rows, or its last ones: three channels, as wide as the
    /// film, in any encoding; light below 0 and above 1 is clipped. The result has 8 bits, sRGB,
    /// and three channels; if settings.grey, one channel, the luminance.
    Image apply(const Image& rows);

    /// Starts again at the top row.
    void restart();

private:
    /// A block of one channel, row by row, and what the next block needs to know.
    struct Channel {
        std::vector<float> light;
        std::vector<int> levels;
        std::vector<double> above, here; ///< errors of the row above and of the current row
        std::optional<SeenError> seen;   ///< lenticular
    };

    void diffuse(Channel& channel, int index, int rows) const;
    double error_along(const Channel& channel, int index, LensLines::Pixel pixel) const;
    double error_around(const Channel& channel, int x) const;
    void search(Channel& channel, int rows) const;
    int move_dots(Channel& channel, int rows) const;

    int width_;
    double steps_;                    ///< levels less one
    std::vector<std::uint8_t> codes_; ///< each level's sample
    bool lenticular_;
    LensLines lines_;
    int first_ = 0; ///< the block's first row
    std::vector<Channel> channels_;
};

} // namespace integral

#endif
