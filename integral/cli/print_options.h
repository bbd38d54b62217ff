// SPDX-License-Identifier: AGPL-3.0-or-later
// The options of `integral print`, and the page that they describe.
#ifndef INTEGRAL_CLI_PRINT_OPTIONS_H
#define INTEGRAL_CLI_PRINT_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/cli/geometry_options.h"
#include "integral/print/frame_print.h"

namespace integral {

struct PrintOptions : CommonOptions {
    std::optional<std::string> output;
    std::optional<std::string> start; ///< --sheet: file with the geometry
    // Frames:
    std::optional<std::string> paper, orientation, feed, centre, bleed, marks, overlap, icc, intent;
    std::optional<std::string> gap, repeat; ///< of several on a page
    std::optional<std::string> white, halftone;
    std::optional<int> bits, levels;
    bool strip = false, mirror = false, tile = false;
    // Printers:
    std::optional<std::string> printer, medium;
    std::optional<int> copies;
    std::optional<Arguments> printer_options;
    // Charts:
    bool chart = false, calibration = false, keep_index = false, json = false;
    std::optional<Arguments> even;
    std::optional<std::string> pitch_range, pitch_step, page, distance;
    std::optional<int> bars;
    SheetOptions sheet;
    FilmOptions film; ///< its dpi may also be the printer's
};

void declare(options::options_description& all, PrintOptions& o);

/// A paper by its name, or WIDTHxHEIGHT or WIDTHxroll in mm. Throws UsageError.
Paper parse_paper_size(const std::string& text);

/// The value of --intent. Throws UsageError.
Intent intent_of(const PrintOptions& o);

/// The halftone of --halftone and --levels, if any. Throws UsageError.
std::optional<HalftoneSettings> halftone_of(const PrintOptions& o);

/// The printer's pixel pitch, mm, from --dpi and --feed. Throws UsageError, and as printer_pitch
/// (print/frame_print.h) does.
Vec2 pitch_of_printer(const PrintOptions& o, const Film& film);

/// The page, without the text of its strip. Throws UsageError.
PageRequest page_request(const PrintOptions& o, const Film& film);

/// Whether a page holds several frames.
bool holds_several(const PrintOptions& o);

/// How often --repeat puts each frame on the page; 0: as often as there is room. Throws UsageError.
int repeats_of(const PrintOptions& o);

/// The least distance of frames on one page, mm. Throws UsageError.
double gap_of(const PrintOptions& o);

} // namespace integral

#endif
