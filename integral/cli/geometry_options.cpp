// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/cli/geometry_options.h"

#include "integral/cli/values.h"
#include "integral/lightfield/names.h"

namespace integral {
namespace {

constexpr double default_distance = 300; // mm; the thesis's (3-8)
constexpr double default_dpi = 300;

options::typed_value<std::string>* value(const char* name)
{
    return options::value<std::string>()->value_name(name);
}

} // namespace

void add_sheet_options(options::options_description& all)
{
    all.add_options()("arrangement", value("KIND"),
                      "lenticular, square or hexagonal (default lenticular)")(
        "pitch", value("MM"), "width of a lens (default 1.27)")(
        "thickness", value("MM"), "from the lenses' poles to the film (default 3.08)")(
        "ior", value("N"), "refractive index of the sheet (default 1.6)")(
        "slant", value("DEGREES"),
        "turn of the lenses, anticlockwise as the viewer sees it (default 0)")(
        "offset", value("X,Y"), "where the lens at index 0,0 is, mm from the sheet's centre");
}

void add_film_options(options::options_description& all)
{
    all.add_options()("dpi", value("D[,D]"), "film pixels per inch, across and down (default 300)")(
        "pixel-pitch", value("MM[,MM]"), "the same as the width of a pixel")("size", value("WxH"),
                                                                             "pixels of the film");
}

void add_aperture_options(options::options_description& all)
{
    all.add_options()("distance", value("MM"),
                      "from the viewer, and the capture aperture, to the sheet (default 300)")(
        "aperture", value("W[,H]"),
        "extent of the capture aperture, mm (default: what fills a lens)");
}

FrameMetadata default_geometry()
{
    FrameMetadata geometry;
    geometry.film.pixel_pitch = {mm_per_inch / default_dpi, mm_per_inch / default_dpi};
    geometry.aperture.distance = default_distance;
    return geometry;
}

void read_number(const options::variables_map& arguments, const char* option, double& value)
{
    if (given(arguments, option))
        value = parse_number(option, text_of(arguments, option), "a number");
}

void change_sheet(const options::variables_map& arguments, LensSheet& sheet)
{
    if (given(arguments, "arrangement")) {
        const std::string word = text_of(arguments, "arrangement");
        const auto kind = kind_named<Arrangement>(word);
        if (!kind)
            throw UsageError("--arrangement " + word + ": " + legal_names<Arrangement>() +
                             " is expected");
        sheet.arrangement = *kind;
    }
    read_number(arguments, "pitch", sheet.pitch);
    read_number(arguments, "thickness", sheet.thickness);
    read_number(arguments, "ior", sheet.ior);
    read_number(arguments, "slant", sheet.slant);
    if (given(arguments, "offset")) {
        const auto v = parse_numbers("offset", text_of(arguments, "offset"), "X,Y", 2, 2);
        sheet.offset = {v[0], v[1]};
    }
}

void change_film(const options::variables_map& arguments, Film& film)
{
    if (given(arguments, "dpi") && given(arguments, "pixel-pitch"))
        throw UsageError("--dpi and --pixel-pitch say the same; give one of them");
    if (given(arguments, "dpi")) {
        const Vec2 dpi = parse_one_or_two("dpi", text_of(arguments, "dpi"), "D or D,D");
        if (!(dpi.x > 0 && dpi.y > 0))
            throw UsageError("--dpi " + text_of(arguments, "dpi") + ": it must be greater than 0");
        film.pixel_pitch = {mm_per_inch / dpi.x, mm_per_inch / dpi.y};
    }
    if (given(arguments, "pixel-pitch"))
        film.pixel_pitch = parse_one_or_two("pixel-pitch", text_of(arguments, "pixel-pitch"),
                                            "MM or MM,MM");
    if (given(arguments, "size")) {
        const PixelSize size = parse_size("size", text_of(arguments, "size"), largest_film_side);
        film.width = size.width;
        film.height = size.height;
    }
}

void change_aperture(const options::variables_map& arguments, FrameMetadata& geometry, bool keep)
{
    Aperture& aperture = geometry.aperture;
    read_number(arguments, "distance", aperture.distance);
    if (!(aperture.distance >= 1e-2 && aperture.distance <= 1e9))
        throw UsageError("--distance " + text_of(arguments, "distance") +
                         ": 0.01 to 1e9 mm is expected");
    if (given(arguments, "aperture")) {
        const auto numbers = parse_numbers("aperture", text_of(arguments, "aperture"), "W or W,H",
                                           1, 2);
        Vec2 extent{numbers.front(), numbers.back()};
        if (numbers.size() == 1 && geometry.sheet.arrangement == Arrangement::lenticular)
            (slit_is_horizontal(geometry.sheet) ? extent.y : extent.x) = 0; // a slit
        if (!(extent.x >= 0 && extent.y >= 0 && extent.x <= 1e12 && extent.y <= 1e12))
            throw UsageError("--aperture " + text_of(arguments, "aperture") +
                             ": 0 to 1e12 mm is expected");
        aperture.width = extent.x;
        aperture.height = extent.y;
    } else if (!keep) {
        const auto filling = filling_aperture(geometry.sheet, aperture.distance);
        if (!filling)
            throw UsageError("no aperture, however wide, fills these lenses; give --aperture W,H");
        aperture = *filling;
    }
}

bool changes_lenses(const options::variables_map& arguments)
{
    for (const char* option : {"arrangement", "pitch", "thickness", "ior", "slant", "distance"})
        if (given(arguments, option))
            return true;
    return false;
}

void check_geometry(const FrameMetadata& geometry)
{
    CameraParameters parameters;
    parameters.sheet = geometry.sheet;
    parameters.film.pixel_pitch = geometry.film.pixel_pitch;
    const auto errors = find_value_errors(parameters);
    if (!errors.empty())
        throw UsageError(errors.front());
}

} // namespace integral
