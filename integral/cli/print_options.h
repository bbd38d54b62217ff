// SPDX-License-Identifier: AGPL-3.0-or-later
// The options of `integral print`, and what they say of a page.
#ifndef INTEGRAL_CLI_PRINT_OPTIONS_H
#define INTEGRAL_CLI_PRINT_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/cli/geometry_options.h"
#include "integral/output/frame_print.h"

namespace integral {

struct PrintOptions : CommonOptions {
    std::optional<std::string> output;
    std::optional<std::string> start; ///< --sheet: the file that the geometry comes from
    // Frames:
    std::optional<std::string> paper, orientation, feed, centre, bleed, marks, overlap, icc, intent;
    std::optional<int> bits;
    bool strip = false, mirror = false, tile = false;
    // Printers:
    std::optional<std::string> printer, medium;
    std::optional<int> copies;
    std::optional<Words> printer_options;
    // Charts:
    bool chart = false, keep_index = false, json = false;
    std::optional<Words> even;
    std::optional<std::string> pitch_range, pitch_step, page;
    std::optional<int> bars;
    SheetOptions sheet;
    FilmOptions film; ///< its dpi is a printer's, too
};

void declare(options::options_description& all, PrintOptions& o);

/// A paper by its name, or WIDTHxHEIGHT in mm. Throws UsageError.
Paper parse_paper_size(const std::string& text);

/// The value of --intent. Throws UsageError.
Intent intent_of(const PrintOptions& o);

/// The printer's own pixel pitch, mm, by --dpi and --feed. Throws UsageError, and as printer_pitch
/// (output/frame_print.h) does.
Vec2 pitch_of_printer(const PrintOptions& o, const Film& film);

/// The page, without the text of its strip. Throws UsageError.
PageRequest page_request(const PrintOptions& o, const Film& film);

} // namespace integral

#endif
