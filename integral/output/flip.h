// SPDX-License-Identifier: AGPL-3.0-or-later
// Makes one frame of several pictures that share the viewing zone: flips, motion, morphs, and
// flips of frames with depth.
#ifndef INTEGRAL_OUTPUT_FLIP_H
#define INTEGRAL_OUTPUT_FLIP_H

#include "integral/base/parallel.h"
#include "integral/lightfield/picture_fit.h"
#include "integral/lightfield/zone_shares.h"
#include "integral/output/zone_view.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace integral {

/// The pictures of a flip, and how they share the zone.
struct PictureFlip {
    std::vector<std::string> pictures; ///< flat ones, and frames of one sheet and film
    std::string output;
    std::optional<FrameMetadata> geometry; ///< of the frame; nothing: that of the frames given
    std::vector<double> shares;            ///< by picture; empty: equal ones
    double transition = 0;                 ///< as in ZoneDivision
    bool loop = false;                     ///< likewise
    bool there_and_back = false; ///< after the last picture the order goes back to the second
    bool reverse = false;        ///< the first picture is at the right, or above
    bool upwards = false;        ///< lenses that show both ways: the zone is divided upwards
    Fit fit = Fit::contain;
    std::optional<int> bits; ///< 8, 16 or 32; nothing: the most that a picture has
    int threads = 0;         ///< 0: one per core
    /// Takes notices for the user, a line each.
    std::function<void(const std::string&)> tell = [](const std::string&) {};
};

/// Writes the frame. Returns what eyes see of it. Throws std::invalid_argument where the request
/// makes no sense, InputError, OutputError, and Interrupted where `progress` stops the work.
ZoneView write_flip(const PictureFlip& flip, const Progress& progress);

} // namespace integral

#endif
