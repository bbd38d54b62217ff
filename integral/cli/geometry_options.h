// SPDX-License-Identifier: AGPL-3.0-or-later
// The options that say what a sheet and a film are, for every command that has them.
#ifndef INTEGRAL_CLI_GEOMETRY_OPTIONS_H
#define INTEGRAL_CLI_GEOMETRY_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/lightfield/frame_metadata.h"

namespace integral {

constexpr int largest_film_side = 1000000; ///< pixels

/// Adds --arrangement, --pitch, --thickness, --ior, --slant and --offset; and --dpi, --pixel-pitch
/// and --size.
void add_sheet_options(options::options_description& all);
void add_film_options(options::options_description& all);

/// Adds --distance and --aperture.
void add_aperture_options(options::options_description& all);

/// Geometry to start from: the thesis's sheet and printer, seen from 300 mm.
FrameMetadata default_geometry();

/// Changes what was given, by options that may be absent from the command. Throws UsageError.
void change_sheet(const options::variables_map& arguments, LensSheet& sheet);
void change_film(const options::variables_map& arguments, Film& film);

/// The aperture: as given, else as the geometry has it if `keep`, else what fills the lens. Throws
/// UsageError.
void change_aperture(const options::variables_map& arguments, FrameMetadata& geometry, bool keep);

/// Whether any option changes what the filling aperture depends on.
bool changes_lenses(const options::variables_map& arguments);

/// Refuses what no camera could have: the ranges are the scene language's. Throws UsageError.
void check_geometry(const FrameMetadata& geometry);

/// Reads an option's number, if it was given, into `value`. Throws UsageError.
void read_number(const options::variables_map& arguments, const char* option, double& value);

} // namespace integral

#endif
