// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads and writes sheet, film and aperture as JSON objects, for frame documents and other files
// that describe them.
#ifndef INTEGRAL_FRAME_GEOMETRY_JSON_H
#define INTEGRAL_FRAME_GEOMETRY_JSON_H

#include "integral/base/json_fields.h"
#include "integral/frame/names.h"

namespace integral {

constexpr double least_distance = 1e-2, largest_distance = 1e9; // mm, as make_camera allows
constexpr double largest_extent = 1e30;                         // mm, of an aperture

/// Fields: arrangement, pitch_mm, thickness_mm, ior; optional: slant_degrees, offset_mm. The pitch
/// may be in a field of another name.
LensSheet sheet_from(const JsonObject& object, const char* pitch_field = "pitch_mm");

/// The same, but micro_image_pitch_mm may replace pitch_mm: the pitch as seen from `distance` (mm;
/// nothing: not known), from which the lens pitch follows.
LensSheet sheet_seen_from(const JsonObject& object, std::optional<double> distance);

/// Legal forms of pixel_pitch_mm: only a list of two numbers, or also one number for both
/// directions.
enum class PitchForm { pair, number_or_pair };

/// Fields: pixel_pitch_mm; optional: width and height, subpixels.
Film film_from(const JsonObject& object, PitchForm form = PitchForm::pair);

/// Reads the field subpixels: a word for stripes, or an object with pattern and cells.
Subpixels subpixels_from(const JsonObject& film);

/// Fields: distance_mm; optional: width_mm, height_mm (null: no limit) and shape. An absent extent
/// is the one whose image fills the lens on the axis, or no limit if no extent does.
Aperture aperture_from(const JsonObject& object, const LensSheet& sheet);

/// The aperture at a distance (mm) whose image fills the lens on the axis; without limits if no
/// aperture's image does.
Aperture default_aperture(const LensSheet& sheet, double distance);

/// Default viewing distance (mm) of a screen of `size` (mm): 2.5 times the screen's diagonal.
double nominal_viewing_distance(Vec2 size);

/// Throws unless sheet and film are within the scene language's ranges (find_value_errors).
void check_ranges(const LensSheet& sheet, const Film& film);

/// Inverses of the functions above.
Json json_of(const LensSheet& sheet);
Json json_of(const Film& film);
Json json_of(const Subpixels& subpixels);
Json json_of(const Aperture& aperture);

/// A field that is a list of two numbers in [least, greatest].
Vec2 vec2_at(const JsonObject& object, const char* field, double least, double greatest);
Json list(Vec2 v);

/// A field whose value is one of the words of the enumeration Kind (names.h).
template <class Kind> Kind kind_at(const JsonObject& object, const char* field)
{
    const auto kind = kind_named<Kind>(string_at(object, field));
    if (!kind)
        throw_field_error(object.path_of(field), "must be " + legal_names<Kind>());
    return *kind;
}

} // namespace integral

#endif
