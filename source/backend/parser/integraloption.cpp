// SPDX-License-Identifier: AGPL-3.0-or-later
// The part of IntegralGrammar that reads what comes from outside of the scene: the options
// Integral_Camera= and Integral_Sheet=, the picture's size, and files of lens sheets.

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/parser/integraloption.h"
#include "backend/parser/integralgrammar.h"
#include "backend/parser/parse.h"
#include "backend/scene/integralcamera.h"
#include "backend/support/fileutil.h"
#include "integral/base/atomic_file.h"
#include "integral/base/json.h"
#include "integral/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

void IntegralGrammar::Parse_Option()
{
    const std::string scene = UCS2toASCIIString(parser.sceneData->inputFile);
    if (integral::is_special(scene))
        parser.Error(
            "The scene %s is a pipe or a device, and POV-Ray must read parts of it twice; save it "
            "as a file first.",
            scene.c_str());
    const pov_base::IntegralSceneOptions& options = *parser.sceneData->integral;
    if (!options.problem_with_any_camera.empty())
        parser.Error("%s.", options.problem_with_any_camera.c_str());
    if (options.camera.empty() && options.sheet.empty())
        return;
    option = std::make_shared<IntegralStatement>();

    // A #version in the text must not set the scene's language version.
    const auto version = parser.sceneData->languageVersion;
    const bool version_set = parser.sceneData->languageVersionSet;
    if (!options.camera.empty())
        Parse_Text(options.camera);
    if (!options.sheet.empty())
    {
        option->parameters.sheet = Read_Sheet(ASCIItoUCS2String(options.sheet.c_str()));
        option->given.insert("lens_sheet");
    }
    if (option->given.count("print_size") && option->given.count("film"))
        Use_Print_Size();
    if (option->parameters.film.bleed > 0)
        Use_Trimmed_Shape();
    if (options.quilt && option->given.count("film"))
        Use_View_Shape();

    parser.sceneData->languageVersion = version;
    parser.sceneData->languageVersionSet = version_set;
    parser.sceneData->languageVersionLate = false;
    parser.messageFactory.SetLanguageVersion(version);
    parser.token_count = 0;
}

/// Reads the words of Integral_Camera= into `option`.
void IntegralGrammar::Parse_Text(const std::string& text)
{
    // Push the text on the stack of include files, from which the parser removes it at its end.
    option_level = ++parser.Include_File_Index;
    parser.Input_File = &parser.Include_Files[option_level];
    parser.Input_File->In_File = new pov_base::ITextStream(
        ASCIItoUCS2String("Integral_Camera").c_str(), new OptionTextStream("{ " + text + "\n}"));
    parser.Input_File->R_Flag = false;
    parser.Echo_Indx = 0;
    parser.Add_Sym_Table();

    parser.Parse_Begin();
    while (Parse_Word(*option))
        ;
    if (Next_Word() != "}")
        parser.Error("'%s' is not a word of Integral_Camera: %s expected.", Next_Word().c_str(),
                     List_Of_Words().c_str());
    parser.Parse_End();
    if (parser.Skip_Spaces())
        parser.Error("Integral_Camera has a '}' too many.");
    option_level = 0;
}

/// If the options leave the picture's size open, sets it (in pixels), and the scene's image_width and
/// image_height, from the print_size of Integral_Camera=.
void IntegralGrammar::Use_Print_Size()
{
    const pov_base::IntegralSceneOptions& options = *parser.sceneData->integral;
    const integral::PixelSize pixels = integral::print_pixels(option->parameters);
    const auto set = [&](const char *name, int value)
    {
        parser.sceneData->declaredVariables[name] = std::to_string(value);
        if (SYM_ENTRY *const symbol = parser.Find_Symbol(1, name))
            *static_cast<DBL *>(symbol->Data) = value;
    };
    if (options.free_width)
        set("image_width", pixels.width);
    if (options.free_height)
        set("image_height", pixels.height);
}

/// Sets the scene's image_width and image_height to the size without bleed, so that
/// image_width/image_height is the shape of the picture after cutting.
void IntegralGrammar::Use_Trimmed_Shape()
{
    const integral::FilmParameters& film = option->parameters.film;
    const auto trim = [&](const char *name, double pitch)
    {
        if (SYM_ENTRY *const symbol = parser.Find_Symbol(1, name))
        {
            DBL& value = *static_cast<DBL *>(symbol->Data);
            value = std::max(1.0, value - std::round(2 * film.bleed / pitch));
        }
    };
    trim("image_width", film.pixel_pitch.x);
    trim("image_height", film.pixel_pitch.y);
}

/// In a quilt whose pixels are not square: scales the scene's image_width or image_height, so that
/// image_width/image_height is the shape of a view.
void IntegralGrammar::Use_View_Shape()
{
    const integral::Vec2 pitch = option->parameters.film.pixel_pitch;
    const auto scale = [&](const char *name, double factor)
    {
        if (SYM_ENTRY *const symbol = parser.Find_Symbol(1, name))
        {
            DBL& value = *static_cast<DBL *>(symbol->Data);
            value = std::max(1.0, std::round(factor * value));
        }
    };
    if (pitch.x < pitch.y)
        scale("image_width", pitch.x / pitch.y);
    else if (pitch.y < pitch.x)
        scale("image_height", pitch.y / pitch.x);
}

/// Gets width and height of the final picture from the identifiers that the front end declares in
/// the scene; false if they are not declared. Reports an error if no picture can have that size.
bool IntegralGrammar::Frame_Size(const IntegralStatement& statement, integral::PixelSize& size)
{
    const auto number = [&](const char *name) -> std::optional<double>
    {
        const auto found = parser.sceneData->declaredVariables.find(name);
        if (found == parser.sceneData->declaredVariables.end())
            return std::nullopt;
        return std::atof(found->second.c_str());
    };
    const auto width = number("image_width"), height = number("image_height");
    if (!width || !height)
        return false;
    const auto check = [&](const char *option, double pixels)
    {
        if (!(pixels >= 1 && pixels <= integral::largest_side))
            Refuse(statement, std::string("Integral camera: the picture cannot have ") + option +
                                  integral::with_decimals(pixels, 0) + " pixels: 1 to " +
                                  std::to_string(integral::largest_side) + " expected.");
    };
    check("+W", *width);
    check("+H", *height);
    size = {int(*width), int(*height)};
    return true;
}

/// Reads a lens sheet from a JSON document, which is searched for, and subject to IO restrictions,
/// like any file that a scene reads.
integral::LensSheet IntegralGrammar::Read_Sheet(const UCS2String& file)
{
    const std::string name = UCS2toASCIIString(file);
    UCS2String found;
    const std::unique_ptr<IStream> stream(
        Locate_File(&parser, parser.sceneData, file, POV_File_Text_User, found, false));
    if (!stream)
        parser.Error("Cannot open the lens sheet's file '%s': it is sought where include files "
                     "are.",
                     name.c_str());
    std::string text;
    for (int byte; text.size() <= std::size_t(integral::most_json_megabytes) << 20 &&
                   (byte = stream->Read_Byte()) != EOF;)
        text += char(byte);
    try
    {
        return integral::frame_metadata_from_json(text).sheet;
    }
    catch (const std::invalid_argument& problem)
    {
        parser.Error("lens_sheet: %s: %s; `integral sheet --json` writes such files.", name.c_str(),
                     problem.what());
    }
}

}
