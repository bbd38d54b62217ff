// SPDX-License-Identifier: AGPL-3.0-or-later
// integral lcd with a video as INPUT: plays it, or writes a panel's images of it.
#ifndef INTEGRAL_CLI_LCD_VIDEO_H
#define INTEGRAL_CLI_LCD_VIDEO_H

#include "integral/cli/lcd_options.h"

namespace integral {

/// Whether INPUT is a video and all its pictures are used: no --at is given. Throws UsageError if a
/// video is not the only INPUT, or if --at or another option does not work with the inputs.
bool takes_whole_video(const LcdOptions& o);

/// --play: shows the images of a quilt video on the panel, which are made meanwhile.
void play_on_panel(const LcdOptions& o, const LcdRequest& lcd, const Panel& panel);

/// --play without --panel: shows a video's pictures as they are.
void play_as_it_is(const LcdOptions& o, const LcdRequest& lcd);

/// -o: writes the panel's image of each picture of a quilt video.
void write_images_of_video(const LcdOptions& o, const LcdRequest& lcd, const Panel& panel);

/// Prints the report, if pictures were shown. Throws Interrupted if playing was.
void print_play_report(const LcdOptions& o, const PlayReport& report);

} // namespace integral

#endif
