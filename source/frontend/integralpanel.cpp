// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included
#include "base/configbase.h"
#include "frontend/integralpanel.h"
#include "base/integralmsgid.h"
#include "base/povmsgid.h"
#include "base/stringutilities.h"
#include "integral/base/number_text.h"
#include "integral/sheet/panel_render.h"

#include <cctype>
#include <exception>
#include <optional>
#include <regex>
#include <string>
#include <vector>

// this must be the last file included
#include "base/povdebug.h"

namespace pov_frontend
{

using namespace pov_base;

namespace
{

/// The text of an option; "" if it is not given.
std::string Text_Of(POVMSObject& options, POVMSType key)
{
    int length = 0;
    if (POVMSUtil_GetUCS2StringLength(&options, key, &length) != kNoErr || length < 1)
        return "";
    std::vector<UCS2> text(std::size_t(length) + 1);
    length = int(text.size());
    if (POVMSUtil_GetUCS2String(&options, key, text.data(), &length) != kNoErr)
        return "";
    return UCS2toASCIIString(text.data());
}

void Set_Text(POVMSObject& options, POVMSType key, const std::string& text)
{
    POVMSUtil_SetUCS2String(&options, key, ASCIItoUCS2String(text.c_str()).c_str());
}

std::optional<int> Number_Of(POVMSObject& options, POVMSType key)
{
    POVMSInt value = 0;
    if (POVMSUtil_GetInt(&options, key, &value) != kNoErr)
        return std::nullopt;
    return int(value);
}

std::string Lower_Case(std::string text)
{
    for (char& letter : text)
        letter = char(std::tolower((unsigned char)letter));
    return text;
}

/// Whether a word of the camera is among words.
bool Has_Word(const std::string& words, const char *word)
{
    return std::regex_search(words, std::regex(std::string("\\b") + word + "\\b"));
}

void Set(POVMSObject& options, const integral::PanelRender& render)
{
    const std::string words = Text_Of(options, kIntegralAttrib_Camera);
    const std::string fit = Has_Word(words, "fit") || Has_Word(words, "move_eye")
                                ? ""
                                : " " + render.fit;
    Set_Text(options, kIntegralAttrib_Camera, render.camera + fit + " " + words);
    if (render.quilt)
        Set_Text(options, kIntegralAttrib_Quilt,
                 integral::size_text(render.quilt->columns, render.quilt->rows));
    POVMSUtil_SetInt(&options, kPOVAttrib_Width, render.size.width);
    POVMSUtil_SetInt(&options, kPOVAttrib_Height, render.size.height);
}

}

void Use_Integral_Panel(POVMSObject& options)
{
    const std::string panel = Text_Of(options, kIntegralAttrib_Panel);
    const std::string quilt = Lower_Case(Text_Of(options, kIntegralAttrib_Quilt));
    if (panel.empty() && !integral::quilt_size(quilt))
        return;
    POVMSObject_Remove(&options, kIntegralAttrib_Panel);
    try
    {
        Set(options,
            integral::panel_render({panel, quilt, Number_Of(options, kPOVAttrib_Width),
                                    Number_Of(options, kPOVAttrib_Height)}));
    }
    catch (const std::exception& problem)
    {
        Set_Text(options, kIntegralAttrib_PanelProblem, problem.what());
    }
}

}
