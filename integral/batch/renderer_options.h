// SPDX-License-Identifier: AGPL-3.0-or-later
// Reads povray-integral's options from the words of a command line, as its own parser does.
#ifndef INTEGRAL_BATCH_RENDERER_OPTIONS_H
#define INTEGRAL_BATCH_RENDERER_OPTIONS_H

#include <string>
#include <vector>

namespace integral {

struct RendererOption {
    enum class Kind {
        keyword, ///< Width=300
        letters, ///< +W300, -D, +O"a file"
        path,    ///< settings ("quick.ini[draft]"), a scene, or a folder of include files
    };
    Kind kind = Kind::path;
    std::string name;  ///< the keyword, or the letters with what follows them, in the original
                       ///< case
    std::string value; ///< of a keyword; in quotation marks after letters; a path
    bool on = true;    ///< letters: after +, not -
};

/// The options in one word of the command line. POV-Ray splits the word at blanks outside quotation
/// marks, and removes both kinds of marks. A word that begins with Integral_Camera= is one option.
std::vector<RendererOption> renderer_options_in(const std::string& word);

/// The text in lower case, for comparing keywords.
std::string in_small_letters(std::string text);

/// A file's name for the command line, in quotation marks of a kind that the name does not contain.
std::string quoted(const std::string& name);

/// The text without surrounding quotation marks, if it has any.
std::string without_quotes(const std::string& text);

/// The name of an .ini file without its [SECTION].
std::string without_section(const std::string& name);

/// Whether povray-integral takes this for a scene's name: NAME.pov, NAME.ini, NAME.ini[SECTION], or
/// a name without an extension, to which it adds .pov.
bool names_scene(const std::string& name);

/// Whether this is the name of a settings file (.ini).
bool names_settings(const std::string& name);

/// Whether quoted() can pass on a name: not if it contains both kinds of quotation marks.
bool can_be_quoted(const std::string& name);

/// The reason why povray-integral cannot open a file of that name: letters outside of ASCII. Empty
/// if it can.
std::string unopenable_name(const std::string& name);

/// The values of the options with this keyword or, if `letters` is not empty, with these letters
/// before a value. Both names must be in lower case.
std::vector<std::string> values_of_option(const std::vector<std::string>& words,
                                          const std::string& keyword, const std::string& letters);

/// The last of values_of_option, which takes effect; "" if there is none.
std::string value_of_option(const std::vector<std::string>& words, const std::string& keyword,
                            const std::string& letters);

/// The reason why a manifest may not contain this word: the batch itself sets an option in the
/// word, or cannot use the option. Empty if the word is allowed.
std::string refused_renderer_option(const std::string& word);

} // namespace integral

#endif
