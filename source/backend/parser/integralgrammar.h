// SPDX-License-Identifier: AGPL-3.0-or-later
// Parses the words of the integral camera. They have a meaning only inside `camera { integral ...
// }` and in Integral_Camera=, even if the scene declares identifiers of the same names; none is a
// reserved word.
#ifndef POVRAY_BACKEND_INTEGRALGRAMMAR_H
#define POVRAY_BACKEND_INTEGRALGRAMMAR_H

#include <memory>
#include <string>
#include <vector>

#include "backend/frame.h"
#include "integral/frame/frame_metadata.h"

namespace pov
{

class Camera;
class Parser;
struct IntegralStatement;

class IntegralGrammar
{
public:
    /// The grammar of a parser, created at the first call.
    static IntegralGrammar& Of(Parser& parser);

    /// Reads the INI options Integral_Camera= and Integral_Sheet=, if they are given. Call it
    /// before the scene's first token is read.
    void Parse_Option();

    /// Reads the camera type `integral` if it is the next token.
    void Parse_Type(Camera& camera);

    /// If the next token is a word of the integral camera, parses it with its value and returns
    /// true.
    bool Parse_Modifier(Camera& camera);

    /// Records the look_at point. Call it while camera.Look_At still has the value that was given,
    /// or HUGE_VAL in x if none was.
    void Note_Look_At(Camera& camera);

    /// Applies Integral_Camera= and computes the sheet's distance. Call it when the camera's
    /// vectors are final, before its transforms are applied.
    void Settle(Camera& camera);

    /// Records where the statement ends, for errors. Call it at the end of a camera statement.
    void End(Camera& camera);

    /// Applies Integral_Camera= to a scene without a camera statement, reports errors for settings
    /// that cannot work together, and prints warnings. Call it after the scene is parsed, with the
    /// camera that will be rendered.
    void Finish(Camera& camera);

private:
    explicit IntegralGrammar(Parser& parser) : parser(parser) {}

    struct Word;
    static const std::vector<Word>& Words();
    static const Word *Find_Word(const std::string& name);
    static std::string List_Of_Words();

    std::string Next_Word();
    bool Accept(const char *word);
    IntegralStatement& Edit(Camera& camera);
    void Begin(Camera& camera);
    bool Parse_Word(IntegralStatement& statement);
    void Parse_Lens_Sheet(IntegralStatement& statement);
    void Parse_Film(IntegralStatement& statement);
    void Parse_Subpixels(integral::Subpixels& subpixels);
    void Give(IntegralStatement& statement, const std::string& word);
    void Check_Value(const IntegralStatement& statement);
    template <class Kind> Kind Parse_Kind();
    integral::Vec2 Parse_Pair(bool promote);
    int Parse_Count();
    double Parse_Number();
    integral::Vec2 Parse_Vector();
    integral::ProjectionWords Parse_Projection();
    bool Parse_Flag();
    void Apply_Option(IntegralStatement& statement);
    void Parse_Text(const std::string& text);
    void Use_Print_Size();
    void Use_View_Shape();
    void Use_Trimmed_Shape();
    integral::LensSheet Read_Sheet(const UCS2String& file);
    bool Frame_Size(const IntegralStatement& statement, integral::PixelSize& size);
    void Refuse(const IntegralStatement& statement, const std::string& message);
    void Check_Camera(Camera& camera);
    void Check_Type(const Camera& camera, const IntegralStatement& statement);
    void Use_Visual_Pitch(IntegralStatement& statement);
    void Check_Print_Size(const IntegralStatement& statement, integral::PixelSize size);
    void Make_Optics(Camera& camera, IntegralStatement& statement);
    std::shared_ptr<const integral::IntegralCamera> Print_Optics(const Camera& camera);
    void Fit_Depth(Camera& camera, const integral::IntegralCamera& print,
                   const std::vector<double>& distances);
    void Warn_Of_No_Eye();
    void Warn_Of_Depth(const integral::IntegralCamera& optics, const std::vector<double>& distances,
                       double reach, bool orthographic);
    void Warn(const Camera& camera, const std::vector<double>& distances);
    void Warn_Of_Shape(const Camera& camera);
    void Warn_Of_Scale(const integral::IntegralCamera& optics);
    void Warn_Of_Eye(const IntegralStatement& statement);
    void Warn_Of_Film(const integral::IntegralCamera& optics);
    void Warn_Of_Draft(const IntegralStatement& statement);
    void Warn_Of_Starts(const integral::IntegralCamera& optics);
    void Warn_Of_Infinity(const integral::IntegralCamera& optics,
                          const std::vector<double>& distances);
    void Warn_Of_Place(const Camera& camera, std::vector<double> distances);

    Parser& parser;
    std::shared_ptr<IntegralStatement> option; ///< the words of Integral_Camera=, or null
    const char *reading = "";                  ///< the word whose value is being read
    int option_level = 0;                      ///< include file level of Integral_Camera='s text while it is
                                               ///< read
};

}

#endif
