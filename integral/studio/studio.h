// SPDX-License-Identifier: AGPL-3.0-or-later
// Answers the requests of the studio's page, on which a scene, or a picture, is placed on a sheet.
#ifndef INTEGRAL_STUDIO_STUDIO_H
#define INTEGRAL_STUDIO_STUDIO_H

#include "integral/studio/panel_window.h"
#include "integral/studio/studio_renders.h"
#include "integral/studio/server.h"

namespace integral {

/// Answers requests to a Server:
/// - GET "/": the page.
/// - GET "/events": StudioRenders::state whenever it changes, as server-sent events.
/// - GET "/probe": probe_bytes of the newest probe; status 404 before the first.
/// - GET "/exact": the newest exact draft: a line of JSON (the frame's document), padded with
///   spaces to a multiple of four bytes, then the pixels: R, G, B and alpha, 8-bit sRGB.
/// - POST "/figures" with settings (settings_from_json): settings_figures. Without settings: the
///   first ones, in the field `settings`.
/// - POST "/exact/NUMBER" with settings: requests the exact draft. POST "/stop/NUMBER": ends
///   that work.
/// - POST "/print" with settings: requests the print, in the working folder; POST "/stop-print"
///   ends that work.
/// - POST "/save" with settings: writes a file into the working folder (StudioInput::save); answers
///   with `file` and `command`, which makes the print with it.
/// - POST "/page" with a paper's name (paper_named), or without for a page as large as the picture
///   and its marks: writes the print's page as PDF into the working folder; answers
///   with `file` and `command`, which does the same.
/// - POST "/show" with settings of a panel: shows the newest print on it, full screen on the
/// display
///   that it is; answers with `command`, which does the same.
/// Files for a panel are named INPUT-on-panel, others INPUT-on-sheet.
/// Settings that cannot work are answered by status 400 and a sentence. No path names a file.
class Studio {
public:
    /// `input`: as given to `renders`; all three must outlive this. `first`: the settings to begin
    /// with; a print of size 0 gets the shape of the input's picture.
    Studio(const StudioInput& input, const PlacementSettings& first, StudioRenders& renders,
           PanelWindow& window);

    /// May be called by several threads at once.
    std::optional<ServerAnswer> answer(const ServerRequest& request);

private:
    std::optional<ServerAnswer> post(const ServerRequest& request);
    PlacementSettings possible_settings(const std::string& text) const;
    std::string print_name(const PlacementSettings& settings) const;
    std::string figures(const std::string& settings) const;
    std::string save(const PlacementSettings& settings) const;
    std::string page(const std::string& paper) const;
    std::string show(const PlacementSettings& settings) const;

    const StudioInput& input_;
    const PlacementSettings first_;
    StudioRenders& renders_;
    PanelWindow& window_;
};

/// The studio's page for an input. `first`: the first settings, whose sheet or panel
/// is in the page's list even if it is none of the known ones.
std::string studio_page(const StudioInput& input, const PlacementSettings& first,
                        const ServerRequest& request);

} // namespace integral

#endif
