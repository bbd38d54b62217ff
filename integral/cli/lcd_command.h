// SPDX-License-Identifier: AGPL-3.0-or-later
// What a command line of integral lcd asks for, for a batch that checks one before it runs.
#ifndef INTEGRAL_CLI_LCD_COMMAND_H
#define INTEGRAL_CLI_LCD_COMMAND_H

#include "integral/cli/command.h"
#include "integral/output/panel_images.h"
#include "integral/output/screen_show.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

struct LcdOptions {
    std::vector<std::string> inputs;
    std::string output;
    bool json = false;

    std::string panel;                      ///< a name or a file
    std::optional<double> viewing_distance; ///< mm
    PanelImageOptions image;
    std::optional<PanelCard> card;
    bool list = false, describe = false, camera = false;

    bool show = false, play = false, list_displays = false;
    bool has_fps = false, has_seconds = false;
    ShowOptions showing;
    PlayOptions playing;
};

/// Reads the options of a command line. Throws UsageError for values that make no sense.
LcdOptions lcd_options(const options::variables_map& arguments);

/// Throws UsageError where options of making a panel's image make no sense together.
void check_panel_options(const LcdOptions& lcd);

/// The panel of --panel, seen from --viewing-distance. Throws UsageError, InputError.
Panel panel_of(const LcdOptions& lcd);

} // namespace integral

#endif
