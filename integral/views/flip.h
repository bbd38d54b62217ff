// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes one frame from several pictures that share the viewing zone: flips, motion, morphs, and
// flips of frames with depth.
#ifndef INTEGRAL_VIEWS_FLIP_H
#define INTEGRAL_VIEWS_FLIP_H

#include "integral/base/parallel.h"
#include "integral/frame/picture_fit.h"
#include "integral/sheet/zone_shares.h"
#include "integral/views/zone_view.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace integral {

/// The pictures of a flip, and how they share the zone.
struct PictureFlip {
    std::vector<std::string> pictures; ///< flat ones, and frames of one sheet and film
    std::string output;
    std::optional<FrameMetadata> geometry; ///< of the frame; nothing: the input frames' geometry
    std::vector<double> shares;            ///< by picture; empty: equal ones
    double transition = 0;                 ///< as in ZoneDivision
    bool loop = false;                     ///< as in ZoneDivision
    bool there_and_back = false; ///< after the last picture the order goes back to the second
    bool reverse = false;        ///< the first picture is at the right, or above
    bool upwards = false;        ///< divides the zone upwards, for lenses that show both ways
    double deghost = 0;          ///< contrast that Deghosting may lose, 0 to 1; 0: no Deghosting
    Fit fit = Fit::contain;
    std::optional<int> bits; ///< 8, 16 or 32; nothing: the most bits of any picture
    int threads = 0;         ///< 0: one per core
    /// Takes notices for the user, a line each.
    std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// Writes the frame and returns its ZoneView. Throws std::invalid_argument where the request makes
/// no sense, InputError, OutputError, and Interrupted where `progress` stops the work.
ZoneView write_flip(const PictureFlip& flip, const Progress& progress);

} // namespace integral

#endif
