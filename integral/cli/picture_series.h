// SPDX-License-Identifier: AGPL-3.0-or-later
// Several pictures of one command, in order: an animated WebP, or files with numbers.
#ifndef INTEGRAL_CLI_PICTURE_SERIES_H
#define INTEGRAL_CLI_PICTURE_SERIES_H

#include "integral/cli/command.h"
#include "integral/io/animation.h"
#include "integral/lightfield/image.h"

#include <string>

namespace integral {

/// The options that say how an animation is played: --fps and --quality.
void add_series_options(options::options_description& all);

/// Whether a path is an animation's: it ends in .webp (any case).
bool is_animation(const std::string& path);

/// Throws UsageError where they are given for an output that is none.
void check_series_options(const options::variables_map& arguments, const std::string& output);

/// The path of one of several files: its number before the extension, with as many digits as the
/// last one's.
std::string numbered(const std::string& path, int number, int last);

class PictureSeries {
public:
    /// `path`: NAME.webp, or NAME.png (.exr, .tiff) for files NAMEn.png, n from `first` on with as
    /// many digits as the last needs, as POV-Ray numbers an animation's. Throws UsageError for what
    /// the options say, OutputError for a path that cannot be written.
    PictureSeries(const options::variables_map& arguments, const std::string& path, int count,
                  int first);

    /// The next picture: a numbered file is written at once, with its document if there is one.
    /// Throws OutputError.
    void add(Image picture, const std::optional<FrameMetadata>& metadata = std::nullopt);

    /// Writes the animation, if it is one. there_and_back: it plays back to the first picture, too.
    /// Throws OutputError.
    void finish(bool there_and_back);

private:
    std::string path_;
    int last_, next_;
    double pictures_a_second_;
    Animation animation_;
};

} // namespace integral

#endif
