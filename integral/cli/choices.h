// SPDX-License-Identifier: AGPL-3.0-or-later
// Tables of the keywords that options accept, with their meanings. Options are read by these
// tables, and bash completion offers their words.
#ifndef INTEGRAL_CLI_CHOICES_H
#define INTEGRAL_CLI_CHOICES_H

#include "integral/cli/values.h"
#include "integral/frame/picture_fit.h"
#include "integral/optics/camera_parameters.h"
#include "integral/panel/interlace.h"
#include "integral/panel/panel_images.h"
#include "integral/print/colour_profile.h"
#include "integral/print/page.h"
#include "integral/replay/arrange.h"
#include "integral/wireframe/wireframe.h"

#include <cstddef>

namespace integral {

template <class Meaning> struct Choice {
    const char* word;
    Meaning meaning;
};

/// The value that an option's keyword maps to. Throws UsageError with the table's words for others.
template <class Meaning, std::size_t count>
Meaning meaning_of(const char* option, const std::string& word,
                   const Choice<Meaning> (&choices)[count])
{
    std::vector<std::string> names;
    for (const auto& choice : choices) {
        if (word == choice.word)
            return choice.meaning;
        names.push_back(choice.word);
    }
    throw_usage(option, word, alternatives(names));
}

/// Marks on a page.
struct PageMarks {
    bool crop = false, registration = false, axis = false;
};

enum class Orientation { portrait, landscape, automatic };

// Each table belongs to the option of the same name.
inline constexpr Choice<LensModel> replay_lens_model_choices[] = {
    {"extended_pinhole", LensModel::extended_pinhole},
    {"pinhole", LensModel::pinhole},
    {"full", LensModel::full}};
inline constexpr Choice<EyePath> path_choices[] = {{"turntable", EyePath::turntable},
                                                   {"sweep", EyePath::sweep},
                                                   {"sway", EyePath::sway},
                                                   {"circle", EyePath::circle},
                                                   {"dolly", EyePath::dolly}};
inline constexpr Choice<Orientation> orientation_choices[] = {{"portrait", Orientation::portrait},
                                                              {"landscape", Orientation::landscape},
                                                              {"auto", Orientation::automatic}};
inline constexpr Choice<Fit> fit_choices[] = {
    {"contain", Fit::contain}, {"cover", Fit::cover}, {"stretch", Fit::stretch}};
/// Whether a lens's axis lies at the paper's middle.
inline constexpr Choice<bool> centre_choices[] = {{"lens", true}, {"picture", false}};
inline constexpr Choice<PageMarks> marks_choices[] = {{"crop", {true, false, false}},
                                                      {"registration", {false, true, false}},
                                                      {"axis", {false, false, true}},
                                                      {"all", {true, true, true}}};
inline constexpr Choice<Intent> intent_choices[] = {{"perceptual", Intent::perceptual},
                                                    {"relative", Intent::relative},
                                                    {"saturation", Intent::saturation},
                                                    {"absolute", Intent::absolute}};
inline constexpr Choice<WhiteInk> white_choices[] = {{"full", WhiteInk::full},
                                                     {"picture", WhiteInk::picture}};
/// Keywords of --halftone; whether it is grey.
inline constexpr Choice<bool> halftone_choices[] = {{"black", true}, {"colour", false}};
/// Keywords of --blend and --sampling.
inline constexpr Choice<Neighbours> neighbours_choices[] = {{"nearest", Neighbours::nearest},
                                                            {"linear", Neighbours::linear}};
inline constexpr Choice<PanelCard> card_choices[] = {{"views", PanelCard::views},
                                                     {"crosstalk", PanelCard::crosstalk},
                                                     {"colours", PanelCard::colours},
                                                     {"pitch", PanelCard::pitch}};
inline constexpr Choice<FaceStyle> faces_choices[] = {
    {"wire", FaceStyle::wire}, {"hidden", FaceStyle::hidden}, {"flat", FaceStyle::flat}};
/// Whether a mask's lenses are aspheric.
inline constexpr Choice<bool> shape_choices[] = {{"spherical", false}, {"aspheric", true}};

} // namespace integral

#endif
