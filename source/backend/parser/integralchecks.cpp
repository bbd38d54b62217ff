// SPDX-License-Identifier: AGPL-3.0-or-later
// The part of IntegralGrammar that follows a complete camera statement: it places the sheet,
// reports errors and prints warnings.

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/parser/integralgrammar.h"
#include "backend/parser/parse.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "base/integralframe.h"
#include "base/integraloptions.h"
#include "integral/optics/coverage.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <sstream>
#include <stdexcept>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

void IntegralGrammar::Note_Look_At(Camera& camera)
{
    if ((option || (camera.Integral && camera.Integral->integral)) && camera.Look_At[X] != HUGE_VAL)
    {
        VECTOR to_look_at;
        DBL distance;
        VSub(to_look_at, camera.Look_At, camera.Location);
        VLength(distance, to_look_at);
        Edit(camera).look_at_distance = distance;
    }
}

void IntegralGrammar::Settle(Camera& camera)
{
    const bool integral = camera.Integral && camera.Integral->integral;
    if (!integral && !(option && camera.Type == PERSPECTIVE_CAMERA))
        return;
    IntegralStatement& statement = Edit(camera);
    if (option)
        Apply_Option(statement);
    DBL direction;
    VLength(direction, camera.Direction);
    if (!(direction > 0) || std::isinf(direction))
        parser.Error("An integral camera needs a direction that is finite and not zero; it follows "
                     "from location, look_at "
                     "and direction.");
    const double distance = statement.parameters.sheet_distance
                                ? *statement.parameters.sheet_distance
                            : statement.look_at_distance > 0 ? statement.look_at_distance
                                                             : direction;
    statement.sheet_distance_ratio = distance / direction;
}

/// Gets width and height of the picture from the identifiers that the front end declares in the
/// scene; false if they are not declared.
bool IntegralGrammar::Frame_Size(int& width, int& height)
{
    const auto number = [&](const char *name, int& value)
    {
        const auto found = parser.sceneData->declaredVariables.find(name);
        value = found == parser.sceneData->declaredVariables.end()
                    ? 0
                    : int(std::atof(found->second.c_str()));
        return value > 0;
    };
    return number("image_width", width) & number("image_height", height);
}

void IntegralGrammar::Check(Camera& camera)
{
    if (!camera.Integral || !camera.Integral->integral)
        return;
    if (camera.Integral->sheet_distance_ratio == 0)
        Settle(camera);
    IntegralStatement& statement = Edit(camera);
    if (camera.Type != PERSPECTIVE_CAMERA)
        parser.Error(
            "An integral camera starts from the perspective camera; no other type goes with it.");
    if (camera.Tnormal != NULL)
        parser.Error("A camera normal does not go with an integral camera: it would bend the light "
                     "of all lenses alike.");
    if (option && camera.Aperture != 0 && camera.Blur_Samples > 0)
    {
        parser.Warning(0, "Integral_Camera: the scene's focal blur (aperture, blur_samples) is "
                          "left out: depth is focused by\n"
                          "the eye that looks at the print.");
        camera.Blur_Samples = 0;
    }
    if (camera.Aperture != 0 && camera.Blur_Samples > 0)
        parser.Error("Focal blur (aperture, blur_samples) does not go with an integral camera: its "
                     "depth is focused by "
                     "the eye that looks at the print.");
    for (const char *word : {"lens_sheet", "film"})
        if (!statement.given.count(word))
            parser.Error("An integral camera needs %s { ... }.", word);
    int width, height;
    try
    {
        if (Frame_Size(width, height))
            statement.optics = Make_Integral_Optics(camera, width, height);
    }
    catch (const std::invalid_argument& problem)
    {
        parser.Error("Integral camera: %s.", problem.what());
    }
}

void IntegralGrammar::Finish(Camera& camera)
{
    if (option && !(camera.Integral && camera.Integral->integral))
    {
        if (camera.Type != PERSPECTIVE_CAMERA)
            parser.Error("Integral_Camera applies to a perspective camera, and this scene's is of "
                         "another type.");
        Settle(camera);
        Check(camera);
    }
    const bool integral = camera.Integral && camera.Integral->integral && camera.Integral->optics;
    pov_base::IntegralFrame::Set_Scene(UCS2toASCIIString(parser.sceneData->inputFile));
    pov_base::IntegralFrame::Expect(integral ? camera.Integral->optics.get() : NULL);
    if (!integral)
        return;
    if (!parser.sceneData->integralProblem.empty())
        parser.Error("%s.", parser.sceneData->integralProblem.c_str());
    Warn(camera);
}

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

void IntegralGrammar::Warn(const Camera& camera)
{
    const integral::IntegralCamera& optics = *camera.Integral->optics;
    const integral::Film& film = optics.film;

    DBL right, up;
    VLength(right, camera.Right);
    VLength(up, camera.Up);
    const double wanted = (film.height * film.pixel_pitch.y) / (film.width * film.pixel_pitch.x);
    if (std::fabs(up / right - wanted) > 0.01 * wanted)
        parser.Warning(0,
                       "Integral camera: |up|/|right| is %.4g, but the film's height is %.4g of "
                       "its width, and the\n"
                       "picture keeps the film's. A right of length %.6g beside this up would fit.",
                       up / right, wanted, up / wanted);

    const double pitch = optics.optics.sheet().pitch * optics.placement.units_per_mm;
    if (pitch < 0.05 || pitch > 100)
        parser.Warning(
            0,
            "Integral camera: the lens pitch is %.3g scene units. POV-Ray's tolerances are "
            "absolute, and\n"
            "pixels go wrong outside of 0.05 to 100: make scene and camera about %s.",
            pitch, By_About(optics.optics.sheet().pitch / pitch).c_str());

    const integral::Aperture& aperture = optics.optics.aperture();
    const double film_width = film.width * film.pixel_pitch.x,
                 film_height = film.height * film.pixel_pitch.y,
                 diagonal = std::hypot(film_width, film_height);
    if (aperture.distance < diagonal)
        parser.Warning(0,
                       "Integral camera: the eye is %.4g mm from a picture of %.4g x %.4g mm: "
                       "nearer than its diagonal.\n"
                       "viewing_distance %.0f, for example, moves the eye and leaves the sheet "
                       "where it is.",
                       aperture.distance, film_width, film_height,
                       10 * std::ceil(std::max(300.0, 2 * diagonal) / 10));

    const auto filling = integral::filling_aperture(
        integral::modelled_sheet(optics.optics.sheet(), optics.optics.model()), aperture.distance);
    const auto too_wide = [](double extent, double fills)
    { return fills > 0 && extent > 1.1 * fills; }; // no warning for the length of a slit
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

}
