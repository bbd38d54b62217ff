// SPDX-License-Identifier: AGPL-3.0-or-later
// The integral camera's part of the front end: prints its statistics, and checks render states for
// +C.
#ifndef POVRAY_FRONTEND_INTEGRALSTATISTICS_H
#define POVRAY_FRONTEND_INTEGRALSTATISTICS_H

#include "base/types.h"
#include "base/path.h"
#include "base/povmscpp.h"
#include "base/textstreambuffer.h"

namespace pov_frontend
{

/// Prints the integral camera's part of the render statistics; nothing for other cameras.
void Print_Integral_Statistics(POVMS_Object& statistics, pov_base::TextStreamBuffer *out);

/// Stores a hash of the camera's geometry in the reserved bytes of a render state file.
void Mark_Render_State(unsigned char *reserved, std::size_t size);

/// Throws an exception if a render state file was written for another integral camera. No effect if
/// there is no such file.
void Check_Render_State(const pov_base::Path& file, std::size_t reserved_offset);

}

#endif
