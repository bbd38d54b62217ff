// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/parser/integralgrammar.h"
#include "backend/parser/integraloption.h"
#include "backend/parser/parse.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "base/integralframe.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

std::string List(const std::vector<std::string>& words)
{
    std::string list;
    for (size_t i = 0; i < words.size(); i++)
        list += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
    return list;
}

const std::vector<std::string> camera_words = {
    "lens_sheet", "film", "sheet_distance", "capture_aperture", "aperture_shape", "lens_model",
    "lens_mapping", "depth_range" };

}

IntegralGrammar& IntegralGrammar::Of(Parser& parser)
{
    if (!parser.integralGrammar)
        parser.integralGrammar.reset(new IntegralGrammar(parser));
    return *parser.integralGrammar;
}

/// The text of the next token, whatever the scene has made of it; the token stays next.
/// Empty at the end of the scene.
std::string IntegralGrammar::Next_Word()
{
    parser.Get_Token();
    parser.Unget_Token();
    if (parser.Include_File_Index < option_level)
        parser.Error("Integral_Camera ends too early: a '}' is missing.");
    if (parser.Token.Token_Id == END_OF_FILE_TOKEN || parser.Token.Token_String == NULL)
        return "";
    return parser.Token.Token_String;
}

bool IntegralGrammar::Accept(const char* word)
{
    if (Next_Word() != word || parser.Token.Token_Id == STRING_LITERAL_TOKEN)
        return false;
    parser.Get_Token();
    return true;
}

/// The camera's block, as one that no other camera shares.
IntegralBlock& IntegralGrammar::Edit(Camera& camera)
{
    auto block = camera.Integral ? std::make_shared<IntegralBlock>(*camera.Integral)
                                 : std::make_shared<IntegralBlock>();
    camera.Integral = block;
    return *block;
}

void IntegralGrammar::Begin(Camera& camera)
{
    if (camera.Integral && camera.Integral->integral)
        parser.Error("This camera is integral already: 'integral' stands in it twice.");
    Edit(camera).integral = true;
}

void IntegralGrammar::Parse_Type(Camera& camera)
{
    if (Accept("integral"))
        Begin(camera);
}

bool IntegralGrammar::Parse_Modifier(Camera& camera)
{
    if (Accept("integral"))
    {
        Begin(camera);
        return true;
    }
    if (!camera.Integral || !camera.Integral->integral)
        return false;
    const std::string word = Next_Word();
    if (std::find(camera_words.begin(), camera_words.end(), word) != camera_words.end())
        return Parse_Word(Edit(camera));
    // POV-Ray would go on to say that it misses a '}', which is of little help
    if (parser.Token.Token_Id == IDENTIFIER_TOKEN)
        parser.Error("'%s' is not a word of an integral camera: %s, or one of the perspective camera's.",
                     word.c_str(), List(camera_words).c_str());
    return false;
}

/// Notes that a word is given, and refuses it a second time.
void IntegralGrammar::Give(IntegralBlock& block, const std::string& word)
{
    if (!block.given.insert(word).second)
        parser.Error("%s is given twice.", word.c_str());
}

/// Refuses a value as soon as it has been read, while the message can still name its line.
void IntegralGrammar::Check_Value(const IntegralBlock& block)
{
    const std::vector<std::string> errors = integral::find_value_errors(block.parameters);
    if (!errors.empty())
        parser.Error("Integral camera: %s.", errors.front().c_str());
}

double IntegralGrammar::Parse_Number()
{
    return parser.Parse_Float();
}

/// A two-component vector; with `promote`, a number stands for two equal components.
integral::Vec2 IntegralGrammar::Parse_Pair(bool promote)
{
    EXPRESS components;
    const int terms = parser.Parse_Unknown_Vector(components);
    if (terms == 1 && promote)
        return {components[X], components[X]};
    if (terms != 2)
        parser.Error("%s expected but a %s found.", promote ? "A number or a vector <x, y>" : "A vector <x, y>",
                     terms == 1 ? "single number" : "vector with other than two components");
    return {components[X], components[Y]};
}

std::string IntegralGrammar::Parse_Choice(const char* word, const std::vector<std::string>& legal)
{
    const std::string choice = Next_Word();
    parser.Get_Token();
    if (parser.Token.Token_Id == STRING_LITERAL_TOKEN)
        parser.Error("A %s is written without quotes: %s expected.", word, List(legal).c_str());
    if (std::find(legal.begin(), legal.end(), choice) == legal.end())
        parser.Error("'%s' is not a %s: %s expected.", choice.c_str(), word, List(legal).c_str());
    return choice;
}

bool IntegralGrammar::Parse_Word(IntegralBlock& block)
{
    integral::CameraParameters& p = block.parameters;
    const std::string word = Next_Word();
    if (std::find(camera_words.begin(), camera_words.end(), word) == camera_words.end())
        return false;
    parser.Get_Token();
    Give(block, word);
    if (word == "lens_sheet")
        Parse_Lens_Sheet(block);
    else if (word == "film")
        Parse_Film(block);
    else if (word == "sheet_distance")
        p.sheet_distance = Parse_Number();
    else if (word == "capture_aperture")
        p.capture_aperture = Parse_Pair(false);
    else if (word == "aperture_shape")
        p.aperture_shape = Parse_Choice("shape of an aperture", {"rectangle", "ellipse"}) == "ellipse"
            ? integral::ApertureShape::ellipse : integral::ApertureShape::rectangle;
    else if (word == "lens_model")
        Parse_Choice("lens model", {"extended_pinhole"});
    else if (word == "lens_mapping")
    {
        const std::string mapping = Parse_Choice("lens mapping", {"auto", "closest", "accurate", "exhaustive"});
        p.mapping = mapping == "closest" ? integral::LensMapping::closest
                  : mapping == "accurate" ? integral::LensMapping::accurate
                  : mapping == "exhaustive" ? integral::LensMapping::exhaustive
                  : integral::LensMapping::automatic;
    }
    else if (word == "depth_range")
        p.depth_range = Parse_Pair(false);
    Check_Value(block);
    return true;
}

void IntegralGrammar::Parse_Lens_Sheet(IntegralBlock& block)
{
    integral::LensSheet& sheet = block.parameters.sheet;
    std::set<std::string> given;
    const auto give = [&](const char* word) {
        if (!given.insert(word).second)
            parser.Error("%s is given twice in lens_sheet.", word);
    };
    const auto arrange = [&](integral::Arrangement arrangement) {
        if (!given.insert("arrangement").second)
            parser.Error("lens_sheet has one arrangement: lenticular, square or hexagonal.");
        sheet.arrangement = arrangement;
    };
    const auto number = [&](const char* word, double& value) {
        give(word);
        value = Parse_Number();
        Check_Value(block);
    };

    parser.Parse_Begin();
    while (true)
    {
        if (Accept("lenticular")) arrange(integral::Arrangement::lenticular);
        else if (Accept("square")) arrange(integral::Arrangement::square);
        else if (Accept("hexagonal")) arrange(integral::Arrangement::hexagonal);
        else if (Accept("pitch")) number("pitch", sheet.pitch);
        else if (Accept("thickness")) number("thickness", sheet.thickness);
        else if (Accept("ior")) number("ior", sheet.ior);
        else if (Accept("slant")) number("slant", sheet.slant);
        else if (Accept("offset"))
        {
            give("offset");
            sheet.offset = Parse_Pair(false);
            Check_Value(block);
        }
        else if (Next_Word() != "}" && parser.Token.Token_Id != END_OF_FILE_TOKEN)
            parser.Error("'%s' is not a word of lens_sheet: lenticular, square, hexagonal, pitch, thickness, "
                         "ior, slant or offset expected.", Next_Word().c_str());
        else
            break;
    }
    parser.Parse_End();

    if (!given.count("arrangement"))
        parser.Error("lens_sheet needs an arrangement: lenticular, square or hexagonal.");
    for (const char* word : {"pitch", "thickness", "ior"})
        if (!given.count(word))
            parser.Error("lens_sheet needs %s%s.", word, std::string(word) == "ior" ? "" : " (mm)");
}

void IntegralGrammar::Parse_Film(IntegralBlock& block)
{
    integral::FilmParameters& film = block.parameters.film;
    std::set<std::string> given;
    const auto give = [&](const char* word) {
        if (!given.insert(word).second)
            parser.Error("%s is given twice in film.", word);
    };

    parser.Parse_Begin();
    while (true)
    {
        if (Accept("dpi"))
        {
            give("dpi");
            const integral::Vec2 dpi = Parse_Pair(true);
            for (const double value : {dpi.x, dpi.y})
                if (!(value >= 0.00254 && value <= 25.4e6))
                    parser.Error("Integral camera: dpi %g is out of range: it is 0.00254 to 25400000.", value);
            film.pixel_pitch = {integral::mm_per_inch / dpi.x, integral::mm_per_inch / dpi.y};
        }
        else if (Accept("pixel_pitch"))
        {
            give("pixel_pitch");
            film.pixel_pitch = Parse_Pair(true);
        }
        else if (Accept("units_per_mm"))
        {
            give("units_per_mm");
            film.units_per_mm = Parse_Number();
        }
        else if (Next_Word() != "}" && parser.Token.Token_Id != END_OF_FILE_TOKEN)
            parser.Error("'%s' is not a word of film: dpi, pixel_pitch or units_per_mm expected.", Next_Word().c_str());
        else
            break;
        Check_Value(block);
    }
    parser.Parse_End();

    if (given.count("dpi") + given.count("pixel_pitch") != 1)
        parser.Error("film needs one of dpi and pixel_pitch (mm), and not both.");
}

void IntegralGrammar::Parse_Option()
{
    const UCS2String& text = parser.sceneData->integralCamera;
    if (text.empty())
        return;

    // the text goes before what is read next, as an include file does; it leaves the stack by itself
    option_level = ++parser.Include_File_Index;
    parser.Input_File = &parser.Include_Files[option_level];
    parser.Input_File->In_File = new pov_base::ITextStream(ASCIItoUCS2String("Integral_Camera").c_str(),
                                     new OptionTextStream("{ " + UCS2toASCIIString(text) + " }"));
    parser.Input_File->R_Flag = false;
    parser.Echo_Indx = 0;
    parser.Add_Sym_Table();

    // whatever it says of #version, the scene has said nothing yet
    const auto version = parser.sceneData->languageVersion;
    const bool version_set = parser.sceneData->languageVersionSet;

    option = std::make_shared<IntegralBlock>();
    parser.Parse_Begin();
    while (Parse_Word(*option))
        ;
    if (Next_Word() != "}")
        parser.Error("'%s' is not a word of Integral_Camera: %s expected.", Next_Word().c_str(),
                     List(camera_words).c_str());
    parser.Parse_End();
    if (parser.Skip_Spaces())
        parser.Error("Integral_Camera has a '}' too many.");
    option_level = 0;

    parser.sceneData->languageVersion = version;
    parser.sceneData->languageVersionSet = version_set;
    parser.sceneData->languageVersionLate = false;
    parser.messageFactory.SetLanguageVersion(version);
    parser.token_count = 0;
}

/// Puts the words of Integral_Camera= in the place of the camera's own.
void IntegralGrammar::Apply_Option(IntegralBlock& block)
{
    const integral::CameraParameters& from = option->parameters;
    integral::CameraParameters& to = block.parameters;
    const auto given = [&](const char* word) { return option->given.count(word) > 0; };
    if (given("lens_sheet")) to.sheet = from.sheet;
    if (given("film")) to.film = from.film;
    if (given("sheet_distance")) to.sheet_distance = from.sheet_distance;
    if (given("capture_aperture")) to.capture_aperture = from.capture_aperture;
    if (given("aperture_shape")) to.aperture_shape = from.aperture_shape;
    if (given("lens_mapping")) to.mapping = from.mapping;
    if (given("depth_range")) to.depth_range = from.depth_range;
    block.given.insert(option->given.begin(), option->given.end());
    block.integral = true;
}

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
    IntegralBlock& block = Edit(camera);
    if (option)
        Apply_Option(block);
    DBL direction;
    VLength(direction, camera.Direction);
    if (!(direction > 0) || std::isinf(direction))
        parser.Error("An integral camera needs a direction that is finite and not zero; it follows from location, look_at "
                     "and direction.");
    const double distance = block.parameters.sheet_distance ? *block.parameters.sheet_distance
                          : block.look_at_distance > 0 ? block.look_at_distance : direction;
    block.sheet_distance_ratio = distance / direction;
}

/// Width and height of the picture, as the front end declares them to the scene.
bool IntegralGrammar::Frame_Size(int& width, int& height)
{
    const auto number = [&](const char* name, int& value) {
        const auto found = parser.sceneData->declaredVariables.find(name);
        value = found == parser.sceneData->declaredVariables.end() ? 0 : int(std::atof(found->second.c_str()));
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
    IntegralBlock& block = Edit(camera);
    if (camera.Type != PERSPECTIVE_CAMERA)
        parser.Error("An integral camera starts from the perspective camera; no other type goes with it.");
    if (camera.Tnormal != NULL)
        parser.Error("A camera normal does not go with an integral camera: it would bend the light of all lenses alike.");
    if (option && camera.Aperture != 0 && camera.Blur_Samples > 0)
    {
        parser.Warning(0, "Integral_Camera: the scene's focal blur (aperture, blur_samples) is left out: depth is focused by\n"
                          "the eye that looks at the print.");
        camera.Blur_Samples = 0;
    }
    if (camera.Aperture != 0 && camera.Blur_Samples > 0)
        parser.Error("Focal blur (aperture, blur_samples) does not go with an integral camera: its depth is focused by "
                     "the eye that looks at the print.");
    for (const char* word : {"lens_sheet", "film"})
        if (!block.given.count(word))
            parser.Error("An integral camera needs %s { ... }.", word);
    int width, height;
    try
    {
        if (Frame_Size(width, height))
            block.optics = Make_Integral_Optics(camera, width, height);
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
            parser.Error("Integral_Camera applies to a perspective camera, and this scene's is of another type.");
        Settle(camera);
        Check(camera);
    }
    const bool integral = camera.Integral && camera.Integral->integral && camera.Integral->optics;
    pov_base::IntegralFrame::Set_Scene(UCS2toASCIIString(parser.sceneData->inputFile));
    pov_base::IntegralFrame::Expect(integral ? camera.Integral->optics.get() : NULL);
    if (integral)
        Warn(camera);
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
        parser.Warning(0, "Integral camera: |up|/|right| is %.4g, but the film's height is %.4g of its width, and the\n"
                          "picture keeps the film's. A right of length %.6g beside this up would fit.",
                       up / right, wanted, up / wanted);

    const double pitch = optics.optics.sheet().pitch * optics.placement.units_per_mm;
    if (pitch < 0.05 || pitch > 100)
        parser.Warning(0, "Integral camera: the lens pitch is %.3g scene units. POV-Ray's tolerances are absolute, and\n"
                          "pixels go wrong outside of 0.05 to 100: scale scene and camera by about %.1g.",
                       pitch, optics.optics.sheet().pitch / pitch);

    const integral::Aperture& aperture = optics.optics.aperture();
    const auto filling = integral::filling_aperture(optics.optics.sheet(), aperture.distance);
    if (filling && (aperture.width > 1.1 * filling->width || aperture.height > 1.1 * filling->height))
        parser.Warning(0, "Integral camera: capture_aperture <%.4g, %.4g> is wider than the <%.4g, %.4g> mm that fill a lens:\n"
                          "what its edges see stands behind the neighbouring lenses, and is seen double.",
                       aperture.width, aperture.height, filling->width, filling->height);

    const integral::Coverage part = integral::coverage(optics, 20000);
    if (part.imaged == 0)
        parser.Warning(0, "Integral camera: nothing will be imaged: every film point misses the capture aperture.");
    else if (part.imaged < (optics.mapping == integral::LensMapping::closest ? 0.99 : 0.9))
        parser.Warning(0, "Integral camera: about %.0f%% of the film will stay empty (%.0f%% misses the capture aperture,\n"
                          "%.0f%% is totally reflected)%s.",
                       100 * (part.outside_aperture + part.total_reflection), 100 * part.outside_aperture,
                       100 * part.total_reflection,
                       optics.mapping == integral::LensMapping::closest ? "; lens_mapping auto would lose less" : "");
}

}
