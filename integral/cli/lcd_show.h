// SPDX-License-Identifier: AGPL-3.0-or-later
// The part of integral lcd that brings pictures to a display: --list-displays, --show and --play.
#ifndef INTEGRAL_CLI_LCD_SHOW_H
#define INTEGRAL_CLI_LCD_SHOW_H

#include "integral/cli/command.h"
#include "integral/lightfield/image.h"

namespace integral {

void add_show_options(options::options_description& all);

/// Throws UsageError where the options of showing make no sense together, or with so many inputs;
/// for before any work.
void check_show_options(const options::variables_map& arguments, int inputs);

/// Each of these does its work and returns an ExitStatus, or throws: OutputError where no display
/// takes a picture as it is.
int list_displays(const options::variables_map& arguments);

/// Shows a picture until the user ends it. `name` is how messages call it.
int show_picture(const options::variables_map& arguments, const Image& picture,
                 const std::string& name);

/// Plays picture files, all of one size, and prints how that went.
int play_files(const options::variables_map& arguments, const std::vector<std::string>& files);

} // namespace integral

#endif
