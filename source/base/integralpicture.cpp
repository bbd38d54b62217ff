// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included within base
#include "configbase.h"
#include "base/integralpicture.h"
#include "base/fileinputoutput.h"
#include "base/image/encoding.h"
#include "base/image/image.h"
#include "base/image/integralmetadata.h"
#include "base/integralstream.h"
#include "base/stringutilities.h"
#include "base/types.h"
#include "integral/base/atomic_file.h"
#include "integral/base/file_bytes.h"
#include "integral/frame/depth_attribute.h"

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

#ifndef OPENEXR_MISSING
#include <ImfChannelList.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#endif

// this must be the last file included
#include "base/povdebug.h"

namespace pov_base
{

namespace
{

std::string Reason(int number) { return std::strerror(number); }

std::string Failed(const std::string& file, const std::string& reason)
{
    return file + ": cannot be written: " + reason;
}

#ifndef OPENEXR_MISSING
/// Lets OpenEXR write to a file that appears only when it is complete. OpenEXR's own destructors
/// hide errors; OutputFile reports them in finish().
class WholeEXR : public Imf::OStream
{
public:
    explicit WholeEXR(const std::string& name) : Imf::OStream(name.c_str()), file(name) {}
    void write(const char bytes[], int number) override
    {
        file.write(at, bytes, std::size_t(number));
        at += std::uint64_t(number);
    }
    auto tellp() -> decltype(std::declval<Imf::OStream&>().tellp()) override { return at; }
    void seekp(decltype(std::declval<Imf::OStream&>().tellp()) place) override { at = place; }
    void Finish() { file.finish(); }

private:
    integral::OutputFile file;
    std::uint64_t at = 0;
};
#endif

}

std::string Find_Write_Error(const std::string& file)
{
    if (!POV_ALLOW_FILE_WRITE(ASCIItoUCS2String(file.c_str()).c_str(), POV_File_Image_PNG))
        return "IO restrictions prohibit it";
    if (integral::is_special(file))
        return "it is a device or a pipe, and has to be a file";
    const integral::AtomicFile unfinished(file);
    return unfinished.name().empty() ? Reason(errno) : std::string();
}

std::string Write_Integral_Picture(const std::string& file, int width, int height,
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
    integral::AtomicFile unfinished(file);
    if (unfinished.name().empty())
        return Failed(file, Reason(errno));
    errno = 0;
    try
    {
        IntegralStream stream(exr ? POV_File_Image_EXR : POV_File_Image_PNG, unfinished.name());
        Image::Write(exr ? Image::EXR : Image::PNG, &stream, image.get(), options);
        if (!stream.Finish(true))
            return Failed(file, Reason(errno != 0 ? errno : EIO));
    }
    catch (const pov_base::Exception& problem)
    {
        return Failed(file, errno != 0 ? Reason(errno) : problem.what());
    }
    const int error = unfinished.finish();
    return error != 0 ? Failed(file, Reason(error)) : std::string();
}

std::string Write_Integral_Depth(const std::string& file, int width, int height,
                                 const std::vector<float>& depths,
                                 const std::vector<float>& distances)
{
#ifdef OPENEXR_MISSING
    return Failed(file, "this program was built without OpenEXR");
#else
    std::vector<float> z(depths), alpha(depths.size());
    for (std::size_t index = 0; index < depths.size(); index++)
    {
        alpha[index] = std::isnan(depths[index]) ? 0.0f : 1.0f;
        if (std::isnan(depths[index]))
            z[index] = 0;
    }
    try
    {
        Imf::Header header(width, height);
        Set_Integral_EXR(header);
        header.insert("eyeDistances", Imf::FloatVectorAttribute(distances));
        header.insert(integral::depth_attribute, Imf::StringAttribute(integral::depth_in_mm));
        for (const char *name : {"Z", "Y", "A"})
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        Imf::FrameBuffer buffer;
        const std::size_t step = sizeof(float);
        for (const char *name : {"Z", "Y"})
            buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char *>(z.data()), step,
                                           step * width));
        buffer.insert("A", Imf::Slice(Imf::FLOAT, reinterpret_cast<char *>(alpha.data()), step,
                                      step * width));
        WholeEXR whole(file);
        {
            Imf::OutputFile output(whole, header);
            output.setFrameBuffer(buffer);
            output.writePixels(height);
        }
        whole.Finish();
    }
    catch (const std::exception& problem)
    {
        return problem.what();
    }
    return "";
#endif
}

}
