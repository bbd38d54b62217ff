// SPDX-License-Identifier: AGPL-3.0-or-later
// Pictures and render states on disk: each picture is written whole or not at all, and its state is
// kept until that is done.
#ifndef POVRAY_FRONTEND_INTEGRALOUTPUT_H
#define POVRAY_FRONTEND_INTEGRALOUTPUT_H

#include <cerrno>
#include <string>

#include "base/types.h"
#include "base/image/image.h"
#include "base/pov_err.h"
#include "base/stringutilities.h"

namespace pov_frontend
{

/// Writes `image` to `file`: first under an unfinished name in the same folder, which then takes
/// the file's place, so that what was there stays until the new picture is whole. Straight to what
/// is no regular file: a standard stream, a device, a pipe. Throws pov_base::Exception with one
/// sentence if that is not possible; then nothing unfinished is left.
void Write_Whole_Picture(const pov_base::UCS2String& file, unsigned int file_type,
                         pov_base::Image::ImageFileType format, const pov_base::Image& image,
                         const pov_base::Image::WriteOptions& options);

/// What to say where pixels could not be stored: in the state file, if that has failed, or else in
/// the file that the picture is kept in while it is rendered. `reason`: errno, or 0.
std::string Lost_Pixels_Message(bool state_failed, const std::string& state_file, int reason);

/// Runs `store`, which stores pixels of a view. Once that has failed during the render it throws
/// one sentence, and does nothing from then on: the render is being stopped, and another exception,
/// thrown while that waits for an answer, would end the program.
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
        if (data.state == ViewData::View_Created) // a state file's pixels: it is read as far as it
                                                  // is whole
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
