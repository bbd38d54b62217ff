// SPDX-License-Identifier: AGPL-3.0-or-later
// The front end's share of the integral camera: its statistics, and the check of +C.
#ifndef POVRAY_FRONTEND_INTEGRALSTATISTICS_H
#define POVRAY_FRONTEND_INTEGRALSTATISTICS_H

#include "base/types.h"
#include "base/path.h"
#include "base/povmscpp.h"
#include "base/textstreambuffer.h"

namespace pov_frontend
{

/// Prints the integral camera's part of the render statistics, if the view had one.
void Print_Integral_Statistics(POVMS_Object& statistics, pov_base::TextStreamBuffer *out);

/// Marks a render state file's reserved bytes with the geometry of the camera that is being
/// rendered.
void Mark_Render_State(unsigned char *reserved, std::size_t size);

/// Refuses to continue a render whose state file was written for another integral camera.
/// No effect if there is no such file.
void Check_Render_State(const pov_base::Path& file, std::size_t reserved_offset);

}

#endif
