// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/geometry_options.h"

#include "integral/cli/values.h"
#include "integral/frame/geometry_json.h"
#include "integral/io/image_file.h"
#include "integral/optics/aperture_error.h"
#include "integral/optics/visual_pitch.h"
#include "integral/sheet/known_sheets.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace integral {
namespace {

constexpr double default_distance = 300; // mm; the thesis's (3-8)
constexpr double default_dpi = 300;
constexpr double largest_size = 20000; // mm, of a page or a print
constexpr double longer_side = 152.4;  // mm, of a print: 6 inches

/// A pitch option's value NUMBER or NUMBER@DISTANCE: the latter is what a pitch test finds from
/// that distance.
struct PitchReading {
    double value = 0;
    std::optional<double> distance; ///< mm
};

PitchReading read_pitch(const char* option, const std::string& text)
{
    const std::size_t at = text.find('@');
    const auto value = number_in(text.substr(0, at));
    PitchReading reading{value.value_or(0), std::nullopt};
    if (at != std::string::npos)
        reading.distance = number_in(text.substr(at + 1)).value_or(0);
    if (!(reading.value > 0))
        throw_usage(option, text, "a number greater than 0");
    if (reading.distance && !(*reading.distance >= 1e-2 && *reading.distance <= 1e9))
        throw_usage(option, text, "after @, a distance of 0.01 to 1e9 mm");
    return reading;
}

/// --lpi: sets the pitch, and the other figures of a common sheet with that many lenses per inch.
void set_lpi(const SheetOptions& given, double lpi, LensSheet& sheet)
{
    const auto known = sheet_of_lpi(lpi);
    if (!known && !given.thickness)
        throw UsageError("--lpi " + *given.lpi +
                         ": no common sheet has so many lenses per inch (integral sheet --list); "
                         "give its --thickness MM as well");
    sheet.pitch = mm_per_inch / lpi;
    if (known) {
        sheet.arrangement = known->arrangement;
        sheet.thickness = known->thickness;
        sheet.ior = known->ior;
    }
}

/// Sets the film's pixels for a print of a size in mm and the film's bleed. Throws UsageError with
/// `subject` and `advice` if there are too many.
void set_print_size(Vec2 size, const std::string& subject, const std::string& advice, Film& film)
{
    const double width = (size.x + 2 * film.bleed) / film.pixel_pitch.x,
                 height = (size.y + 2 * film.bleed) / film.pixel_pitch.y;
    if (std::max(width, height) > largest_film_side)
        throw UsageError(subject +
                         " has more than 1000000 pixels across or down at this "
                         "resolution" +
                         advice);
    film.width = std::max(1, int(std::lround(width)));
    film.height = std::max(1, int(std::lround(height)));
}

/// Gives the film the default size of a print of a picture's shape.
void set_default_size(const std::string& picture, Film& film)
{
    const auto [width, height] = picture_size(picture);
    const double scale = longer_side / std::max(width, height);
    set_print_size(scale * Vec2{double(width), double(height)}, picture + ": a print 152.4 mm long",
                   "; give --print or --size", film);
}

} // namespace

void declare(options::options_description& all, SheetOptions& sheet)
{
    add(all, "arrangement", sheet.arrangement, "KIND",
        "lenticular, square or hexagonal (default lenticular)");
    add(all, "pitch", sheet.pitch, "MM[@MM]",
        "width of a lens (default 1.27); as 1.276@400: what a pitch test finds from 400 mm, which "
        "is a little more than the lenses' own");
    add(all, "lpi", sheet.lpi, "N[@MM]",
        "the same as lenses per inch; with 20, 40, 60, 75 and 100 thickness and index are those of "
        "a common sheet, unless given (integral sheet --list)");
    add(all, "thickness", sheet.thickness, "MM",
        "from the lenses' poles to the film (default 3.08)");
    add(all, "ior", sheet.ior, "N", "refractive index of the sheet (default 1.6)");
    add(all, "slant", sheet.slant, "DEGREES",
        "turn of the lenses, anticlockwise as the viewer sees it (default 0)");
    add(all, "offset", sheet.offset, "X,Y",
        "where the lens at index 0,0 is, mm from the sheet's centre");
}

void declare(options::options_description& all, FilmOptions& film)
{
    add(all, "dpi", film.dpi, "D[,D]", "film pixels per inch, across and down (default 300)");
    add(all, "pixel-pitch", film.pixel_pitch, "MM[,MM]", "the same as the width of a pixel");
    add(all, "size", film.size, "WxH", "pixels of the film");
}

void declare(options::options_description& all, ApertureOptions& aperture)
{
    add(all, "distance", aperture.distance, "MM",
        "from the viewer, and the capture aperture, to the sheet (default 300)");
    add(all, "aperture", aperture.aperture, "W[,H]",
        "extent of the capture aperture, mm (default: what fills a lens)");
}

void declare(options::options_description& all, PicturesFrameOptions& frame)
{
    declare(all, frame.sheet);
    declare(all, frame.film);
    add(all, "print", frame.print, "WxH",
        "size of the frame in mm, instead of --size (default: 152.4 on the longer side, of the "
        "first picture's shape)");
    declare(all, frame.aperture);
    declare_start_geometry(all, frame.start);
    add(all, "bits", frame.bits, "N",
        "8 or 16 for PNG and TIFF (default: the highest bit depth of the pictures)");
}

void declare_frame_geometry(options::options_description& all, std::optional<std::string>& file)
{
    add(all, "sheet", file, "FILE.json",
        "geometry for a frame that carries none, or instead of its own");
}

void declare_start_geometry(options::options_description& all, std::optional<std::string>& file)
{
    add(all, "sheet", file, "FILE.json", "start from this geometry: a JSON document, or a frame");
}

const char* first_given(const SheetOptions& sheet)
{
    return first_given({{"arrangement", sheet.arrangement},
                        {"pitch", sheet.pitch},
                        {"lpi", sheet.lpi},
                        {"thickness", sheet.thickness},
                        {"ior", sheet.ior},
                        {"slant", sheet.slant},
                        {"offset", sheet.offset}});
}

FrameMetadata default_geometry()
{
    FrameMetadata geometry;
    geometry.film.pixel_pitch = {mm_per_inch / default_dpi, mm_per_inch / default_dpi};
    geometry.aperture.distance = default_distance;
    return geometry;
}

FrameMetadata given_geometry(const std::optional<std::string>& file, const SheetOptions& sheet,
                             const FilmOptions& film, const std::optional<std::string>& print)
{
    FrameMetadata geometry = file ? read_metadata(*file) : default_geometry();
    change_sheet(sheet, geometry.sheet);
    change_film(film, print, geometry.film);
    check_geometry(geometry);
    return geometry;
}

FrameMetadata geometry_for_pictures(const PicturesFrameOptions& given, const std::string& picture)
{
    FrameMetadata geometry = given_geometry(given.start, given.sheet, given.film, given.print);
    if (geometry.projection)
        throw InputError(*given.start +
                         ": it is for replay through a projection lens, and pictures make "
                         "no frame for that");
    if (geometry.film.bleed > 0) { // pictures end at their edges
        geometry.film.bleed = 0;
        if (given.print)
            set_film_size("print", *given.print, geometry.film);
    }
    if (geometry.film.width < 1)
        set_default_size(picture, geometry.film);
    change_aperture(given.aperture, geometry,
                    given.start && !changes_lenses(given.sheet, given.aperture));
    return geometry;
}

void change_sheet(const SheetOptions& given, LensSheet& sheet)
{
    if (given.lpi && given.pitch)
        throw UsageError("--lpi and --pitch say the same; give one of them");
    PitchReading pitch;
    if (given.pitch) {
        pitch = read_pitch("pitch", *given.pitch);
        sheet.pitch = pitch.value;
    }
    if (given.lpi) {
        pitch = read_pitch("lpi", *given.lpi);
        set_lpi(given, pitch.value, sheet);
    }
    read_kind("arrangement", given.arrangement, sheet.arrangement);
    read_number("thickness", given.thickness, sheet.thickness);
    read_number("ior", given.ior, sheet.ior);
    read_number("slant", given.slant, sheet.slant);
    read_vector("offset", given.offset, sheet.offset);
    if (pitch.distance && sheet.thickness > 0 && sheet.ior >= 1)
        sheet.pitch = pitch_of_visual(sheet.pitch, sheet, *pitch.distance);
}

void change_film(const FilmOptions& given, Film& film)
{
    if (given.dpi && given.pixel_pitch)
        throw UsageError("--dpi and --pixel-pitch say the same; give one of them");
    if (given.dpi) {
        const Vec2 dpi = parse_dpi("dpi", *given.dpi);
        film.pixel_pitch = {mm_per_inch / dpi.x, mm_per_inch / dpi.y};
    }
    if (given.pixel_pitch)
        film.pixel_pitch = parse_one_or_two("pixel-pitch", *given.pixel_pitch, "MM or MM,MM");
    read_size("size", given.size, largest_film_side, film.width, film.height);
}

Vec2 parse_paper_size(const char* option, const std::string& text)
{
    return parse_size_mm(option, text, largest_size);
}

void set_film_size(const char* option, const std::string& text, Film& film)
{
    set_print_size(parse_paper_size(option, text), std::string("--") + option + " " + text + ": it",
                   "", film);
}

void change_film(const FilmOptions& given, const std::optional<std::string>& print, Film& film)
{
    change_film(given, film);
    if (print && given.size)
        throw UsageError("--print and --size say the same; give one of them");
    if (print)
        set_film_size("print", *print, film);
}

void change_aperture(const ApertureOptions& given, FrameMetadata& geometry, bool keep)
{
    Aperture& aperture = geometry.aperture;
    read_number("distance", given.distance, aperture.distance);
    if (!(aperture.distance >= 1e-2 && aperture.distance <= 1e9))
        throw_usage("distance", given.distance.value_or(""), "0.01 to 1e9 mm");
    if (given.aperture) {
        const auto numbers = parse_numbers("aperture", *given.aperture, "W or W,H", 1, 2);
        Vec2 extent{numbers.front(), numbers.back()};
        if (numbers.size() == 1 && geometry.sheet.arrangement == Arrangement::lenticular)
            (slit_is_horizontal(geometry.sheet) ? extent.y : extent.x) = 0; // a slit
        if (!(extent.x >= 0 && extent.y >= 0 && extent.x <= 1e12 && extent.y <= 1e12))
            throw_usage("aperture", *given.aperture, "0 to 1e12 mm");
        aperture.width = extent.x;
        aperture.height = extent.y;
    } else if (!keep) {
        const auto filling = filling_aperture(geometry.sheet, aperture.distance);
        if (!filling)
            throw UsageError("no aperture, however wide, fills these lenses; give --aperture W,H");
        aperture = *filling;
    }
    const std::string error = aperture_error(geometry.sheet, {aperture.width, aperture.height});
    if (!error.empty())
        throw UsageError(error);
}

bool changes_lenses(const SheetOptions& sheet, const ApertureOptions& aperture)
{
    return sheet.arrangement || sheet.pitch || sheet.lpi || sheet.thickness || sheet.ior ||
           sheet.slant || aperture.distance;
}

void check_geometry(const FrameMetadata& geometry)
{
    try {
        check_ranges(geometry.sheet, geometry.film);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

} // namespace integral
