// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/optics/camera_parameters.h"

#include "integral/optics/aperture_error.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace integral {

namespace {

/// Collects complaints of the form "pitch 0 is out of range: ...".
class Complaints {
public:
    void require(bool holds, const char* what, double value, const char* legal)
    {
        if (holds)
            return;
        std::ostringstream text;
        text.precision(10);
        text << what << ' ' << value << " is out of range: " << legal;
        list.push_back(text.str());
    }
    std::vector<std::string> list;
};

bool in(double value, double least, double most) { return value >= least && value <= most; }

// The ranges are a little wider than those for which the optics are proven (optics.md section 7).

void check_sheet(const LensSheet& sheet, Complaints& c)
{
    c.require(in(sheet.pitch, 1e-4, 1e3), "pitch", sheet.pitch,
              "it is the width of a lens, 0.0001 to 1000 mm");
    c.require(in(sheet.thickness, 1e-6, 1e6), "thickness", sheet.thickness,
              "it is the distance from lens to film, 0.000001 to 1000000 mm");
    c.require(in(sheet.ior, 1, 4), "ior", sheet.ior, "it is the sheet's refractive index, 1 to 4");
    c.require(in(std::fabs(sheet.slant), 0, 90), "slant", sheet.slant,
              "it is in degrees, -90 to 90");
    for (const double offset : {sheet.offset.x, sheet.offset.y})
        c.require(in(std::fabs(offset), 0, 1e6), "offset", offset,
                  "it is in mm, at most 1000000 either way");
}

void check_film(const FilmParameters& film, Complaints& c)
{
    for (const double pitch : {film.pixel_pitch.x, film.pixel_pitch.y})
        c.require(in(pitch, 1e-6, 1e4), "film pixel pitch", pitch,
                  "it is 0.000001 to 10000 mm (dpi = 25.4/pitch)");
    for (int cell = 0; cell < film.subpixels.number; ++cell)
        for (const Vec2 place : film.subpixels.cell[cell])
            for (const double part : {place.x, place.y})
                c.require(in(std::fabs(part), 0, 1), "place of a subpixel", part,
                          "it is in pixels from its pixel's centre, -1 to 1");
    c.require(in(film.bleed, 0, 1000), "bleed", film.bleed,
              "it is the width of a margin to cut off, 0 to 1000 mm");
    if (film.units_per_mm)
        c.require(in(*film.units_per_mm, 1e-6, 1e6), "units_per_mm", *film.units_per_mm,
                  "it is in scene units, 0.000001 to 1000000");
}

} // namespace

std::vector<std::string> find_value_errors(const CameraParameters& p)
{
    Complaints c;
    check_sheet(p.sheet, c);
    check_film(p.film, c);
    if (p.sheet_distance)
        c.require(in(*p.sheet_distance, 1e-9, 1e9), "sheet_distance", *p.sheet_distance,
                  "it is in scene units, greater than 0, at most 1e9");
    if (p.viewing_distance)
        c.require(in(*p.viewing_distance, 1e-2, 1e9), "viewing_distance", *p.viewing_distance,
                  "it is in mm from the sheet to the eye, 0.01 to 1e9");
    if (p.parallax)
        c.require(in(*p.parallax, 0, 100), "parallax", *p.parallax,
                  "it is how far the scene's eye moves where the viewer's moves 1 mm, 0 to 100 mm");
    if (p.fit)
        c.require(in(*p.fit, 0.1, 100), "fit", *p.fit,
                  "it is how many depth budgets the scene may reach either side of the sheet, 0.1 to "
                  "100");
    if (p.print_size)
        for (const double extent : {p.print_size->x, p.print_size->y})
            c.require(in(extent, 1e-3, 1e6), "print_size", extent,
                      "the picture's width and height are in mm, 0.001 to 1000000");
    if (p.capture_aperture)
        for (const double extent : {p.capture_aperture->x, p.capture_aperture->y})
            c.require(in(extent, 0, 1e12), "capture_aperture", extent,
                      "its width and height are in mm, 0 to 1e12");
    const char* const samples = "it is a whole number of points, 1 to 65536";
    c.require(in(p.beam_samples.value_or(1), 1, 65536), "beam_samples", p.beam_samples.value_or(1),
              samples);
    c.require(in(p.pixel_samples.value_or(1), 1, 65536), "pixel_samples",
              p.pixel_samples.value_or(1), samples);
    if (p.depth_range) {
        for (const double depth : {p.depth_range->x, p.depth_range->y})
            c.require(in(depth, 0, 1e12), "depth_range", depth,
                      "front and back are in mm, positive");
        if (p.depth_range->x == 0 && p.depth_range->y == 0)
            c.list.push_back("depth_range <0, 0> leaves nothing to be seen: one of front and back "
                             "must be greater than 0");
    }
    if (p.projection_lens) {
        const ProjectionWords& lens = *p.projection_lens;
        c.require(
            in(lens.focal_length, 1e-2, 1e6), "focal length of projection_lens", lens.focal_length,
            "projection_lens is <focal length, distance from the sheet>, each 0.01 to 1000000 "
            "mm");
        c.require(
            in(lens.distance, 1e-2, 1e6) && lens.distance > lens.focal_length,
            "distance of projection_lens", lens.distance,
            "it is in mm from the sheet, greater than the focal length (else the lens projects "
            "no image), at most 1000000");
        for (const double count : {lens.columns, lens.rows})
            c.require(in(count, 1, 1000) && count == std::floor(count),
                      "number of macro-lenses of projection_lens", count,
                      "<focal length, distance, columns, rows> has 1 to 1000 lenses either way");
    }
    return c.list;
}

std::string aperture_error(const LensSheet& sheet, Vec2 extent)
{
    if (sheet.arrangement == Arrangement::lenticular) {
        if (extent_along_slit(sheet, extent) > 0)
            return "";
        return slit_is_horizontal(sheet)
                   ? "the capture aperture of a lenticular sheet needs a width greater than 0: it "
                     "is capture_aperture <width, slit height>"
                   : "the capture aperture of a lenticular sheet slanted by more than 45 degrees "
                     "needs a height greater than 0: it is capture_aperture <slit width, height>";
    }
    return extent.x > 0 && extent.y > 0 ? ""
                                        : "capture_aperture needs a width and a height greater "
                                          "than 0: nothing would be imaged";
}

namespace {

std::string pixels_error(Vec2 print_size, double pixels)
{
    std::ostringstream text;
    text << "print_size <" << print_size.x << ", " << print_size.y << "> mm is " << pixels
         << " pixels of this film across or down; 1 to " << largest_side << " are possible";
    return text.str();
}

/// Size of a picture of print_size with its bleed, mm.
Vec2 film_size(const CameraParameters& p)
{
    return *p.print_size + Vec2{2 * p.film.bleed, 2 * p.film.bleed};
}

/// The sentence for a sheet without the curved surface that the model needs.
std::string surface_error(const LensSheet& sheet, LensModel model)
{
    std::ostringstream text;
    text << "lens_model " << (model == LensModel::hybrid ? "hybrid" : "full")
         << " needs lenses whose surface reaches their edge: "
         << "its radius, thickness*(ior - 1)/ior = " << surface_radius(sheet)
         << " mm, must be at least " << cell_circumradius(sheet)
         << " mm; lens_model extended_pinhole has no such limit";
    return text.str();
}

} // namespace

std::vector<std::string> find_errors(const CameraParameters& p)
{
    auto errors = find_value_errors(p);
    if (!errors.empty())
        return errors;
    if (p.print_size)
        for (const double pixels :
             {film_size(p).x / p.film.pixel_pitch.x, film_size(p).y / p.film.pixel_pitch.y})
            if (!in(pixels, 0.5, largest_side))
                errors.push_back(pixels_error(*p.print_size, pixels));
    if (p.projection_lens && p.film.bleed > 0)
        errors.push_back("a bleed does not work with projection_lens, whose film is not cut: leave "
                         "bleed out of film");
    if (refracts_at_surface(p.model) && !has_surface(p.sheet))
        errors.push_back(surface_error(p.sheet, p.model));
    constexpr double most_rays = 1 << 20;
    if (double(p.pixel_samples.value_or(default_pixel_samples(p))) *
            p.beam_samples.value_or(default_beam_samples(p)) >
        most_rays)
        errors.push_back("pixel_samples times beam_samples are more than 1048576 rays a pixel: no "
                         "computer has the time for that");
    if (p.model == LensModel::hybrid && p.beam_samples)
        errors.push_back("beam_samples does not work with lens_model hybrid, which has 3 or 5 rays "
                         "of its own; lens_model full has as many as beam_samples says");
    if (p.projection_lens && p.sheet.arrangement == Arrangement::lenticular &&
        p.projection_lens->columns * p.projection_lens->rows > 1)
        errors.push_back("several macro-lenses of projection_lens need square or hexagonal lenses: "
                         "a lenticular sheet's light has no one place at which it meets them");
    if (p.projection_lens && p.pseudoscopic)
        errors.push_back("pseudoscopic does not work with projection_lens, whose image is turned "
                         "upside down and in depth by the lens itself");
    if (p.move_eye && !p.viewing_distance)
        errors.push_back("move_eye moves the scene's eye to viewing_distance: add viewing_distance "
                         "and how far from the sheet the eye is, in mm");
    if (p.fit && p.move_eye)
        errors.push_back("fit chooses the scene's depth for an eye that keeps its place, and "
                         "move_eye moves it: leave one of them out");
    if (p.fit && p.sheet_distance && p.parallax)
        errors.push_back("fit has nothing to choose: leave out sheet_distance or parallax");
    if (p.display_prefilter && refracts_at_surface(p.model))
        errors.push_back(
            "display_prefilter is a filter of the ideal beam: it works with lens_model "
            "extended_pinhole or pinhole");
    if (!p.capture_aperture && !filling_aperture(modelled_sheet(p.sheet, p.model), 1))
        errors.push_back(
            "no aperture, however wide, fills these lenses (they are too wide for their thickness "
            "and ior): give capture_aperture <width, height> in mm");
    if (p.capture_aperture) {
        const std::string error = aperture_error(p.sheet, *p.capture_aperture);
        if (!error.empty())
            errors.push_back(error);
    }
    return errors;
}

std::string bleed_error(const Film& film)
{
    const Vec2 left = trimmed_size(film);
    if (film.width < 1 || film.height < 1)
        return "";
    if (left.x >= film.pixel_pitch.x && left.y >= film.pixel_pitch.y)
        return "";
    std::ostringstream text;
    text << "a bleed of " << film.bleed << " mm leaves nothing of a film of " << size_of(film).x
         << " x " << size_of(film).y << " mm: give less bleed, or a larger picture";
    return text.str();
}

PixelSize print_pixels(const CameraParameters& p)
{
    const auto pixels = [](double mm, double pitch) {
        return static_cast<int>(std::lround(std::clamp(mm / pitch, 1.0, double(largest_side))));
    };
    const Vec2 size = film_size(p);
    return {pixels(size.x, p.film.pixel_pitch.x), pixels(size.y, p.film.pixel_pitch.y)};
}

int default_beam_samples(const CameraParameters& p)
{
    const bool slit_has_height = p.sheet.arrangement == Arrangement::lenticular &&
                                 p.capture_aperture &&
                                 extent_across_slit(p.sheet, *p.capture_aperture) > 0;
    return p.model == LensModel::full || (slit_has_height && p.model != LensModel::hybrid) ? 16
           : p.display_prefilter                                                           ? 4
                                                                                           : 1;
}

int default_pixel_samples(const CameraParameters& p) { return p.display_prefilter ? 4 : 1; }

} // namespace integral
