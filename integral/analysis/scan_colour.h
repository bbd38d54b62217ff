// SPDX-License-Identifier: AGPL-3.0-or-later
// Corrects a scan's light: colour cast, uneven lighting, and vignetting within the micro-images.
//
// Thesis 5.6.6: a scanner is balanced for its own lamp; integral photographs are lit from behind by
// another lamp, and their scans are far too red and orange. The thesis proposes other lamps, or
// filters before the scanner. Gains of the channels in linear light act as such filters.
#ifndef INTEGRAL_ANALYSIS_SCAN_COLOUR_H
#define INTEGRAL_ANALYSIS_SCAN_COLOUR_H

#include "integral/frame/image.h"
#include "integral/optics/lens_mapping.h"

#include <array>
#include <vector>

namespace integral {

/// Means of linear light over squares of a scan, to estimate slow changes of light over the scan.
struct LightGrid {
    int columns = 0, rows = 0, square = 1; ///< squares, and a square's side in pixels
    int width = 0, height = 0;             ///< of the scan
    std::vector<Colour> means;             ///< linear; row by row

    Colour at(int column, int row) const { return means[std::size_t(row) * columns + column]; }
};

/// About 64 squares on the scan's longer side, each at least 8 pixels wide.
LightGrid light_grid(const Image& scan, int threads);

/// The factors that correct a scan's linear light, pixel by pixel.
class ScanLight {
public:
    /// Divides by a flat-field scan, which shows nothing but the light, relative to the flat
    /// field's mean. Throws std::invalid_argument if its size differs from the scan's, or if it is
    /// black somewhere.
    void divide_by_flat(const Image& flat, int width, int height, int threads);

    /// Divides by the surface c0 + c1 x + c2 y + c3 x^2 + c4 xy + c5 y^2 of the logarithm of
    /// luminance, relative to its mean. It is fitted to the scan's squares with Tukey's biweight,
    /// so that outliers, such as dark things in the picture, count little.
    void divide_by_surface(const LightGrid& scan);

    /// Grey world: makes the means of the channels equal, over the squares that are neither burnt
    /// out nor dark, and retains the luminance.
    void balance_grey(const LightGrid& scan);

    /// Makes the mean of a patch white, which also sets the exposure. The patch is in pixels from
    /// the top left, inside the scan. Throws std::invalid_argument if it is black in a colour.
    void balance_white(const Image& scan, int x, int y, int width, int height);

    /// The factor for the linear light at a scan pixel.
    Colour gain(Vec2 pixel) const;

    Colour channel_gains() const { return gains_; }
    /// Greatest light divided by least light, of surface and flat field together; 1: even light.
    double unevenness() const { return unevenness_; }

private:
    double surface(Vec2 pixel) const; ///< natural logarithm
    std::optional<LightGrid> flat_;   ///< divided by its mean
    std::optional<std::array<double, 6>> surface_;
    double width_ = 1, height_ = 1, unevenness_ = 1;
    Colour gains_{1, 1, 1, 1};
};

/// Relative luminance of linear light (sRGB's primaries).
double luminance(Colour linear);

/// Removes vignetting: divides a frame's light by the average micro-image's light at the same place
/// in the cell, relative to the average's brightest place. The gain is at most 8. Returns the least
/// light of the average micro-image, relative to the brightest; 1 if the frame is black.
double flatten_micro_images(Image& frame, const Film& film, const SheetOptics& optics,
                            LensMapping mapping, int threads);

} // namespace integral

#endif
