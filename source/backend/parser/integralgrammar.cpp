// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must be the first POV-Ray file included (pulls in platform config)
#include "backend/frame.h"
#include "backend/parser/integralgrammar.h"
#include "backend/parser/parse.h"
#include "backend/scene/camera.h"
#include "backend/scene/integralcamera.h"
#include "integral/frame/names.h"

#include <algorithm>
#include <cmath>

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

/// The names of `words` as a list: "a, b or c".
template <class Words, class Name> std::string List(const Words& words, Name name)
{
    std::string list;
    std::size_t left = std::size(words);
    for (const auto& word : words)
    {
        list += std::string(list.empty() ? "" : left == 1 ? " or " : ", ") + name(word);
        left--;
    }
    return list;
}

/// The name of an enumeration in messages.
const char *What_Kind(integral::ApertureShape) { return "shape of an aperture"; }
const char *What_Kind(integral::LensModel) { return "lens model"; }
const char *What_Kind(integral::LensMapping) { return "lens mapping"; }
const char *What_Kind(integral::Subpixels::Order) { return "kind of subpixels"; }
const char *What_Kind(integral::CellPattern) { return "pattern of cells"; }

}

/// Reads one of the words of the enumeration Kind.
template <class Kind> Kind IntegralGrammar::Parse_Kind()
{
    const char *const of = What_Kind(Kind());
    const std::string word = Next_Word(), legal = integral::legal_names<Kind>();
    parser.Get_Token();
    if (parser.Token.Token_Id == STRING_LITERAL_TOKEN)
        parser.Error("A %s is written without quotes: %s expected.", of, legal.c_str());
    const auto kind = integral::kind_named<Kind>(word);
    if (!kind)
        parser.Error("'%s' is not a %s: %s expected.", word.c_str(), of, legal.c_str());
    return *kind;
}

/// A word of the camera statement: how to read its value, and how to copy the value from
/// Integral_Camera= to the scene's statement.
struct IntegralGrammar::Word
{
    using Parameters = integral::CameraParameters;

    const char *name;
    void (*parse)(IntegralGrammar& grammar, IntegralStatement& statement);
    void (*replace)(const Parameters& from, Parameters& to);

    /// A word that sets one field to the result of `Read`.
    template <auto Field, auto Read> static Word Value(const char *name)
    {
        return {name, Set<Field, Read>, Replace<Field>};
    }
    template <auto Field, auto Read>
    static void Set(IntegralGrammar& grammar, IntegralStatement& statement)
    {
        statement.parameters.*Field = (grammar.*Read)();
    }
    template <auto Field> static void Replace(const Parameters& from, Parameters& to)
    {
        to.*Field = from.*Field;
    }
};

/// All words, in the order in which messages list them.
const std::vector<IntegralGrammar::Word>& IntegralGrammar::Words()
{
    using P = integral::CameraParameters;
    using G = IntegralGrammar;
    static const std::vector<Word> words = {
        {"lens_sheet",
         [](G& grammar, IntegralStatement& statement) { grammar.Parse_Lens_Sheet(statement); },
         Word::Replace<&P::sheet>},
        {"film", [](G& grammar, IntegralStatement& statement) { grammar.Parse_Film(statement); },
         Word::Replace<&P::film>},
        Word::Value<&P::sheet_distance, &G::Parse_Number>("sheet_distance"),
        Word::Value<&P::viewing_distance, &G::Parse_Number>("viewing_distance"),
        Word::Value<&P::parallax, &G::Parse_Number>("parallax"),
        Word::Value<&P::fit, &G::Parse_Number>("fit"),
        Word::Value<&P::move_eye, &G::Parse_Flag>("move_eye"),
        Word::Value<&P::print_size, &G::Parse_Vector>("print_size"),
        Word::Value<&P::capture_aperture, &G::Parse_Vector>("capture_aperture"),
        Word::Value<&P::aperture_shape, &G::Parse_Kind<integral::ApertureShape>>("aperture_shape"),
        Word::Value<&P::model, &G::Parse_Kind<integral::LensModel>>("lens_model"),
        Word::Value<&P::mapping, &G::Parse_Kind<integral::LensMapping>>("lens_mapping"),
        Word::Value<&P::beam_samples, &G::Parse_Count>("beam_samples"),
        Word::Value<&P::pixel_samples, &G::Parse_Count>("pixel_samples"),
        Word::Value<&P::display_prefilter, &G::Parse_Flag>("display_prefilter"),
        Word::Value<&P::depth_range, &G::Parse_Vector>("depth_range"),
        Word::Value<&P::projection_lens, &G::Parse_Projection>("projection_lens"),
        Word::Value<&P::pseudoscopic, &G::Parse_Flag>("pseudoscopic"),
    };
    return words;
}

const IntegralGrammar::Word *IntegralGrammar::Find_Word(const std::string& name)
{
    for (const Word& word : Words())
        if (name == word.name)
            return &word;
    return nullptr;
}

std::string IntegralGrammar::List_Of_Words()
{
    return List(Words(), [](const Word& word) { return word.name; });
}

/// Overrides settings of the camera with the words of Integral_Camera=.
void IntegralGrammar::Apply_Option(IntegralStatement& statement)
{
    for (const Word& word : Words())
        if (option->given.count(word.name))
            word.replace(option->parameters, statement.parameters);
    if (option->given.count("lens_sheet"))
        statement.visual_pitch = option->visual_pitch;
    statement.given.insert(option->given.begin(), option->given.end());
    statement.integral = true;
}

IntegralGrammar& IntegralGrammar::Of(Parser& parser)
{
    if (!parser.integralGrammar)
        parser.integralGrammar.reset(new IntegralGrammar(parser));
    return *parser.integralGrammar;
}

/// The text of the next token, even if it is a declared identifier; empty at the end of the scene.
/// The token is not consumed.
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

bool IntegralGrammar::Accept(const char *word)
{
    if (Next_Word() != word || parser.Token.Token_Id == STRING_LITERAL_TOKEN)
        return false;
    parser.Get_Token();
    return true;
}

/// Returns the camera's statement for writing: a copy, because other cameras may share the old one.
IntegralStatement& IntegralGrammar::Edit(Camera& camera)
{
    auto statement = camera.Integral ? std::make_shared<IntegralStatement>(*camera.Integral)
                                     : std::make_shared<IntegralStatement>();
    camera.Integral = statement;
    return *statement;
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
    if (Find_Word(word))
        return Parse_Word(Edit(camera));
    // Otherwise POV-Ray would report a missing '}', which does not help the user.
    if (parser.Token.Token_Id == IDENTIFIER_TOKEN)
        parser.Error(
            "'%s' is not a word of an integral camera: %s, or one of the perspective camera's.",
            word.c_str(), List_Of_Words().c_str());
    return false;
}

/// Records that a word is given; reports an error if it was given before.
void IntegralGrammar::Give(IntegralStatement& statement, const std::string& word)
{
    if (!statement.given.insert(word).second)
        parser.Error("%s is given twice.", word.c_str());
}

/// Checks a value as soon as it has been read, so that an error message shows its line.
void IntegralGrammar::Check_Value(const IntegralStatement& statement)
{
    const std::vector<std::string> errors = integral::find_value_errors(statement.parameters);
    if (!errors.empty())
        parser.Error("Integral camera: %s.", errors.front().c_str());
}

/// A two-component vector; with `promote`, a number stands for two equal components.
integral::Vec2 IntegralGrammar::Parse_Pair(bool promote)
{
    EXPRESS components;
    const int terms = parser.Parse_Unknown_Vector(components);
    if (terms == 1 && promote)
        return {components[X], components[X]};
    if (terms != 2)
        parser.Error("%s expected but a %s found.",
                     promote ? "A number or a vector <x, y>" : "A vector <x, y>",
                     terms == 1 ? "single number" : "vector with other than two components");
    return {components[X], components[Y]};
}

/// A number of samples. Check_Value checks its range.
int IntegralGrammar::Parse_Count()
{
    const double count = parser.Parse_Float();
    if (!(std::fabs(count) < 1e9) || count != std::floor(count))
        parser.Error("%s %g is not a whole number: 1 to 65536 expected.", reading, count);
    return int(count);
}

double IntegralGrammar::Parse_Number() { return parser.Parse_Float(); }

integral::Vec2 IntegralGrammar::Parse_Vector() { return Parse_Pair(false); }

/// Reads <focal length, distance>, or <focal length, distance, columns, rows> of the macro-lenses.
integral::ProjectionWords IntegralGrammar::Parse_Projection()
{
    EXPRESS components;
    const int terms = parser.Parse_Unknown_Vector(components);
    if (terms != 2 && terms != 4)
        parser.Error(
            "projection_lens <focal length, distance> or <focal length, distance, columns, "
            "rows> expected.");
    if (terms == 2)
        return {components[X], components[Y]};
    return {components[X], components[Y], components[Z], components[T]};
}

/// A word without a value.
bool IntegralGrammar::Parse_Flag() { return true; }

bool IntegralGrammar::Parse_Word(IntegralStatement& statement)
{
    const Word *const word = Find_Word(Next_Word());
    if (!word)
        return false;
    parser.Get_Token();
    Give(statement, word->name);
    reading = word->name;
    word->parse(*this, statement);
    Check_Value(statement);
    return true;
}

void IntegralGrammar::Parse_Lens_Sheet(IntegralStatement& statement)
{
    integral::LensSheet& sheet = statement.parameters.sheet;
    std::set<std::string> given;
    const auto give = [&](const char *word)
    {
        if (!given.insert(word).second)
            parser.Error("%s is given twice in lens_sheet.", word);
    };
    const auto arrange = [&](integral::Arrangement arrangement)
    {
        if (!given.insert("arrangement").second)
            parser.Error("lens_sheet has one arrangement: lenticular, square or hexagonal.");
        sheet.arrangement = arrangement;
    };
    const auto number = [&](const char *word, double& value)
    {
        give(word);
        value = parser.Parse_Float();
        Check_Value(statement);
    };

    statement.visual_pitch.reset();
    parser.Parse_Begin();
    if (UCS2 *file = parser.Parse_String(true, false))
    {
        const UCS2String name(file);
        POV_FREE(file);
        sheet = Read_Sheet(name);
        if (Next_Word() != "}")
            parser.Error("'%s' in lens_sheet follows the name of a file, which gives the whole "
                         "sheet: '}' expected.",
                         Next_Word().c_str());
        parser.Parse_End();
        return;
    }
    while (true)
    {
        if (Accept("lenticular"))
            arrange(integral::Arrangement::lenticular);
        else if (Accept("square"))
            arrange(integral::Arrangement::square);
        else if (Accept("hexagonal"))
            arrange(integral::Arrangement::hexagonal);
        else if (Accept("pitch"))
            number("pitch", sheet.pitch);
        else if (Accept("visual_pitch"))
        {
            number("visual_pitch", sheet.pitch);
            statement.visual_pitch = sheet.pitch;
        }
        else if (Accept("thickness"))
            number("thickness", sheet.thickness);
        else if (Accept("ior"))
            number("ior", sheet.ior);
        else if (Accept("slant"))
            number("slant", sheet.slant);
        else if (Accept("offset"))
        {
            give("offset");
            sheet.offset = Parse_Pair(false);
            Check_Value(statement);
        }
        else if (Next_Word() != "}" && parser.Token.Token_Id != END_OF_FILE_TOKEN)
            parser.Error("'%s' is not a word of lens_sheet: lenticular, square, hexagonal, pitch, "
                         "visual_pitch, thickness, ior, slant or offset expected.",
                         Next_Word().c_str());
        else
            break;
    }
    parser.Parse_End();

    if (!given.count("arrangement"))
        parser.Error("lens_sheet needs an arrangement: lenticular, square or hexagonal; or the "
                     "name of a file with a measured sheet, in quotes.");
    if (given.count("pitch") && given.count("visual_pitch"))
        parser.Error("lens_sheet has pitch (the lenses' own) or visual_pitch (as seen from "
                     "viewing_distance), not both: leave one of them out.");
    if (given.count("visual_pitch"))
        given.insert("pitch");
    for (const char *word : {"pitch", "thickness", "ior"})
        if (!given.count(word))
            parser.Error("lens_sheet needs %s%s.", word, std::string(word) == "ior" ? "" : " (mm)");
}

void IntegralGrammar::Parse_Film(IntegralStatement& statement)
{
    integral::FilmParameters& film = statement.parameters.film;
    std::set<std::string> given;
    const auto give = [&](const char *word)
    {
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
                    parser.Error(
                        "Integral camera: dpi %g is out of range: it is 0.00254 to 25400000.",
                        value);
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
            film.units_per_mm = parser.Parse_Float();
        }
        else if (Accept("bleed"))
        {
            give("bleed");
            film.bleed = parser.Parse_Float();
        }
        else if (Accept("subpixels"))
        {
            give("subpixels");
            Parse_Subpixels(film.subpixels);
        }
        else if (Next_Word() != "}" && parser.Token.Token_Id != END_OF_FILE_TOKEN)
            parser.Error(
                "'%s' is not a word of film: dpi, pixel_pitch, units_per_mm, bleed or subpixels "
                "expected.",
                Next_Word().c_str());
        else
            break;
        Check_Value(statement);
    }
    parser.Parse_End();

    if (given.count("dpi") + given.count("pixel_pitch") != 1)
        parser.Error("film needs one of dpi and pixel_pitch (mm), and not both.");
}

/// Reads a word for stripes, or the positions of the colours in pixels: cells { PATTERN  <x, y>
/// <x, y> <x, y> ... }.
void IntegralGrammar::Parse_Subpixels(integral::Subpixels& subpixels)
{
    subpixels = integral::Subpixels(Parse_Kind<integral::Subpixels::Order>());
    if (subpixels != integral::Subpixels::cells)
        return;
    parser.Parse_Begin();
    subpixels.pattern = Parse_Kind<integral::CellPattern>();
    while (Next_Word() != "}" && parser.Token.Token_Id != END_OF_FILE_TOKEN)
    {
        if (subpixels.number == integral::Subpixels::most_cells)
            parser.Error("A panel has at most %d cells, of three places each.",
                         integral::Subpixels::most_cells);
        for (integral::Vec2& place : subpixels.cell[subpixels.number])
        {
            if (Next_Word() == "}")
                parser.Error("A cell has three places <x, y>: red's, green's and blue's.");
            place = Parse_Pair(false);
            parser.Parse_Comma();
        }
        subpixels.number++;
    }
    parser.Parse_End();
    if (subpixels.number == 0)
        parser.Error("cells needs the places of red, green and blue in a pixel: three vectors <x, "
                     "y> a cell, in pixels.");
}

}
