// SPDX-License-Identifier: AGPL-3.0-or-later
// The options of integral lcd. A batch reads and checks them before it starts.
#ifndef INTEGRAL_CLI_LCD_OPTIONS_H
#define INTEGRAL_CLI_LCD_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/cli/depth_pictures.h"
#include "integral/cli/fit_options.h"
#include "integral/cli/thread_options.h"
#include "integral/panel/panel_images.h"
#include "integral/screen/screen_show.h"

#include <optional>
#include <string>
#include <vector>

namespace integral {

struct LcdOptions : CommonOptions {
    std::optional<std::string> output, html, panel, views, size, viewing_distance, card, at, show,
        fps, seconds;
    std::string blend = "linear", sampling = "linear";
    std::optional<std::vector<std::string>> even;
    std::optional<int> view;
    bool encoded = false, list = false, describe = false, camera = false, quilt = false,
         play = false, loop = false, list_displays = false, json = false;
    DepthSource depth;
    FitOptions fit;
    ViewOrderOptions given_views;
    ThreadOptions threads;
};

void declare(options::options_description& all, LcdOptions& o);

/// Parsed values of the options that are text.
struct LcdRequest {
    std::string panel, output;              ///< empty: not given
    std::optional<double> viewing_distance; ///< mm
    PanelImageOptions image;
    std::optional<PanelCard> card;
    ShowOptions showing;
    PlayOptions playing;
};

/// Throws UsageError for values that make no sense.
LcdRequest lcd_request(const LcdOptions& o);

/// Throws UsageError if options of making a panel's image contradict each other.
void check_panel_options(const LcdOptions& o, const LcdRequest& request);

/// The panel of --panel, seen from --viewing-distance. Throws UsageError, InputError.
Panel panel_of(const LcdRequest& request);

} // namespace integral

#endif
