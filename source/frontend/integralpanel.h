// SPDX-License-Identifier: AGPL-3.0-or-later
// Integral_Panel=, which stands for the size of the picture, the camera's words and the views of a
// quilt.
#ifndef POVRAY_FRONTEND_INTEGRALPANEL_H
#define POVRAY_FRONTEND_INTEGRALPANEL_H

#include "base/povms.h"

namespace pov_frontend
{

/// Replaces Integral_Panel= by Width, Height, Integral_Camera= and, with Integral_Quilt=, that
/// option's views across and up. Words that Integral_Camera= has already follow the panel's; `fit`
/// among them replaces the panel's. Call it when the options contain a size only if the user gives
/// one. A problem is added to the options, for the parser to report.
void Use_Integral_Panel(POVMSObject& options);

}

#endif
