// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included
#include "base/configbase.h"
#include "frontend/integraloutput.h"
#include "base/fileinputoutput.h"
#include "base/integralframe.h"
#include "base/image/integralmetadata.h"
#include "integral/base/unfinished_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <unistd.h>

// this must be the last file included
#include "base/povdebug.h"

namespace pov_frontend
{

using namespace pov_base;

namespace
{

class PictureStream : public OStream
{
public:
    explicit PictureStream(unsigned int file_type) : OStream(file_type) {}

    /// Flushes the file; returns whether everything was written. `on_disk`: also sync it to disk.
    bool Finish(bool on_disk)
    {
        return !fail && std::fflush(f) == 0 && !std::ferror(f) &&
               (!on_disk || fsync(fileno(f)) == 0);
    }
};

/// Whether a name is standard output, a device, a pipe or a socket.
bool Is_Special(const std::string& name)
{
    return name == "stdout" || name == "stderr" || integral::is_special(name);
}

std::string Reason(int number)
{
    return number != 0 ? std::string(": ") + std::strerror(number) : std::string();
}

/// Writes the picture to `name` itself. Throws an exception on failure; errno may tell the reason.
void Write_Straight(const std::string& name, unsigned int file_type, Image::ImageFileType format,
                    const Image& image, const Image::WriteOptions& options, bool on_disk)
{
    const UCS2String path = ASCIItoUCS2String(name.c_str());
    if (!POV_ALLOW_FILE_WRITE(path.c_str(), file_type))
        throw POV_EXCEPTION(kCannotOpenFileErr,
                            "IO Restrictions prohibit write access to '" + name + "'");
    PictureStream stream(file_type);
    if (!stream.open(path))
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
    std::optional<integral::UnfinishedFile> unfinished;
    if (!special)
        unfinished.emplace(name);
    errno = 0;
    try
    {
        Write_Straight(special ? name : unfinished->name(), file_type, format, image, options,
                       !special);
        Write_Integral_Companion(file, format, options);
        if (unfinished && unfinished->finish() != 0)
            throw POV_EXCEPTION_CODE(kCannotOpenFileErr);
    }
    catch (const pov_base::Exception& problem)
    {
        const int reason = errno;
        const std::string why = reason != 0 ? Reason(reason) : std::string(": ") + problem.what();
        throw POV_EXCEPTION(kFileDataErr, "Cannot write the picture " + name + why);
    }
}

UCS2String Render_State_Name(const UCS2String& file)
{
    const UCS2String name = GetFileName(Path(file)), extension = GetFileExtension(Path(file));
    const bool usual = extension == ASCIItoUCS2String(".png") ||
                       extension == ASCIItoUCS2String(".pov");
    return (usual ? name : file) + ASCIItoUCS2String(".pov-state");
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
