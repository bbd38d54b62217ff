// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included within base
#include "configbase.h"
#include "base/integralpicture.h"
#include "base/fileinputoutput.h"
#include "base/image/encoding.h"
#include "base/image/image.h"
#include "base/image/integralmetadata.h"
#include "base/stringutilities.h"
#include "base/types.h"
#include "integral/base/file_bytes.h"
#include "integral/base/unfinished_file.h"

#include <cmath>
#include <cstdio>
#include <memory>

#ifndef OPENEXR_MISSING
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#endif

// this must be the last file included
#include "base/povdebug.h"

namespace pov_base
{

bool May_Write_Integral_Picture(const std::string& file)
{
    const integral::UnfinishedFile unfinished(file);
    std::FILE *stream = std::fopen(unfinished.name().c_str(), "wb");
    if (stream == NULL)
        return false;
    std::fclose(stream);
    return true;
}

bool Write_Integral_Picture(const std::string& file, int width, int height,
                            const std::vector<double>& values)
{
    const bool exr = integral::extension_of(file) == "exr";
    const std::unique_ptr<Image> image(Image::Create(width, height, Image::RGB_Int16, false));
    std::size_t index = 0;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++, index++)
            image->SetRGBValue(x, y, float(values[index]), float(values[index]),
                               float(values[index]));
    Image::WriteOptions options;
    options.bpcc = 16;
    options.encodingGamma = SRGBGammaCurve::Get();
    options.workingGamma = NeutralGammaCurve::Get();
    options.dither = GetNoOpDitherHandler();
    integral::UnfinishedFile unfinished(file);
    try
    {
        std::unique_ptr<OStream> stream(
            NewOStream(ASCIItoUCS2String(unfinished.name().c_str()).c_str(),
                       exr ? POV_File_Image_EXR : POV_File_Image_PNG, false));
        if (!stream)
            return false;
        Image::Write(exr ? Image::EXR : Image::PNG, stream.get(), image.get(), options);
        if (!*stream)
            return false;
    }
    catch (pov_base::Exception&)
    {
        return false;
    }
    return unfinished.finish() == 0;
}

bool Write_Integral_Depth(const std::string& file, int width, int height,
                          const std::vector<float>& depths)
{
#ifdef OPENEXR_MISSING
    return false;
#else
    std::vector<float> z(depths), alpha(depths.size());
    for (std::size_t index = 0; index < depths.size(); index++)
    {
        alpha[index] = std::isnan(depths[index]) ? 0.0f : 1.0f;
        if (std::isnan(depths[index]))
            z[index] = 0;
    }
    integral::UnfinishedFile unfinished(file);
    try
    {
        Imf::Header header(width, height);
        Set_Integral_EXR(header);
        header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
        header.channels().insert("A", Imf::Channel(Imf::FLOAT));
        Imf::FrameBuffer buffer;
        const std::size_t step = sizeof(float);
        buffer.insert(
            "Z", Imf::Slice(Imf::FLOAT, reinterpret_cast<char *>(z.data()), step, step * width));
        buffer.insert("A", Imf::Slice(Imf::FLOAT, reinterpret_cast<char *>(alpha.data()), step,
                                      step * width));
        Imf::OutputFile output(unfinished.name().c_str(), header);
        output.setFrameBuffer(buffer);
        output.writePixels(height);
    }
    catch (const std::exception&)
    {
        return false;
    }
    return unfinished.finish() == 0;
#endif
}

}
