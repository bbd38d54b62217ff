// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included
#include "base/configbase.h"
#include "frontend/integraloutput.h"
#include "base/fileinputoutput.h"
#include "base/integralframe.h"
#include "base/integralmsgid.h"
#include "base/image/integralmetadata.h"
#include "base/integralstream.h"
#include "base/povmscpp.h"
#include "integral/base/atomic_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

// this must be the last file included
#include "base/povdebug.h"

namespace pov_frontend
{

using namespace pov_base;

namespace
{

/// Whether a name is standard output, a device, a pipe or a socket.
bool Is_Special(const std::string& name)
{
    return name == "stdout" || name == "stderr" || integral::is_special(name);
}

std::string Reason(int number)
{
    return number != 0 ? std::string(": ") + std::strerror(number) : std::string();
}

/// Writes the picture to an open stream. Throws an exception on failure; errno may have the reason.
void Write_To(IntegralStream& stream, Image::ImageFileType format, const Image& image,
              const Image::WriteOptions& options, bool on_disk)
{
    if (!stream)
        throw POV_EXCEPTION_CODE(kCannotOpenFileErr);
    Image::Write(format, &stream, &image, options);
    if (!stream.Finish(on_disk))
        throw POV_EXCEPTION_CODE(kFileDataErr);
}

}

void Write_Whole_Picture(UCS2String& file, unsigned int file_type, Image::ImageFileType format,
                         const Image& image, const Image::WriteOptions& options)
{
    std::string name = UCS2toASCIIString(file);
    const bool special = Is_Special(name);
    if (!special && IntegralFrame::Named(name) != name)
    {
        name = IntegralFrame::Named(name);
        file = ASCIItoUCS2String(name.c_str());
    }
    errno = 0;
    try
    {
        if (!POV_ALLOW_FILE_WRITE(file.c_str(), file_type))
            throw POV_EXCEPTION(kCannotOpenFileErr,
                                "IO Restrictions prohibit write access to '" + name + "'");
        if (special)
        {
            IntegralStream stream(file_type);
            stream.open(file);
            Write_To(stream, format, image, options, false);
            return Write_Integral_Companion(file, format, options);
        }
        integral::AtomicFile unfinished(name);
        {
            IntegralStream stream(file_type, unfinished.name());
            Write_To(stream, format, image, options, true);
        }
        Write_Integral_Companion(file, format, options);
        if (const int error = unfinished.finish())
        {
            errno = error;
            throw POV_EXCEPTION_CODE(kFileDataErr);
        }
    }
    catch (const pov_base::Exception& problem)
    {
        const int reason = errno;
        const std::string why = reason != 0 ? Reason(reason) : std::string(": ") + problem.what();
        throw POV_EXCEPTION(kFileDataErr, "Cannot write the picture " + name + why);
    }
}

void Number_Integral_Files(POVMS_Object& options, int frame, int digits)
{
    for (const POVMSType key : {kIntegralAttrib_DepthPicture, kIntegralAttrib_ErrorPicture})
    {
        const std::string name = UCS2toASCIIString(options.TryGetUCS2String(key, ""));
        const auto dot = name.rfind('.');
        if (dot == std::string::npos)
            continue; // not the name of such a file: an error when the options are read
        std::string number = std::to_string(frame);
        number.insert(0, std::max(0, digits - int(number.size())), '0');
        const std::string numbered = name.substr(0, dot) + number + name.substr(dot);
        options.SetUCS2String(key, ASCIItoUCS2String(numbered.c_str()).c_str());
    }
}

UCS2String Render_State_Name(const UCS2String& file)
{
    const UCS2String name = GetFileName(Path(file)), extension = GetFileExtension(Path(file));
    const bool usual = extension == ASCIItoUCS2String(".png") ||
                       extension == ASCIItoUCS2String(".pov");
    return (usual ? name : file) + ASCIItoUCS2String(".pov-state");
}

/// Whether a file is a render state, or the beginning of one, which may be empty.
static bool Is_Render_State(const std::string& name, const std::string& signature)
{
    const int file = open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
        return false;
    struct stat status;
    std::string begin(signature.size(), '\0');
    const bool is_file = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    const ssize_t number = is_file ? read(file, &begin[0], begin.size()) : -1;
    close(file);
    return number >= 0 && begin.compare(0, number, signature, 0, number) == 0;
}

OStream *New_Render_State(const UCS2String& file, unsigned int file_type,
                          const std::string& signature)
{
    const std::string name = UCS2toASCIIString(file);
    struct stat status;
    if (lstat(name.c_str(), &status) == 0)
    {
        if (!Is_Render_State(name, signature))
            throw POV_EXCEPTION(kCannotOpenFileErr, "Cannot create the render state " + name +
                                                        ": the file of that name is none, or a "
                                                        "link; move it away");
        unlink(name.c_str());
    }
    const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    const int reason = errno;
    std::unique_ptr<IntegralStream> stream(new IntegralStream(file_type, descriptor));
    if (!*stream)
        throw POV_EXCEPTION(kCannotOpenFileErr,
                            "Cannot create the render state " + name + Reason(reason));
    return stream.release();
}

void Check_Companions()
{
    const std::string problem = IntegralFrame::Take_Problem();
    if (!problem.empty())
        throw POV_EXCEPTION(kFileDataErr, problem);
}

std::string Lost_Pixels_Message(bool state_failed, const std::string& state_file, int reason)
{
    if (state_failed)
        return "Cannot write the render state " + state_file + Reason(reason) +
               ". +C goes on from what it holds.";
    return "Cannot write the picture's temporary file" + Reason(reason) +
           ". +C goes on from the render state.";
}

}
