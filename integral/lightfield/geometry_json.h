// SPDX-License-Identifier: AGPL-3.0-or-later
// Sheet, film and aperture as JSON objects: of a frame's document, and of what else describes them.
#ifndef INTEGRAL_LIGHTFIELD_GEOMETRY_JSON_H
#define INTEGRAL_LIGHTFIELD_GEOMETRY_JSON_H

#include "integral/base/json_fields.h"
#include "integral/lightfield/names.h"

namespace integral {

constexpr int largest_side = 1000000;                           // pixels
constexpr double least_distance = 1e-2, largest_distance = 1e9; // mm, as make_camera allows
constexpr double largest_extent = 1e30;                         // mm; an aperture's

/// arrangement, pitch_mm, thickness_mm, ior, and if they are there slant_degrees and offset_mm. The
/// pitch may be in a field of another name.
LensSheet sheet_from(const JsonObject& object, const char* pitch_field = "pitch_mm");

/// What pixel_pitch_mm may be: a list of two numbers, or one number for both, too.
enum class PitchForm { pair, number_or_pair };

/// pixel_pitch_mm, and if they are there width and height, subpixels.
Film film_from(const JsonObject& object, PitchForm form = PitchForm::pair);

/// The field subpixels: a word for stripes, or an object of pattern and cells.
Subpixels subpixels_from(const JsonObject& film);

/// distance_mm, and if they are there width_mm, height_mm (null: no limit) and shape. Extents that
/// are absent are those that fill the lens on the axis, or none where nothing does.
Aperture aperture_from(const JsonObject& object, const LensSheet& sheet);

/// The aperture at a distance which fills the lens on the axis, or without limits where none does.
Aperture default_aperture(const LensSheet& sheet, double distance);

/// The ranges of sheet and film are the scene language's: one list of them, in find_value_errors.
void check_ranges(const LensSheet& sheet, const Film& film);

/// Their inverses.
Json json_of(const LensSheet& sheet);
Json json_of(const Film& film);
Json json_of(const Subpixels& subpixels);
Json json_of(const Aperture& aperture);

/// A field that is a list of two numbers in [least, greatest].
Vec2 vec2_at(const JsonObject& object, const char* field, double least, double greatest);
Json list(Vec2 v);

/// A field that is one of the words for the kinds of something.
template <class Kind> Kind kind_at(const JsonObject& object, const char* field)
{
    const auto kind = kind_named<Kind>(string_at(object, field));
    if (!kind)
        refuse(object.path_of(field), "must be " + legal_names<Kind>());
    return *kind;
}

} // namespace integral

#endif
