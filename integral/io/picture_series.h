// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes several pictures one after another: into an animated WebP, a video, or numbered files.
#ifndef INTEGRAL_IO_PICTURE_SERIES_H
#define INTEGRAL_IO_PICTURE_SERIES_H

#include "integral/frame/frame.h"
#include "integral/io/animation.h"
#include "integral/io/video.h"

#include <optional>
#include <string>

namespace integral {

/// Whether a path names an animation: it ends in .webp, or is_video.
bool is_animation(const std::string& path);

/// The path of one of several files, with its number before the extension, in as many digits as the
/// greatest number, `last`. NAME.png becomes NAME07.png.
std::string numbered(const std::string& path, int number, int last);

/// Settings for writing and playing an animation.
struct AnimationSettings {
    int quality = 90;              ///< 0 to 100; 100 keeps every 8-bit value
    double pictures_a_second = 25; ///< > 0
    bool there_and_back = false;   ///< after the last picture it plays back to the first
};

class PictureSeries {
public:
    /// `path`: NAME.webp, .webm or .mp4 for an animation, which alone uses `settings`; or NAME.png,
    /// .exr or .tiff for files with the numbers `first` to first + count - 1. Throws
    /// std::invalid_argument for "-", OutputError for a path that cannot be written.
    PictureSeries(const std::string& path, const AnimationSettings& settings, int count, int first);

    /// Adds the next picture. A numbered file is written at once, with `metadata` as its document
    /// if given. Throws OutputError.
    void add(Image picture, const std::optional<FrameMetadata>& metadata = std::nullopt);

    /// Completes an animation; numbered files need no completion. Throws OutputError.
    void finish();

private:
    std::string path_;
    int last_, next_;
    AnimationSettings settings_;
    Animation animation_;
    std::unique_ptr<Video> video_;
};

} // namespace integral

#endif
