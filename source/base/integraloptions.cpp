// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included within base
#include "configbase.h"
#include "base/integraloptions.h"
#include "base/integralclipping.h"
#include "base/integralframe.h"
#include "base/integralmsgid.h"
#include "base/integralpicture.h"
#include "base/povmscpp.h"
#include "base/povmsgid.h"
#include "base/stringutilities.h"
#include "base/types.h"
#include "integral/base/file_bytes.h"
#include "integral/reconstruction/pass_schedule.h"
#include "integral/reconstruction/refinement.h"
#include "integral/sheet/panel_quilt.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <stdexcept>

// this must be the last file included
#include "base/povdebug.h"

namespace pov_base
{

namespace
{

integral::Encoding Encoding_Of(int type, double gamma)
{
    integral::Encoding encoding;
    encoding.kind = type == kPOVList_GammaType_Neutral    ? integral::Encoding::Kind::linear
                    : type == kPOVList_GammaType_PowerLaw ? integral::Encoding::Kind::power
                                                          : integral::Encoding::Kind::srgb;
    if (encoding.kind == integral::Encoding::Kind::power)
        encoding.gamma = gamma;
    return encoding;
}

std::string Lower_Case(std::string text)
{
    for (char& letter : text)
        letter = char(std::tolower((unsigned char)letter));
    return text;
}

/// The truth value of a lower-case text by POV-Ray's rules; nothing if it has none.
std::optional<bool> Yes_Or_No(const std::string& text)
{
    if (text == "on" || text == "true" || text == "yes")
        return true;
    if (text == "off" || text == "false" || text == "no")
        return false;
    return std::nullopt;
}

/// The number in a text that consists of a number and optionally `unit`; 0 for any other text.
double Number_In(const std::string& text, const std::string& unit)
{
    char *end = NULL;
    const double number = std::strtod(text.c_str(), &end);
    return end != text.c_str() && (*end == '\0' || std::string(end) == unit) &&
                   std::isfinite(number)
               ? number
               : 0;
}

void Read_Sharing(const std::string& text, IntegralRenderOptions& result)
{
    if (text.empty() || text == "auto")
        return;
    if (const auto on = Yes_Or_No(text))
        result.sharing = *on ? IntegralSharing::on : IntegralSharing::off;
    else if (const double cells = Number_In(text, ""); cells >= 1 && cells <= 10000)
    {
        result.sharing = IntegralSharing::on;
        result.patches_in_beam = cells;
    }
    else
        throw std::invalid_argument(
            "Integral_Sharing=" + text +
            " is not auto, on, off or a number of patches in a pixel's beam, "
            "from 1 to 10000");
}

/// The number of Integral_Draft=; 1 for an empty text.
int Draft_In(const std::string& text)
{
    const double number = text.empty() ? 1 : Number_In(text, "");
    if (!(number >= 1 && number <= 100 && number == std::floor(number)))
        throw std::invalid_argument("Integral_Draft=" + text +
                                    " is not a whole number from 1 to 100: how many times fewer "
                                    "pixels the draft has across and down");
    return int(number);
}

/// The number of depth budgets of Integral_Fit=, 0 for off; nothing for an empty text.
std::optional<double> Fit_In(const std::string& text)
{
    constexpr double budgets = 2; // for `on`: the ends of the depth are soft
    if (text.empty())
        return std::nullopt;
    if (const auto on = Yes_Or_No(text))
        return *on ? budgets : 0;
    const double number = Number_In(text, "");
    if (!(number >= 0.1 && number <= 100))
        throw std::invalid_argument("Integral_Fit=" + text +
                                    " is not on, off or how many depth budgets the scene may reach "
                                    "either side of the sheet, from 0.1 to 100");
    return number;
}

/// Whether the option selects anti-aliasing in the light field.
bool Read_Antialiasing(const std::string& text)
{
    if (!text.empty() && text != "light_field" && text != "pixels")
        throw std::invalid_argument("Integral_Antialiasing=" + text +
                                    " is neither light_field nor pixels (POV-Ray's own)");
    return text != "pixels";
}

bool Read_Reconstruction(const std::string& text)
{
    const auto on = text.empty() ? std::optional<bool>(true) : Yes_Or_No(text);
    if (!on)
        throw std::invalid_argument("Integral_Reconstruction=" + text + " is neither on nor off");
    return *on;
}

/// The approximate number of samples that anti-aliasing takes in a pixel with a black and white
/// edge.
double Samples_At_Edges(POVMS_Object& options)
{
    if (!options.TryGetBool(kPOVAttrib_Antialias, false))
        return 1;
    const integral::RefinementRule rule = {
        options.TryGetInt(kPOVAttrib_SamplingMethod, 1),
        options.TryGetFloat(kPOVAttrib_AntialiasThreshold, 0.3f),
        std::min(9, std::max(1, options.TryGetInt(kPOVAttrib_AntialiasDepth, 3)))};
    return integral::samples_at_edges(rule);
}

void Check_Writable(const std::string& keyword, const std::string& file)
{
    const std::string error = Find_Write_Error(file);
    if (!error.empty())
        throw std::invalid_argument(keyword + "=" + file + " cannot be written there: " + error);
}

void Check_Depth_Picture(const std::string& file)
{
    const std::string ending = ".exr";
#ifdef OPENEXR_MISSING
    throw std::invalid_argument("Integral_Depth_Image=" + file +
                                " cannot be written: this program was built without OpenEXR");
#endif
    if (file.size() <= ending.size() ||
        file.compare(file.size() - ending.size(), ending.size(), ending) != 0)
        throw std::invalid_argument("Integral_Depth_Image=" + file +
                                    " is not an OpenEXR file: its name has to end in .exr");
    Check_Writable("Integral_Depth_Image", file);
}

void Check_Error_Picture(const std::string& file, bool audit)
{
    if (!audit)
        throw std::invalid_argument("Integral_Error_Image is a picture of the audit's errors, "
                                    "which Integral_Audit=off leaves out");
    const std::string ending = integral::extension_of(file);
    if (ending != "png" && ending != "exr")
        throw std::invalid_argument("Integral_Error_Image=" + file +
                                    ": its name has to end in .png or .exr");
    Check_Writable("Integral_Error_Image", file);
}

/// `height`: height of the frame, pixels; 0 if unknown.
void Read_Rows(const std::string& text, int height, IntegralRows& rows)
{
    if (text.empty())
        return;
    int first = 0, last = 0, end = 0;
    const bool two = std::sscanf(text.c_str(), "%9d ,%9d %n", &first, &last, &end) == 2 &&
                     end == int(text.size());
    if (!two || first < 1 || last < first)
        throw std::invalid_argument(
            "Integral_Rows=" + text +
            " is not the first and the last row that count, as in 33,64: the top one is 1");
    if (height > 0 && last > height)
        throw std::invalid_argument("Integral_Rows=" + text + " ends below the frame, which has " +
                                    std::to_string(height) + " rows");
    rows = {first - 1, last - 1};
}

/// Reads Integral_Phase=: the part of the viewing zone that is rendered.
void Read_Phase(const std::string& text, IntegralRenderOptions& result)
{
    if (text.empty())
        return;
    double first = 0, last = 0;
    int end = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf%n", &first, &last, &end) != 2 ||
        end != int(text.size()) || !(first >= 0 && first < last && last <= 1))
        throw std::invalid_argument("Integral_Phase=" + text +
                                    " is not a part of the viewing zone, from 0 at the left (or "
                                    "below, for lenses that lie across) to 1, as in 0,0.5");
    if (result.antialias && !result.light_field)
        throw std::invalid_argument("Integral_Phase with +A does not work with "
                                    "Integral_Antialiasing=pixels; leave one of them out");
    result.phase = integral::Vec2{first, last};
}

/// Reads Integral_Quilt=, and rejects options that apply to frames only. `height`: height of the
/// picture, pixels; 0 if not known yet.
void Read_Quilt(const std::string& text, POVMS_Object& options, int height,
                IntegralRenderOptions& result)
{
    if (text.empty())
        return;
    const auto views = integral::views_in(text);
    if (!views)
        throw std::invalid_argument("Integral_Quilt=" + text +
                                    " is not the views across and up, each from 1 to 256, as in "
                                    "8x6");
    const integral::ViewGrid grid = *views;
    const int width = options.TryGetInt(kPOVAttrib_Width, grid.columns);
    if (height > 0 && (width < grid.columns || height < grid.rows))
        throw std::invalid_argument("Integral_Quilt=" + text + ": a picture of " +
                                    std::to_string(width) + "x" + std::to_string(height) +
                                    " pixels has no room for so many views; give a larger +W and "
                                    "+H");
    const char *const other = result.sharing == IntegralSharing::on ? "Integral_Sharing"
                              : options.Exist(kIntegralAttrib_Rows) ? "Integral_Rows"
                              : result.phase                        ? "Integral_Phase"
                                                                    : nullptr;
    if (other)
        throw std::invalid_argument("Integral_Quilt does not work with " + std::string(other) +
                                    ", which is of a frame; leave one of them out");
    if (result.antialias && !result.light_field && result.method == 2)
        throw std::invalid_argument(
            "Integral_Quilt with Integral_Antialiasing=pixels does not work "
            "with +AM2, whose samples at the corners of pixels would mix "
            "neighbouring views; use +AM1");
    result.quilt = grid;
}

void Read_Audit(const std::string& text, IntegralRenderOptions& result)
{
    if (text.empty())
        return;
    if (const auto on = Yes_Or_No(text))
    {
        result.audit = *on;
        return;
    }
    const double percent = Number_In(text, "%");
    if (!(percent > 0 && percent <= 100))
        throw std::invalid_argument(
            "Integral_Audit=" + text +
            " is not on, off or a percentage of the lit pixels, greater than 0 "
            "and up to 100");
    result.audit_share = percent / 100;
}

}

/// Whether the output file holds light outside 0...1.
static bool Is_High_Dynamic_Range(POVMS_Object& options)
{
    const int file = options.TryGetInt(kPOVAttrib_OutputFileType, kPOVList_FileType_PNG);
    return file == kPOVList_FileType_OpenEXR || file == kPOVList_FileType_RadianceHDR;
}

IntegralClipping Read_Integral_Clipping(POVMS_Object& options)
{
    if (Is_High_Dynamic_Range(options))
        return IntegralClipping::none;
    return options.TryGetBool(kPOVAttrib_GrayscaleOutput, false) ? IntegralClipping::brightness
                                                                 : IntegralClipping::colours;
}

IntegralRenderOptions Read_Integral_Options(POVMS_Object& options, int height)
{
    IntegralRenderOptions result;
    const auto text = [&](POVMSType key)
    { return UCS2toASCIIString(options.TryGetUCS2String(key, "")); };
    const auto word = [&](POVMSType key) { return Lower_Case(text(key)); };
    Read_Audit(word(kIntegralAttrib_Audit), result);
    Read_Sharing(word(kIntegralAttrib_Sharing), result);
    result.seed = std::uint64_t(std::int64_t(options.TryGetInt(kIntegralAttrib_Seed, 0)));
    result.error_picture = text(kIntegralAttrib_ErrorPicture);
    if (!result.error_picture.empty())
        Check_Error_Picture(result.error_picture, result.audit);
    result.edge_samples = Samples_At_Edges(options);
    result.depth_picture = text(kIntegralAttrib_DepthPicture);
    if (!result.depth_picture.empty())
        Check_Depth_Picture(result.depth_picture);
    Read_Rows(text(kIntegralAttrib_Rows), height, result.rows);
    result.light_field = Read_Antialiasing(word(kIntegralAttrib_Antialiasing));
    result.threshold = options.TryGetFloat(kPOVAttrib_AntialiasThreshold, float(result.threshold));
    result.reconstruct = Read_Reconstruction(word(kIntegralAttrib_Reconstruction));
    result.block_side = integral::block_side_of(
        options.TryGetInt(kPOVAttrib_RenderBlockSize, result.block_side));
    result.displayed = options.TryGetBool(kPOVAttrib_Display, result.displayed);
    result.continued = options.Exist(kPOVAttrib_PixelSkipList) ||
                       options.TryGetInt(kPOVAttrib_PixelId, 0) > 0;
    result.method = options.TryGetInt(kPOVAttrib_SamplingMethod, 1);
    result.antialias = options.TryGetBool(kPOVAttrib_Antialias, false) && result.method > 0;

    Read_Phase(text(kIntegralAttrib_Phase), result);
    Read_Quilt(word(kIntegralAttrib_Quilt), options, height, result);

    result.output.working = Encoding_Of(
        options.TryGetInt(kPOVAttrib_WorkingGammaType, DEFAULT_WORKING_GAMMA_TYPE),
        options.TryGetFloat(kPOVAttrib_WorkingGamma, DEFAULT_WORKING_GAMMA));
    if (Is_High_Dynamic_Range(options))
        result.output.file.kind = integral::Encoding::Kind::linear;
    else
        result.output.file = Encoding_Of(
            options.TryGetInt(kPOVAttrib_FileGammaType, kPOVList_GammaType_SRGB),
            options.TryGetFloat(kPOVAttrib_FileGamma, 2.2f));
    return result;
}

std::shared_ptr<const IntegralSceneOptions> Read_Integral_Scene_Options(POVMS_Object& options)
{
    IntegralSceneOptions result;
    const auto text = [&](POVMSType key)
    { return UCS2toASCIIString(options.TryGetUCS2String(key, "")); };
    result.camera = text(kIntegralAttrib_Camera);
    result.sheet = text(kIntegralAttrib_Sheet);
    result.free_width = options.TryGetBool(kIntegralAttrib_FreeWidth, false);
    result.free_height = options.TryGetBool(kIntegralAttrib_FreeHeight, false);
    try
    {
        if (const std::string error = text(kIntegralAttrib_TargetError); !error.empty())
            throw std::invalid_argument("Integral_Target_Error=" + error +
                                        " stands in an INI file; give it on the command line, from "
                                        "which it looks for the settings before the render");
        result.draft = Draft_In(text(kIntegralAttrib_Draft));
        result.fit = Fit_In(Lower_Case(text(kIntegralAttrib_Fit)));
        const bool size_is_known = result.draft == 1 && !result.free_height;
        const IntegralRenderOptions given = Read_Integral_Options(
            options, size_is_known ? options.TryGetInt(kPOVAttrib_Height, 0) : 0);
        IntegralFrame::Set_Part(given.quilt, given.phase);
        result.quilt = given.quilt.has_value();
    }
    catch (const std::invalid_argument& problem)
    {
        result.problem = problem.what();
    }
    result.problem_with_any_camera = text(kIntegralAttrib_PanelProblem);
    const std::string metadata = Lower_Case(text(kIntegralAttrib_Metadata));
    if (!metadata.empty() && metadata != "full" && metadata != "repeatable")
        result.problem_with_any_camera =
            "Integral_Metadata=" + metadata +
            " is neither full nor repeatable (without date, machine and run time)";
    IntegralFrame::Set_Repeatable(metadata == "repeatable");
    return std::make_shared<IntegralSceneOptions>(result);
}

unsigned int Integral_Bounding(POVMS_Object& options, unsigned int method)
{
    return method == 1 && !options.Exist(kPOVAttrib_BoundingMethod) ? integral_bounding_open
                                                                    : method;
}

}
