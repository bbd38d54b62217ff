// SPDX-License-Identifier: AGPL-3.0-or-later
// The part of IntegralGrammar that follows a complete camera statement: places the sheet, and
// checks the camera that is finally rendered (a later statement may replace a camera).

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/parser/integralgrammar.h"
#include "backend/parser/parse.h"
#include "backend/render/integralprobes.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "base/integralframe.h"
#include "base/integraloptions.h"
#include "integral/base/number_text.h"
#include "integral/optics/visual_pitch.h"
#include "integral/sheet/sheet_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
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

/// Whether Integral_Camera= can make a camera integral.
static bool Takes_Option(const Camera& camera)
{
    return camera.Type == PERSPECTIVE_CAMERA || camera.Type == ORTHOGRAPHIC_CAMERA;
}

void IntegralGrammar::Settle(Camera& camera)
{
    const bool integral = camera.Integral && camera.Integral->integral;
    if (!integral && !(option && Takes_Option(camera)))
        return;
    IntegralStatement& statement = Edit(camera);
    if (option)
        Apply_Option(statement);
    DBL direction;
    VLength(direction, camera.Direction);
    if (!(direction > 0) || std::isinf(direction))
        return; // Check_Camera reports it
    const double distance = statement.parameters.sheet_distance
                                ? *statement.parameters.sheet_distance
                            : statement.look_at_distance > 0 ? statement.look_at_distance
                                                             : direction;
    statement.sheet_distance_ratio = distance / direction;
    statement.direction = direction;
}

void IntegralGrammar::End(Camera& camera)
{
    if (!camera.Integral || !camera.Integral->integral)
        return;
    IntegralStatement& statement = Edit(camera);
    if (camera.Type == ORTHOGRAPHIC_CAMERA)
    {
        if (statement.parameters.fit)
            Warn_Of_No_Eye();
        statement.parameters.fit.reset();
        statement.orthographic = statement.parameters.move_eye = true;
        camera.Type = PERSPECTIVE_CAMERA;
    }
    if (parser.Token.FileHandle != NULL)
        statement.end = {parser.Token.FileHandle->name(), parser.Token.Token_File_Pos.lineno,
                         parser.Token.Token_Col_No, parser.Token.FileHandle->tellg().offset};
}

/// Reports an error at the end of the camera's statement.
void IntegralGrammar::Refuse(const IntegralStatement& statement, const std::string& message)
{
    const IntegralStatement::Position& end = statement.end;
    if (end.file.empty())
        parser.Error("%s", message.c_str());
    parser.messageFactory.ErrorAt(POV_EXCEPTION(kParseErr, message), end.file.c_str(), end.line,
                                  end.column, end.offset, "%s", message.c_str());
}

void IntegralGrammar::Check_Type(const Camera& camera, const IntegralStatement& statement)
{
    if (statement.orthographic && !statement.parameters.viewing_distance)
        Refuse(statement, "An orthographic camera has no eye, and an integral one needs it: add "
                          "viewing_distance and how far from the picture the eye is, in mm, for "
                          "example viewing_distance 400.");
    if (camera.Type != PERSPECTIVE_CAMERA)
        Refuse(statement, "An integral camera starts from a perspective or an orthographic camera; "
                          "take one of these types.");
}

/// Computes the lenses' own pitch from visual_pitch, the pitch as seen from viewing_distance.
void IntegralGrammar::Use_Visual_Pitch(IntegralStatement& statement)
{
    integral::CameraParameters& parameters = statement.parameters;
    if (!statement.visual_pitch)
        return;
    if (!parameters.viewing_distance)
        Refuse(statement, "visual_pitch is the pitch that is even from viewing_distance: add "
                          "viewing_distance and that distance, in mm, or give the lenses' own "
                          "pitch.");
    if (parameters.projection_lens)
        Refuse(statement,
               "visual_pitch does not work with projection_lens, behind whose image the sheet is "
               "not seen: give the lenses' own pitch.");
    parameters.sheet.pitch = integral::pitch_of_visual(*statement.visual_pitch, parameters.sheet,
                                                       *parameters.viewing_distance);
}

/// Reports an error if a picture of `size` pixels does not have the size of print_size.
void IntegralGrammar::Check_Print_Size(const IntegralStatement& statement, integral::PixelSize size)
{
    if (!statement.parameters.print_size)
        return;
    const integral::PixelSize requested = integral::print_pixels(statement.parameters);
    if (std::abs(requested.width - size.width) <= 1 && std::abs(requested.height - size.height) <= 1)
        return;
    const integral::Vec2 mm = *statement.parameters.print_size;
    const bool sets_size = option && option->given.count("print_size") &&
                           option->given.count("film");
    const std::string help = sets_size ? ", or none"
                                       : " (print_size and film in Integral_Camera= set it by "
                                         "themselves)";
    Refuse(statement, "print_size <" + integral::with_digits(mm.x, 6) + ", " +
                          integral::with_digits(mm.y, 6) + "> needs +W" +
                          std::to_string(requested.width) + " +H" + std::to_string(requested.height) +
                          " with this film, not +W" + std::to_string(size.width) + " +H" +
                          std::to_string(size.height) + ". Give that size" + help + ".");
}

/// Computes the statement's optics if the picture's size is known; with Integral_Draft=, a draft's
/// optics.
void IntegralGrammar::Make_Optics(Camera& camera, IntegralStatement& statement)
{
    integral::PixelSize size;
    if (!Frame_Size(statement, size))
        return;
    Check_Print_Size(statement, size);
    const integral::Film film = {size.width, size.height, statement.parameters.film.pixel_pitch};
    statement.draft = parser.sceneData->integral->draft;
    const integral::Film draft = integral::draft_of(film, std::max(1, statement.draft));
    if (statement.draft > 1)
        statement.draft_pitch = draft.pixel_pitch;
    try
    {
        statement.optics = Make_Integral_Optics(camera, draft.width, draft.height);
    }
    catch (const std::invalid_argument& problem)
    {
        Refuse(statement, std::string("Integral camera: ") + problem.what() + ".");
    }
}

/// Returns the print's optics if the camera's frame is a draft of it, else the camera's own.
std::shared_ptr<const integral::IntegralCamera> IntegralGrammar::Print_Optics(const Camera& camera)
{
    if (!camera.Integral->draft_pitch)
        return camera.Integral->optics;
    Camera print(camera);
    IntegralStatement& statement = Edit(print);
    statement.draft_pitch.reset();
    integral::PixelSize size;
    Frame_Size(statement, size);
    try
    {
        return Make_Integral_Optics(print, size.width, size.height);
    }
    catch (const std::invalid_argument& problem)
    {
        Refuse(statement, std::string("Integral camera: ") + problem.what() + ".");
    }
    return nullptr;
}

/// Checks the camera that is rendered, and makes its optics.
void IntegralGrammar::Check_Camera(Camera& camera)
{
    if (camera.Integral->sheet_distance_ratio == 0)
        Settle(camera);
    IntegralStatement& statement = Edit(camera);
    if (statement.sheet_distance_ratio == 0)
        Refuse(statement, "An integral camera needs a direction that is finite and not zero; it "
                          "follows from location, look_at and direction.");
    Check_Type(camera, statement);
    if (camera.Tnormal != NULL)
        Refuse(statement,
               "A camera normal does not work with an integral camera: it would bend the "
               "light of all lenses equally.");
    if (option && camera.Aperture != 0 && camera.Blur_Samples > 0)
    {
        parser.Warning(0, "Integral_Camera: the scene's focal blur (aperture, blur_samples) is "
                          "left out: depth is focused by\n"
                          "the eye that looks at the print.");
        camera.Blur_Samples = 0;
    }
    if (camera.Aperture != 0 && camera.Blur_Samples > 0)
        Refuse(statement,
               "Focal blur (aperture, blur_samples) does not work with an integral camera: "
               "its depth is focused by the eye that looks at the print.");
    for (const char *word : {"lens_sheet", "film"})
        if (!statement.given.count(word))
            Refuse(statement, std::string("An integral camera needs ") + word + " { ... }.");
    if (parser.sceneData->integral->quilt && statement.parameters.film.bleed > 0)
        Refuse(statement, "A bleed is cut off a print, and a quilt is not printed: leave bleed out "
                          "of film.");
    Use_Visual_Pitch(statement);
    Make_Optics(camera, statement);
}

void IntegralGrammar::Finish(Camera& camera)
{
    if (option && !(camera.Integral && camera.Integral->integral))
    {
        if (!Takes_Option(camera))
            parser.Error("Integral_Camera applies to a perspective or an orthographic camera, and "
                         "this scene's is of another type.");
        Settle(camera);
        End(camera);
    }
    if (camera.Integral && camera.Integral->integral)
        Check_Camera(camera);
    const bool integral = camera.Integral && camera.Integral->integral && camera.Integral->optics;
    std::vector<double> distances;
    if (integral)
    {
        const std::shared_ptr<const integral::IntegralCamera> print = Print_Optics(camera);
        distances = Probe_Integral_Depths(*print, *parser.sceneData, parser.GetParserDataPtr());
        Fit_Depth(camera, *print, distances);
        Edit(camera).distances = distances;
    }
    pov_base::IntegralFrame::Set_Scene(UCS2toASCIIString(parser.sceneData->inputFile));
    pov_base::IntegralFrame::Set_Expected_Camera(integral ? camera.Integral->optics.get() : NULL);
    if (!integral)
        return;
    const std::string& problem = parser.sceneData->integral->problem;
    if (!problem.empty())
        parser.Error("%s.", problem.c_str());
    Warn(camera, distances);
}

}
