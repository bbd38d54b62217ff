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
    std::string name;  ///< the keyword, or the letters with what follows them: as written, in any
                       ///< case
    std::string value; ///< of a keyword; in quotation marks after letters; a path
    bool on = true;    ///< letters: after +, not -
};

/// The options in one word of the command line: POV-Ray splits it at blanks that are not in
/// quotation marks, and takes both kinds of marks away. A word that begins with Integral_Camera= is
/// one option.
std::vector<RendererOption> renderer_options_in(const std::string& word);

/// A text in small letters, as keywords are compared.
std::string in_small_letters(std::string text);

/// A file's name for the command line: in quotation marks of a kind that it does not have.
std::string quoted(const std::string& name);

/// A text without the quotation marks around it, if it has any.
std::string without_quotes(const std::string& text);

/// The name of an .ini file without its [SECTION].
std::string without_section(const std::string& name);

/// Whether povray-integral takes this for a scene's name: NAME.pov, NAME.ini, NAME.ini[SECTION], or
/// without an extension, to which it adds .pov.
bool names_scene(const std::string& name);

/// Whether that name is one of settings (.ini).
bool names_settings(const std::string& name);

/// Whether quoted() can pass a name on: one with both kinds of quotation marks cannot be.
bool can_be_quoted(const std::string& name);

/// Why povray-integral cannot open a file of that name: it has letters outside of ASCII. Empty if it
/// can.
std::string unopenable_name(const std::string& name);

/// The values of the options that are this keyword or, where `letters` is not empty, these letters
/// with a value behind them. Both names in small letters.
std::vector<std::string> values_of_option(const std::vector<std::string>& words,
                                          const std::string& keyword, const std::string& letters);

/// The last of these, which is the one that counts; "" if there is none.
std::string value_of_option(const std::vector<std::string>& words, const std::string& keyword,
                            const std::string& letters);

/// Why a manifest may not have this word: the batch gives one of its options itself or has no use
/// for it. Empty if it may.
std::string refused_renderer_option(const std::string& word);

} // namespace integral

#endif
