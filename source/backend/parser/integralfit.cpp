// SPDX-License-Identifier: AGPL-3.0-or-later
// The part of IntegralGrammar that fits a scene's depth to its sheet (Integral_Fit=), and warns of a
// depth that the sheet cannot show.

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/parser/integralgrammar.h"
#include "backend/parser/parse.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "base/integralframe.h"
#include "base/integraloptions.h"
#include "integral/base/number_text.h"
#include "integral/sheet/scene_fit.h"
#include "integral/sheet/sheet_report.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

/// The camera's sheet and parallax as a fit; the sheet's distance in scene units.
integral::SceneFit Fit_Of(const integral::IntegralCamera& optics)
{
    const double factor = optics.parallax ? optics.parallax->factor : 1,
                 scene = optics.parallax ? optics.parallax->scene_distance
                                         : viewer_distance(optics);
    return {scene * optics.placement.units_per_mm, factor};
}

/// Returns the fit of the print's camera to the depth `allowed`, mm. With units_per_mm and without
/// viewing_distance, the viewer's eye is the scene's eye: its distance in mm is proportional to the sheet's
/// distance, so that the fit is iterated.
integral::SceneFit Choose(const integral::DepthEnds& ends, const IntegralStatement& statement,
                          const integral::IntegralCamera& optics, double allowed)
{
    constexpr int rounds = 100;
    const integral::CameraParameters& given = statement.parameters;
    integral::FitRequest request;
    if (given.sheet_distance || statement.orthographic)
        request.sheet_distance = Fit_Of(optics).sheet_distance;
    request.parallax = given.parallax;
    request.beta = allowed / viewer_distance(optics);
    integral::SceneFit fit = integral::fit_to_budget(ends, request);
    if (given.film.units_per_mm && !given.viewing_distance)
        for (int round = 0; round < rounds; round++)
        {
            request.beta = allowed * *given.film.units_per_mm / fit.sheet_distance;
            const double next = integral::fit_to_budget(ends, request).sheet_distance;
            fit = {0.5 * (fit.sheet_distance + next), fit.parallax};
        }
    return {fit.sheet_distance, integral::fit_to_budget(ends, request).parallax};
}

/// The fit of an animation's first frame, used for all its frames.
struct AnimationFit
{
    std::string scene;
    double budgets = 0;
    std::optional<integral::SceneFit> fit;
};
AnimationFit animation_fit;

}

/// `print`: the print's camera, not a draft's. `distances`: the result of Probe_Integral_Depths.
void IntegralGrammar::Fit_Depth(Camera& camera, const integral::IntegralCamera& print,
                                const std::vector<double>& distances)
{
    constexpr double beyond = 2; // in depth budgets
    IntegralStatement& statement = Edit(camera);
    const auto declared = [&](const char *name)
    {
        const auto found = parser.sceneData->declaredVariables.find(name);
        return found == parser.sceneData->declaredVariables.end() ? 0.0
                                                                  : std::atof(found->second.c_str());
    };
    const std::optional<double> option = parser.sceneData->integral->fit;
    double budgets = option.value_or(statement.parameters.fit.value_or(0));
    if (budgets > 0 && statement.orthographic)
    {
        Warn_Of_No_Eye();
        budgets = 0;
    }
    const std::optional<double> budget = integral::seen_budget(pov_base::Integral_Geometry(print));
    if (!budget)
    {
        if (budgets > 0)
            parser.Warning(0, "Integral camera: no fit: lenses so wide for the sheet's thickness "
                              "have no depth budget.");
        return;
    }
    if (!(budgets > 0))
        return Warn_Of_Depth(print, distances, beyond * *budget, statement.orthographic);
    statement.parameters.fit = budgets;
    const std::vector<std::string> errors = integral::find_errors(statement.parameters);
    if (!errors.empty())
        parser.Error("Integral camera: %s.", errors.front().c_str());
    const auto ends = integral::depth_ends(distances);
    if (!ends)
        return parser.Warning(0, "Integral camera: no fit: no surface is seen from the scene's "
                                 "eye.");

    const double allowed = budgets * *budget, viewed = viewer_distance(print);
    const integral::SceneFit before = Fit_Of(print);
    const bool animated = declared("final_frame") > declared("initial_frame");
    const std::string scene = UCS2toASCIIString(parser.sceneData->inputFile);
    const bool chosen = animated && animation_fit.fit && animation_fit.scene == scene &&
                        animation_fit.budgets == budgets &&
                        declared("frame_number") > declared("initial_frame");
    const integral::SceneFit fit = chosen ? *animation_fit.fit
                                          : Choose(*ends, statement, print, allowed);
    if (animated)
        animation_fit = {scene, budgets, fit};

    DBL direction;
    VLength(direction, camera.Direction);
    if (!statement.parameters.sheet_distance && !statement.orthographic)
        statement.sheet_distance_ratio = fit.sheet_distance / direction;
    statement.parameters.parallax = fit.parallax;
    Make_Optics(camera, statement);
    statement.fit_words = "sheet_distance " +
                          integral::with_digits(statement.sheet_distance_ratio *
                                                    statement.direction, 6) +
                          " parallax " + integral::with_digits(fit.parallax, 6);
    const auto percent = [&](const integral::SceneFit& with)
    { return 100 * integral::part_within(with, distances, allowed / viewed); };
    parser.Warning(0,
                   "Integral camera: the fit to %.3g depth budgets (%.3g mm either side of the "
                   "sheet) chose\n%s: %s%.0f%% of the picture lie within; %.0f%% before the fit.",
                   budgets, allowed, statement.fit_words.c_str(),
                   !animated ? ""
                   : chosen  ? "as for the animation's first frame; "
                             : "for all frames of the animation, by this one; ",
                   percent(fit), percent(before));
}

/// Warns that an orthographic camera's scene is not fitted.
void IntegralGrammar::Warn_Of_No_Eye()
{
    parser.Warning(0, "Integral camera: no fit: an orthographic camera has no eye, and the scene keeps "
                      "its depth.");
}

/// `reach`: depth on either side of the sheet at which half of its resolution is left, mm.
void IntegralGrammar::Warn_Of_Depth(const integral::IntegralCamera& optics,
                                    const std::vector<double>& distances, double reach,
                                    bool orthographic)
{
    std::vector<double> surfaces;
    std::copy_if(distances.begin(), distances.end(), std::back_inserter(surfaces),
                 [](double distance) { return distance < HUGE_VAL; });
    const double within = integral::part_within(Fit_Of(optics), surfaces,
                                                reach / viewer_distance(optics));
    if (!surfaces.empty() && within < 0.5)
        parser.Warning(0,
                       "Integral camera: %.0f%% of the picture's surfaces lie farther from the sheet than "
                       "%.3g mm, twice its depth budget:\nthey are seen blurred or double. %s",
                       100 * (1 - within), reach,
                       orthographic ? "look_at places the sheet; a perspective camera can be fitted."
                                    : "Integral_Fit=on chooses sheet_distance and parallax.");
}

}
