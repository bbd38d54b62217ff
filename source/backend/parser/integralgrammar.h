// SPDX-License-Identifier: AGPL-3.0-or-later
// The words of the integral camera. They mean something only inside `camera { integral ... }` (and
// in Integral_Camera=), whatever the scene has declared them as; nothing is reserved.
#ifndef POVRAY_BACKEND_INTEGRALGRAMMAR_H
#define POVRAY_BACKEND_INTEGRALGRAMMAR_H

#include <memory>
#include <string>
#include <vector>

#include "integral/optics/subpixels.h"

namespace pov
{

class Camera;
class Parser;
struct IntegralStatement;

class IntegralGrammar
{
public:
    /// The grammar of a parser, made at the first call.
    static IntegralGrammar& Of(Parser& parser);

    /// Reads the words of the INI option Integral_Camera=, if there are any. To be called
    /// once the tokenizer stands before the scene's first token.
    void Parse_Option();

    /// `integral` among the camera types: takes it on if it is next.
    void Parse_Type(Camera& camera);

    /// One word of an integral camera: parses it and returns true if it is next.
    bool Parse_Modifier(Camera& camera);

    /// To be called while camera.Look_At still tells whether look_at was given (HUGE_VAL in
    /// its x: it was not), and where it was.
    void Note_Look_At(Camera& camera);

    /// To be called with the camera's vectors settled, before its transforms are applied.
    void Settle(Camera& camera);

    /// To be called at the end of a camera statement: refuses what cannot work.
    void Check(Camera& camera);

    /// To be called once the scene is parsed, with the camera that is to be rendered: applies
    /// Integral_Camera= to a scene without a camera, and says what the user should know.
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
    bool Parse_Flag();
    void Apply_Option(IntegralStatement& statement);
    bool Frame_Size(int& width, int& height);
    void Warn(const Camera& camera);

    Parser& parser;
    std::shared_ptr<IntegralStatement> option; ///< the words of Integral_Camera=, or nothing
    const char *reading = "";                  ///< the word whose value is being read
    int option_level = 0; ///< depth of its text among the include files, while it is read
};

}

#endif
