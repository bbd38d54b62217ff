// SPDX-License-Identifier: AGPL-3.0-or-later
// What the options of `integral print` say of a page.
#ifndef INTEGRAL_CLI_PRINT_OPTIONS_H
#define INTEGRAL_CLI_PRINT_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/output/colour_profile.h"
#include "integral/output/page.h"

namespace integral {

/// The printer's own pixel pitch, mm: --dpi and --feed. Refuses, by UsageError, to print a film of
/// other pixels than the printer's.
Vec2 printer_pitch(const options::variables_map& arguments, const Film& film);

/// A paper by its name, or WIDTHxHEIGHT in mm. Throws UsageError.
Paper parse_paper_size(const std::string& text);

/// --paper, --orientation, --centre, --bleed, --marks, --mirror, --tile and --overlap; the strip is
/// left empty. Throws UsageError.
PageRequest parse_request(const options::variables_map& arguments, const Film& film);

/// --intent. Throws UsageError.
Intent parse_intent(const options::variables_map& arguments);

} // namespace integral

#endif
