// SPDX-License-Identifier: AGPL-3.0-or-later
// Options that describe a sheet, a film and an aperture, shared by commands.
#ifndef INTEGRAL_CLI_GEOMETRY_OPTIONS_H
#define INTEGRAL_CLI_GEOMETRY_OPTIONS_H

#include "integral/cli/command.h"
#include "integral/cli/values.h"
#include "integral/frame/names.h"

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

/// The frame that a command makes from flat pictures. `start`: the file of --sheet.
struct PicturesFrameOptions {
    SheetOptions sheet;
    FilmOptions film;
    ApertureOptions aperture;
    std::optional<std::string> start, print;
    std::optional<int> bits;
};

void declare(options::options_description& all, SheetOptions& sheet);
void declare(options::options_description& all, FilmOptions& film);
void declare(options::options_description& all, ApertureOptions& aperture);
void declare(options::options_description& all, PicturesFrameOptions& frame);

/// --sheet of commands that read frames: the file with the geometry for a frame that carries none.
void declare_frame_geometry(options::options_description& all, std::optional<std::string>& file);

/// --sheet of commands that make geometry: the file with the geometry to start from.
void declare_start_geometry(options::options_description& all, std::optional<std::string>& file);

/// Reads a keyword (frame/names.h), if given. Throws UsageError.
template <class Kind>
void read_kind(const char* option, const std::optional<std::string>& text, Kind& kind)
{
    if (!text)
        return;
    const auto named = kind_named<Kind>(*text);
    if (!named)
        throw_usage(option, *text, legal_names<Kind>());
    kind = *named;
}

/// The name of the first of these options on the line; nullptr if there is none.
const char* first_given(const SheetOptions& sheet);

/// Default geometry to start from: the thesis's sheet and printer, seen from 300 mm.
FrameMetadata default_geometry();

/// The geometry of a file, or else the default, changed by the options. Throws UsageError, also for
/// numbers outside the scene language's range, and InputError.
FrameMetadata given_geometry(const std::optional<std::string>& file, const SheetOptions& sheet,
                             const FilmOptions& film,
                             const std::optional<std::string>& print = std::nullopt);

/// The geometry of a frame that is made from flat pictures: given_geometry, with its aperture. If
/// nothing gives the film's size, it becomes that of a print, 152.4 mm on the longer side, of the
/// picture's shape. Throws as given_geometry does, and for a geometry with a projection lens.
FrameMetadata geometry_for_pictures(const PicturesFrameOptions& given, const std::string& picture);

/// Changes only what the options give. Throws UsageError.
void change_sheet(const SheetOptions& given, LensSheet& sheet);
void change_film(const FilmOptions& given, Film& film);
/// The same for a command whose --print WxH may give the film's size in mm instead of --size.
void change_film(const FilmOptions& given, const std::optional<std::string>& print, Film& film);

/// Parses an option's WxH: the size of a page or a print, mm. Throws UsageError.
Vec2 parse_paper_size(const char* option, const std::string& text);

/// Sets the film's pixel counts from its pixel pitch and an option's WxH in mm. Throws UsageError.
void set_film_size(const char* option, const std::string& text, Film& film);

/// Changes the aperture's distance and extent if given. Without a given extent, the old one stays
/// if `keep`; otherwise the aperture is set to fill the lenses. Throws UsageError.
void change_aperture(const ApertureOptions& given, FrameMetadata& geometry, bool keep);

/// Whether an option was given that changes which aperture fills the lenses.
bool changes_lenses(const SheetOptions& sheet, const ApertureOptions& aperture);

/// Throws UsageError if a number is outside the range of the scene language.
void check_geometry(const FrameMetadata& geometry);

} // namespace integral

#endif
