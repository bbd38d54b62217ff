// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/sheet/camera_words.h"

#include "integral/base/json.h"
#include "integral/base/number_text.h"
#include "integral/frame/names.h"

#include <cmath>

namespace integral {
namespace {

std::string number_word(double value) { return Json(value).dump(); }
std::string vector_word(Vec2 v) { return "<" + number_word(v.x) + ", " + number_word(v.y) + ">"; }

std::string words_of(const Subpixels& subpixels)
{
    if (subpixels != Subpixels::cells)
        return name_of(subpixels.order);
    std::string words = std::string("cells { ") + name_of(subpixels.pattern);
    for (int k = 0; k < subpixels.number; ++k)
        for (const Vec2 place : subpixels.cell[k])
            words += " " + vector_word(place);
    return words + " }";
}

/// The dots per inch of a pixel pitch, if a whole number gives exactly this pitch.
std::optional<int> whole_dpi(double pitch)
{
    const double dpi = std::round(mm_per_inch / pitch);
    if (!(dpi >= 1 && dpi <= 1e6 && mm_per_inch / dpi == pitch))
        return std::nullopt;
    return int(dpi);
}

bool fills_lenses(const Aperture& aperture, const LensSheet& sheet)
{
    const auto filling = filling_aperture(sheet, aperture.distance);
    return filling && aperture.width == filling->width && aperture.height == filling->height &&
           aperture.shape == filling->shape;
}

} // namespace

std::string sheet_words(const LensSheet& sheet)
{
    std::string words = std::string("lens_sheet { ") + name_of(sheet.arrangement) + " pitch " +
                        number_word(sheet.pitch) + " thickness " + number_word(sheet.thickness) +
                        " ior " + number_word(sheet.ior);
    if (sheet.slant != 0)
        words += " slant " + number_word(sheet.slant);
    if (sheet.offset.x != 0 || sheet.offset.y != 0)
        words += " offset " + vector_word(sheet.offset);
    return words + " }";
}

std::string film_words(const Film& film)
{
    const auto across = whole_dpi(film.pixel_pitch.x), down = whole_dpi(film.pixel_pitch.y);
    std::string words = "film { ";
    if (!across || !down)
        words += "pixel_pitch " + vector_word(film.pixel_pitch);
    else if (*across == *down)
        words += "dpi " + std::to_string(*across);
    else
        words += "dpi <" + std::to_string(*across) + ", " + std::to_string(*down) + ">";
    if (film.subpixels != Subpixels::none)
        words += " subpixels " + words_of(film.subpixels);
    if (film.bleed > 0)
        words += " bleed " + number_word(film.bleed);
    return words + " }";
}

std::string fit_words(double part) { return "fit " + with_digits(2 * part, 9); }

std::string camera_words(const FrameMetadata& geometry)
{
    const Aperture& aperture = geometry.aperture;
    std::string words = sheet_words(geometry.sheet) + " " + film_words(geometry.film);
    if (!fills_lenses(aperture, geometry.sheet) && std::isfinite(aperture.width) &&
        std::isfinite(aperture.height)) {
        words += " capture_aperture " + vector_word({aperture.width, aperture.height});
        if (aperture.shape != ApertureShape::rectangle)
            words += std::string(" aperture_shape ") + name_of(aperture.shape);
    }
    return words + " viewing_distance " + number_word(aperture.distance);
}

} // namespace integral
