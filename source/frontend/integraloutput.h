// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes pictures so that a file appears only when it is complete, and keeps the render state file
// until then.
#ifndef POVRAY_FRONTEND_INTEGRALOUTPUT_H
#define POVRAY_FRONTEND_INTEGRALOUTPUT_H

#include <cerrno>
#include <string>

#include "base/fileinputoutput.h"
#include "base/types.h"
#include "base/image/image.h"
#include "base/pov_err.h"
#include "base/stringutilities.h"

class POVMS_Object;

namespace pov_frontend
{

/// Writes `image` to a temporary file in the folder of `file` and renames it to `file`, so that an
/// old file stays until the new picture is complete. Standard output, devices and pipes are written
/// directly. For a quilt, the suffix that states its views is added to the name, and `file` is set
/// to the new name. Throws pov_base::Exception with a one-sentence message on failure; no temporary file is left then.
void Write_Whole_Picture(pov_base::UCS2String& file, unsigned int file_type,
                         pov_base::Image::ImageFileType format, const pov_base::Image& image,
                         const pov_base::Image::WriteOptions& options);

/// Adds the number of an animation's frame to the file names of Integral_Depth_Image and
/// Integral_Error_Image, before the extension, as in the name of the frame's picture.
void Number_Integral_Files(POVMS_Object& options, int frame, int digits);

/// The name of the render state of the output `file`: NAME.pov-state for NAME.png and, where no
/// picture is written, for the scene NAME.pov; else NAME.EXTENSION.pov-state, so that pictures in
/// several formats can be rendered in one folder.
pov_base::UCS2String Render_State_Name(const pov_base::UCS2String& file);

/// Creates a render state file, in place of an older one (which begins with `signature`). Throws
/// pov_base::Exception if something else has that name, such as a symbolic link, or if the file
/// cannot be created.
pov_base::OStream *New_Render_State(const pov_base::UCS2String& file, unsigned int file_type,
                                    const std::string& signature);

/// Call it when the picture is written. Throws pov_base::Exception with the reason if
/// Integral_Error_Image or Integral_Depth_Image could not be written.
void Check_Companions();

/// The error message if pixels could not be stored in the render state file (`state_failed`) or in
/// the temporary file that holds the picture during rendering. `reason`: errno, or 0.
std::string Lost_Pixels_Message(bool state_failed, const std::string& state_file, int reason);

/// Calls `store`, which stores pixels of a view. If it fails during the render, throws an exception
/// with a one-sentence message, and does nothing in later calls: the render is then being stopped,
/// and a second exception during that would end the program.
template <class ViewData, class Store> void Store_Pixels(ViewData& data, Store store)
{
    using namespace pov_base;
    if (data.pixelsLost)
        return;
    errno = 0;
    try
    {
        store();
    }
    catch (const Exception&)
    {
        const int reason = errno;
        // These are pixels from a state file, whose reader stops at the first incomplete block.
        if (data.state == ViewData::View_Created)
            throw;
        data.pixelsLost = true;
        const bool state_failed = data.imageBackup && !*data.imageBackup;
        const std::string file = UCS2toASCIIString(data.imageBackupFile());
        throw POV_EXCEPTION(kFileDataErr, Lost_Pixels_Message(state_failed, file, reason));
    }
}

/// Removes the state file of a view whose picture has been written.
template <class ViewData> void Remove_Render_State(ViewData& data)
{
    if (!data.imageBackup)
        return;
    data.imageBackup.reset();
    POV_UCS2_REMOVE(data.imageBackupFile().c_str());
}

}

#endif
