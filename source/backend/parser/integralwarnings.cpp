// SPDX-License-Identifier: AGPL-3.0-or-later
// The part of IntegralGrammar that warns of a camera which works but may not do what its user
// intends.

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/parser/integralgrammar.h"
#include "backend/parser/parse.h"
#include "backend/render/integralprobes.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "integral/base/number_text.h"
#include "integral/optics/coverage.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

/// "20 times as large", or "20 times as small": a factor to one digit, in words.
static std::string By_About(double factor)
{
    const double times = factor < 1 ? 1 / factor : factor;
    const double digit = std::pow(10.0, std::floor(std::log10(times)));
    std::ostringstream text;
    text << std::fixed << std::setprecision(0) << std::round(times / digit) * digit
         << (factor < 1 ? " times as small" : " times as large");
    return text.str();
}

void IntegralGrammar::Warn(const Camera& camera, const std::vector<double>& distances)
{
    Warn_Of_Shape(camera);
    Warn_Of_Scale(*camera.Integral->optics);
    Warn_Of_Eye(*camera.Integral);
    if (!parser.sceneData->integral->quilt)
    {
        Warn_Of_Film(*camera.Integral->optics);
        Warn_Of_Draft(*camera.Integral);
    }
    Warn_Of_Starts(*camera.Integral->optics);
    Warn_Of_Infinity(*camera.Integral->optics, distances);
    Warn_Of_Place(camera, distances);
}

void IntegralGrammar::Warn_Of_Shape(const Camera& camera)
{
    const integral::Vec2 size = trimmed_size(camera.Integral->optics->film);
    DBL right, up;
    VLength(right, camera.Right);
    VLength(up, camera.Up);
    const double requested = size.y / size.x;
    if (!(std::fabs(up / right - requested) > 0.01 * requested))
        return;
    std::ostringstream print_size;
    if (camera.Integral->parameters.print_size)
        print_size << std::setprecision(4) << "; or print_size <" << size.x << ", "
                   << size.x * up / right << ">";
    parser.Warning(0,
                   "Integral camera: |up|/|right| is %.4g, but the film's height is %.4g of "
                   "its width, and the\n"
                   "picture keeps the film's. A right of length %.6g beside this up would fit%s.",
                   up / right, requested, up / requested, print_size.str().c_str());
}

void IntegralGrammar::Warn_Of_Scale(const integral::IntegralCamera& optics)
{
    const double pitch = optics.optics.sheet().pitch * optics.placement.units_per_mm;
    if (pitch < 0.002 || pitch > 10000)
        parser.Warning(
            0,
            "Integral camera: the lens pitch is %s scene units. POV-Ray's tolerances are "
            "absolute, and\n"
            "pixels go wrong outside of 0.002 to 10000: make scene and camera about %s.",
            (pitch < 1000 ? integral::with_digits(pitch, 3) : integral::with_decimals(pitch, 0))
                .c_str(),
            By_About(optics.optics.sheet().pitch / pitch).c_str());
}

void IntegralGrammar::Warn_Of_Eye(const IntegralStatement& statement)
{
    const integral::IntegralCamera& optics = *statement.optics;
    const integral::Vec2 size = size_of(optics.film);
    if (optics.projection)
        return;
    const double distance = optics.optics.aperture().distance,
                 diagonal = std::hypot(size.x, size.y), panels = 2.5 * diagonal;
    const bool is_panel = optics.film.subpixels != integral::Subpixels::none;
    if (is_panel && !statement.parameters.viewing_distance &&
        !(distance > panels / 2 && distance < panels * 2))
        parser.Warning(0,
                       "Integral camera: the eye is %.4g mm from a panel of %.4g x %.4g mm, which "
                       "is looked at from about %.0f mm.\n"
                       "Give viewing_distance: `integral lcd --panel NAME --camera` says the "
                       "panel's.",
                       distance, size.x, size.y, panels);
    else if (distance < diagonal)
        parser.Warning(0,
                       "Integral camera: the eye is %.4g mm from a picture of %.4g x %.4g mm: "
                       "nearer than its diagonal.\n"
                       "viewing_distance %.0f, for example, keeps this picture and shows it to an "
                       "eye there.",
                       distance, size.x, size.y,
                       10 * std::ceil(std::max(300.0, 2 * diagonal) / 10));
}

void IntegralGrammar::Warn_Of_Film(const integral::IntegralCamera& optics)
{
    const integral::Aperture& aperture = optics.optics.aperture();
    const auto filling = integral::filling_aperture(
        integral::modelled_sheet(optics.optics.sheet(), optics.optics.model()), aperture.distance);
    const auto too_wide = [](double extent, double fills)
    { return fills > 0 && extent > 1.1 * fills; }; // a slit may have any length
    if (filling &&
        (too_wide(aperture.width, filling->width) || too_wide(aperture.height, filling->height)))
        parser.Warning(
            0,
            "Integral camera: capture_aperture <%.4g, %.4g> is wider than the <%.4g, %.4g> mm that "
            "fill a lens:\n"
            "what its edges see stands behind the neighbouring lenses, and is seen double.",
            aperture.width, aperture.height, filling->width, filling->height);

    const integral::Coverage part = integral::coverage(optics, 20000);
    if (part.imaged == 0)
        parser.Warning(0, "Integral camera: nothing will be imaged: every film point misses the "
                          "capture aperture.");
    else if (part.imaged < (optics.mapping == integral::LensMapping::closest ? 0.99 : 0.9))
        parser.Warning(0,
                       "Integral camera: about %.0f%% of the film will stay empty (%.0f%% misses "
                       "the capture aperture,\n"
                       "%.0f%% is totally reflected)%s.",
                       100 * (part.outside_aperture + part.total_reflection),
                       100 * part.outside_aperture, 100 * part.total_reflection,
                       optics.mapping == integral::LensMapping::closest
                           ? "; lens_mapping auto would lose less"
                           : "");
}

void IntegralGrammar::Warn_Of_Draft(const IntegralStatement& statement)
{
    constexpr double least = 4; // with fewer pixels a lens, parts of the picture show different views
    const integral::IntegralCamera& optics = *statement.optics;
    const integral::Vec2 pixel = optics.film.pixel_pitch;
    const double pixels = optics.optics.sheet().pitch / std::max(pixel.x, pixel.y);
    if (statement.draft == 1 || pixels >= least)
        return;
    const int better = std::max(1, int(std::floor(pixels * statement.draft / least)));
    parser.Warning(0,
                   "Integral camera: Integral_Draft=%d leaves %.1f pixels a lens, which is too few "
                   "views to judge depth\nby: the picture breaks up. Integral_Draft=%d leaves "
                   "%.1f.",
                   statement.draft, pixels, better, pixels * statement.draft / better);
}

void IntegralGrammar::Warn_Of_Starts(const integral::IntegralCamera& optics)
{
    const ApertureObstruction starts = Probe_Integral_Starts(optics, *parser.sceneData,
                                                        parser.GetParserDataPtr());
    if (starts.blocked_share < 0.01)
        return;
    const integral::Aperture& aperture = optics.optics.aperture();
    const double factor = optics.parallax ? optics.parallax->factor : 1,
                 k = factor * optics.placement.units_per_mm, smaller = starts.clear;
    std::ostringstream help;
    help << std::setprecision(3);
    if (smaller > 0.1)
        help << "capture_aperture <" << smaller * aperture.width << ", "
             << smaller * aperture.height << "> keeps them out, and so does parallax "
             << smaller * factor << "; or move location away from them";
    else
        help << "Move location away from them";
    parser.Warning(0,
                   "Integral camera: %.0f%% of the rays start below the ground or inside of "
                   "things, and views from there\n"
                   "flicker: the capture aperture, %.3g x %.3g scene units around the eye, "
                   "reaches into them.\n%s.",
                   100 * starts.blocked_share, k * aperture.width, k * aperture.height,
                   help.str().c_str());
}

/// Warns if a parallax over 1 moves surfaces so far back that a viewer's two lines of sight to them diverge
/// ("beyond infinity"). `distances`: the result of Probe_Integral_Depths.
void IntegralGrammar::Warn_Of_Infinity(const integral::IntegralCamera& optics,
                                       const std::vector<double>& distances)
{
    constexpr double few = 0.01;
    if (!optics.parallax || !(optics.parallax->factor > 1))
        return;
    const double k = optics.parallax->factor, infinity = optics.parallax->scene_distance *
                                                         optics.placement.units_per_mm * k /
                                                         (k - 1);
    const auto part = [&](auto counts)
    { return double(std::count_if(distances.begin(), distances.end(), counts)); };
    const double surfaces = part([](double distance) { return distance < HUGE_VAL; }),
                 beyond = part([&](double distance)
                               { return distance >= infinity && distance < HUGE_VAL; });
    if (surfaces > 0 && beyond > few * surfaces)
        parser.Warning(
            0,
            "Integral camera: parallax %.3g puts %.0f%% of the picture's surfaces beyond "
            "the viewer's infinity, where\nno two eyes can see them as one: all that is "
            "%.4g scene units or more from the camera. A parallax of\nat most 1 brings "
            "them back.",
            k, 100 * beyond / surfaces, infinity);
}

/// Warns of an eye that was moved behind surfaces, and of a sheet whose place follows from the
/// length of direction and is far from all visible surfaces. `distances`: the result of
/// Probe_Integral_Depths.
void IntegralGrammar::Warn_Of_Place(const Camera& camera, std::vector<double> distances)
{
    const IntegralStatement& statement = *camera.Integral;
    const integral::CameraParameters& given = statement.parameters;
    const integral::IntegralCamera& optics = *statement.optics;
    const double k = optics.placement.units_per_mm, eye = viewer_distance(optics),
                 own = Integral_Scene_Distance(camera);
    const bool moved_back = given.move_eye && eye > 1.01 * own,
               placed = statement.look_at_distance > 0 || given.sheet_distance || given.fit;
    if (optics.projection || optics.pseudoscopic || (!moved_back && placed))
        return;
    std::sort(distances.begin(), distances.end());
    const auto number_below = [&](double distance)
    {
        return double(std::lower_bound(distances.begin(), distances.end(), distance) -
                      distances.begin());
    };
    const double hidden = number_below(k * (eye - own)), seen = number_below(HUGE_VAL);
    if (moved_back && hidden > 0.5 * distances.size())
        parser.Warning(0,
                       "Integral camera: %.0f%% of the rays meet a surface between the eye and the "
                       "scene's own camera:\nmove_eye has moved the eye from %.4g to %.4g "
                       "scene units before the sheet, perhaps out of a room.\n"
                       "viewing_distance %s keeps it in; without move_eye the scene's own picture "
                       "is seen.",
                       100 * hidden / distances.size(), k * own, k * eye,
                       integral::with_digits(own, 4).c_str());
    const auto near = [&](double distance) { return std::fabs(distance - k * own) < 0.5 * k * own; };
    if (!placed && seen > 0 && std::none_of(distances.begin(), distances.end(), near))
    {
        const double middle = distances[std::size_t(seen / 2)];
        parser.Warning(0,
                       "Integral camera: no surface is near the sheet, which is %.4g scene units "
                       "from the camera,\nas far as direction is long: most of them are near %.4g, "
                       "and none will be sharp. look_at, or\n"
                       "sheet_distance %s, places the sheet there%s.",
                       k * own, middle, integral::with_digits(middle, 3).c_str(),
                       statement.orthographic ? "" : "; Integral_Fit=on finds the place");
    }
}

}
