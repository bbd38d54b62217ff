// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included within base
#include "configbase.h"
#include "base/integralpicture.h"
#include "base/fileinputoutput.h"
#include "base/image/encoding.h"
#include "base/image/image.h"
#include "base/stringutilities.h"
#include "base/types.h"

#include <cstdio>
#include <memory>

// this must be the last file included
#include "base/povdebug.h"

namespace pov_base
{

static std::string Beside(const std::string& file) { return file + ".tmp"; }

bool May_Write_Integral_Picture(const std::string& file)
{
    std::FILE *stream = std::fopen(Beside(file).c_str(), "wb");
    if (stream == NULL)
        return false;
    std::fclose(stream);
    std::remove(Beside(file).c_str());
    return true;
}

bool Write_Integral_Picture(const std::string& file, int width, int height, const std::vector<double>& values)
{
    const bool exr = file.size() > 4 && file.compare(file.size() - 4, 4, ".exr") == 0;
    const std::unique_ptr<Image> image(Image::Create(width, height, Image::RGB_Int16, false));
    std::size_t index = 0;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++, index++)
            image->SetRGBValue(x, y, float(values[index]), float(values[index]), float(values[index]));
    Image::WriteOptions options;
    options.bpcc = 16;
    options.encodingGamma = SRGBGammaCurve::Get();
    options.workingGamma = NeutralGammaCurve::Get();
    options.dither = GetNoOpDitherHandler();
    bool good = false;
    try
    {
        const std::unique_ptr<OStream> stream(NewOStream(ASCIItoUCS2String(Beside(file).c_str()).c_str(),
                                                         exr ? POV_File_Image_EXR : POV_File_Image_PNG, false));
        if (stream)
        {
            Image::Write(exr ? Image::EXR : Image::PNG, stream.get(), image.get(), options);
            good = bool(*stream);
        }
    }
    catch (pov_base::Exception&)
    {
    }
    good = good && std::rename(Beside(file).c_str(), file.c_str()) == 0;
    if (!good)
        std::remove(Beside(file).c_str());
    return good;
}

}
