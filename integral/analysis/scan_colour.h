// SPDX-License-Identifier: AGPL-3.0-or-later
// A scan's light put right: cast, uneven lighting, and the vignetting within the micro-images.
//
// Thesis 5.6.6: a scanner that is balanced for its own lamp scans integral photographs, which other
// light passes through, far too red and orange; it asks for other lamps or for filters before the
// scanner. Gains of the channels in linear light are such filters, made to measure.
#ifndef INTEGRAL_ANALYSIS_SCAN_COLOUR_H
#define INTEGRAL_ANALYSIS_SCAN_COLOUR_H

#include "integral/lightfield/image.h"
#include "integral/optics/lens_mapping.h"

#include <array>
#include <vector>

namespace integral {

/// Means of linear light over squares of a scan, for everything that changes slowly over it.
struct LightGrid {
    int columns = 0, rows = 0, square = 1; ///< squares, and the pixels of a square's side
    int width = 0, height = 0;             ///< of the scan
    std::vector<Color> means;              ///< linear; row by row

    Color at(int column, int row) const { return means[std::size_t(row) * columns + column]; }
};

/// Of squares as large as makes about 64 on the scan's longer side, at least 8 pixels wide.
LightGrid light_grid(const Image& scan, int threads);

/// What a scan's linear light is multiplied by.
class ScanLight {
public:
    /// A flat-field scan, of nothing but the light: divided by, its mean left. Throws
    /// std::invalid_argument where it has another size than the scan, or is black somewhere.
    void divide_by_flat(const Image& flat, int width, int height, int threads);

    /// The surface c0 + c1 x + c2 y + c3 x^2 + c4 xy + c5 y^2 of the logarithm of luminance, fitted
    /// to a scan's squares so that what departs much from it, as the picture's darker things do,
    /// counts little (Tukey's biweight): divided by, its mean left.
    void divide_by_surface(const LightGrid& scan);

    /// Grey world: the channels' means of what is neither burnt out nor dark become equal; the
    /// luminance stays.
    void balance_grey(const LightGrid& scan);

    /// A patch (scan pixels from the top left, inside the scan) becomes white, which sets the
    /// exposure too. Throws std::invalid_argument where it is black.
    void balance_white(const Image& scan, int x, int y, int width, int height);

    /// What to multiply linear light at a scan pixel by.
    Color gain(Vec2 pixel) const;

    Color channel_gains() const { return gains_; }
    /// Greatest over least light of the surface or the flat field, over the scan; 1: even.
    double unevenness() const { return unevenness_; }

private:
    double surface(Vec2 pixel) const; ///< natural logarithm
    std::optional<LightGrid> flat_;   ///< means over the flat's mean
    std::optional<std::array<double, 6>> surface_;
    double width_ = 1, height_ = 1, unevenness_ = 1;
    Color gains_{1, 1, 1, 1};
};

/// Relative luminance of linear light (sRGB's primaries).
double luminance(Color linear);

/// Divides a frame's light by what an average micro-image has at each place of the cell, 1 at its
/// brightest: vignetting. Nowhere brighter than by a factor of 8. Returns the least of the average
/// micro-image (1: nothing to do).
double flatten_micro_images(Image& frame, const Film& film, const SheetOptics& optics,
                            LensMapping mapping, int threads);

} // namespace integral

#endif
