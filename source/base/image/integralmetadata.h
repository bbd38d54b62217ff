// SPDX-License-Identifier: AGPL-3.0-or-later
// Writes a micro-image frame's geometry into its picture file, or into a JSON file in the same
// folder, and decides whether pictures contain date and machine.
#ifndef POVRAY_BASE_INTEGRALMETADATA_H
#define POVRAY_BASE_INTEGRALMETADATA_H

#include "base/image/image.h"

#ifndef OPENEXR_MISSING
#include <ImfForward.h>
#endif

struct png_struct_def;
struct png_info_def;

namespace pov_base
{

/// Whether pictures are written without date, machine and run time (Integral_Metadata=repeatable),
/// whichever camera drew them.
bool Is_Repeatable();

/// Adds the document to a PNG as iTXt chunk `integral`, and the resolution as pHYs. Call it before
/// png_write_info.
void Set_Integral_PNG(png_struct_def *png, png_info_def *info, const Image::WriteOptions& options);

/// Adds the document to an OpenEXR header as string attribute `integral`, and the resolution as
/// xDensity and pixel aspect ratio.
#ifndef OPENEXR_MISSING
void Set_Integral_EXR(Imf::Header& header);
#endif

/// Writes the document to FILE.json for every other format. Call it after the picture has been
/// written.
void Write_Integral_Companion(const UCS2String& file, int file_type,
                              const Image::WriteOptions& options);

}

#endif
