// SPDX-License-Identifier: AGPL-3.0-or-later
// The options that say what a sheet, a film and an aperture are, for every command that has them.
#ifndef INTEGRAL_CLI_GEOMETRY_OPTIONS_H
#define INTEGRAL_CLI_GEOMETRY_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/cli/values.h"
#include "integral/lightfield/names.h"

namespace integral {

constexpr int largest_film_side = 1000000; ///< pixels

struct SheetOptions {
    std::optional<std::string> arrangement, pitch, lpi, thickness, ior, slant, offset;
};

struct FilmOptions {
    std::optional<std::string> dpi, pixel_pitch, size;
};

struct ApertureOptions {
    std::optional<std::string> distance, aperture;
};

void declare(options::options_description& all, SheetOptions& sheet);
void declare(options::options_description& all, FilmOptions& film);
void declare(options::options_description& all, ApertureOptions& aperture);

/// --sheet of commands that read frames: the file whose geometry a frame has that carries none.
void declare_frame_geometry(options::options_description& all, std::optional<std::string>& file);

/// --sheet of commands that make geometry: the file that they start from.
void declare_start_geometry(options::options_description& all, std::optional<std::string>& file);

/// Reads the name of a kind of things (lightfield/names.h), if it was given. Throws UsageError.
template <class Kind>
void read_kind(const char* option, const std::optional<std::string>& text, Kind& kind)
{
    if (!text)
        return;
    const auto named = kind_named<Kind>(*text);
    if (!named)
        refuse(option, *text, legal_names<Kind>());
    kind = *named;
}

/// The name of the first of these options that the line has; none: nullptr.
const char* first_given(const SheetOptions& sheet);

/// Geometry to start from: the thesis's sheet and printer, seen from 300 mm.
FrameMetadata default_geometry();

/// The geometry of a file, or else the one to start from, changed by what the options give. Throws
/// UsageError, also for numbers out of the scene language's range, and InputError.
FrameMetadata given_geometry(const std::optional<std::string>& file, const SheetOptions& sheet,
                             const FilmOptions& film,
                             const std::optional<std::string>& print = std::nullopt);

/// Changes what the options give, and nothing else. Throws UsageError.
void change_sheet(const SheetOptions& given, LensSheet& sheet);
void change_film(const FilmOptions& given, Film& film);
/// The same where --print WxH may give the film's size in mm, instead of --size.
void change_film(const FilmOptions& given, const std::optional<std::string>& print, Film& film);

/// An option's WxH in mm, of a page or a print. Throws UsageError.
Vec2 parse_paper_size(const char* option, const std::string& text);

/// Gives the film the pixels of an option's WxH in mm, at its resolution. Throws UsageError.
void set_film_size(const char* option, const std::string& text, Film& film);

/// Changes the aperture's distance and extent where they are given. An extent that is not given
/// stays as it is if `keep`; else the aperture becomes the one that fills the lenses. Throws
/// UsageError.
void change_aperture(const ApertureOptions& given, FrameMetadata& geometry, bool keep);

/// Whether any option was given that the aperture which fills the lenses depends on.
bool changes_lenses(const SheetOptions& sheet, const ApertureOptions& aperture);

/// Throws UsageError where a number is out of the range that the scene language allows.
void check_geometry(const FrameMetadata& geometry);

} // namespace integral

#endif
