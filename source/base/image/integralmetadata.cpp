// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included within base
#include "configbase.h"
#include "base/image/integralmetadata.h"
#include "base/integralframe.h"
#include "base/povmsgid.h"
#include "base/stringutilities.h"
#include "base/types.h"
#include "integral/base/file_bytes.h"

#include <cmath>
#include <string>

#ifndef LIBPNG_MISSING
#include <png.h>
#endif
#ifndef OPENEXR_MISSING
#include <ImfHeader.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#endif

// this must be the last file included
#include "base/povdebug.h"

namespace pov_base
{

namespace
{

/// The encoding of a file's samples; `by_default` if `curve` is null.
integral::Encoding Encoding_Of(const SimpleGammaCurvePtr& curve,
                               integral::Encoding::Kind by_default)
{
    integral::Encoding encoding;
    encoding.kind = by_default;
    if (curve)
        switch (curve->GetTypeId())
        {
        case kPOVList_GammaType_Neutral: encoding.kind = integral::Encoding::Kind::linear; break;
        case kPOVList_GammaType_PowerLaw:
            encoding.kind = integral::Encoding::Kind::power;
            encoding.gamma = curve->ApproximateDecodingGamma();
            break;
        default: encoding.kind = integral::Encoding::Kind::srgb;
        }
    return encoding;
}

}

bool Is_Repeatable() { return IntegralFrame::Repeatable(); }

void Set_Integral_PNG(png_struct_def *png, png_info_def *info, const Image::WriteOptions& options)
{
#ifndef LIBPNG_MISSING
    if (!IntegralFrame::Is_Active())
        return;
    if (const auto pitch = IntegralFrame::Pixel_Pitch())
        png_set_pHYs(png, info, png_uint_32(std::lround(1000 / pitch->x)),
                     png_uint_32(std::lround(1000 / pitch->y)), PNG_RESOLUTION_METER);

    std::string document = IntegralFrame::Document(
        Encoding_Of(options.encodingGamma, integral::Encoding::Kind::srgb));
    char keyword[] = "integral", empty[] = "";
    png_text text = {};
    text.compression = PNG_ITXT_COMPRESSION_NONE;
    text.key = keyword;
    text.text = &document[0];
    text.itxt_length = document.size();
    text.lang = empty;
    text.lang_key = empty;
    png_set_text(png, info, &text, 1);
#endif
}

#ifndef OPENEXR_MISSING
void Set_Integral_EXR(Imf::Header& header)
{
    if (!IntegralFrame::Is_Active())
        return;
    integral::Encoding linear;
    linear.kind = integral::Encoding::Kind::linear;
    header.insert("integral", Imf::StringAttribute(IntegralFrame::Document(linear)));
    if (const auto pitch = IntegralFrame::Pixel_Pitch())
    {
        Imf::addXDensity(header, float(integral::mm_per_inch / pitch->x));
        header.pixelAspectRatio() = float(pitch->x / pitch->y);
    }
}
#endif

void Write_Integral_Companion(const UCS2String& file, int file_type,
                              const Image::WriteOptions& options)
{
    if (!IntegralFrame::Is_Active() || file_type == Image::PNG || file_type == Image::EXR)
        return;
    const std::string picture = UCS2toASCIIString(file);
    if (picture == "-" || picture == "stdout" || picture == "stderr")
        return;
    const bool linear = file_type == Image::HDR;
    const std::string name = picture + ".json";
    const std::string document = IntegralFrame::Document(
        Encoding_Of(options.encodingGamma,
                    linear ? integral::Encoding::Kind::linear : integral::Encoding::Kind::srgb));
    try
    {
        integral::write_file(name, document);
    }
    catch (const integral::OutputError&)
    {
        throw POV_EXCEPTION(kFileDataErr, "Cannot write the frame's geometry to " + name);
    }
}

}
