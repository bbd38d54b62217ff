// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included within base
#include "configbase.h"
#include "base/integraloptions.h"
#include "base/integralmsgid.h"
#include "base/integralpicture.h"
#include "base/povmscpp.h"
#include "base/povmsgid.h"
#include "base/stringutilities.h"
#include "base/types.h"

#include <cctype>
#include <cstdlib>
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
    encoding.kind = type == kPOVList_GammaType_Neutral ? integral::Encoding::Kind::linear
                  : type == kPOVList_GammaType_PowerLaw ? integral::Encoding::Kind::power
                  : integral::Encoding::Kind::srgb;
    if (encoding.kind == integral::Encoding::Kind::power)
        encoding.gamma = gamma;
    return encoding;
}

void Read_Audit(std::string text, IntegralRenderOptions& result)
{
    for (char& letter : text)
        letter = char(std::tolower((unsigned char)letter));
    if (text.empty() || text == "on" || text == "true" || text == "yes")
        return;
    if (text == "off" || text == "false" || text == "no")
    {
        result.audit = false;
        return;
    }
    char *end = NULL;
    const double percent = std::strtod(text.c_str(), &end);
    if (std::string(end) == "%")
        end++;
    if (end == text.c_str() || *end != '\0' || !(percent > 0 && percent <= 100))
        throw std::invalid_argument("Integral_Audit=" + text + " is not on, off or a percentage of the lit pixels, greater than 0 "
                                    "and up to 100");
    result.audit_share = percent / 100;
}

}

IntegralRenderOptions Read_Integral_Options(POVMS_Object& options)
{
    IntegralRenderOptions result;
    const auto text = [&](POVMSType key) { return UCS2toASCIIString(options.TryGetUCS2String(key, "")); };
    Read_Audit(text(kIntegralAttrib_Audit), result);
    result.seed = std::uint64_t(std::int64_t(options.TryGetInt(kIntegralAttrib_Seed, 0)));
    result.error_picture = text(kIntegralAttrib_ErrorPicture);
    if (!result.error_picture.empty() && !result.audit)
        throw std::invalid_argument("Integral_Error_Image is a picture of the audit's errors, which Integral_Audit=off leaves out");
    if (!result.error_picture.empty() && !May_Write_Integral_Picture(result.error_picture))
        throw std::invalid_argument("Integral_Error_Image=" + result.error_picture + " cannot be written there");
    result.antialias = options.TryGetBool(kPOVAttrib_Antialias, false);

    result.output.working = Encoding_Of(options.TryGetInt(kPOVAttrib_WorkingGammaType, DEFAULT_WORKING_GAMMA_TYPE),
                                        options.TryGetFloat(kPOVAttrib_WorkingGamma, DEFAULT_WORKING_GAMMA));
    const int file = options.TryGetInt(kPOVAttrib_OutputFileType, kPOVList_FileType_PNG);
    if (file == kPOVList_FileType_OpenEXR || file == kPOVList_FileType_RadianceHDR)
        result.output.file.kind = integral::Encoding::Kind::linear;
    else
        result.output.file = Encoding_Of(options.TryGetInt(kPOVAttrib_FileGammaType, kPOVList_GammaType_SRGB),
                                         options.TryGetFloat(kPOVAttrib_FileGamma, 2.2f));
    return result;
}

std::string Problem_Of_Integral_Options(POVMS_Object& options)
{
    try
    {
        Read_Integral_Options(options);
        return "";
    }
    catch (const std::invalid_argument& problem)
    {
        return problem.what();
    }
}

}
