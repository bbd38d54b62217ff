// SPDX-License-Identifier: AGPL-3.0-or-later
// The size of the picture in pixels, which the print_size of Integral_Camera= and Integral_Draft=
// determine while the scene is parsed, after POV-Ray's front end has read the options.
#ifndef POVRAY_FRONTEND_INTEGRALSIZE_H
#define POVRAY_FRONTEND_INTEGRALSIZE_H

#include <optional>

#include "base/povms.h"

class POVMS_Object;

namespace pov_frontend
{

/// Width and Height of povray.ini, which are read before the command line. They are defaults, so
/// that print_size may replace them, while a size given on the command line or in an INI file named
/// there stays.
class DefaultSize
{
public:
    /// Takes the size out of the options.
    explicit DefaultSize(POVMSObject& options);

    /// Replaces Integral_Panel= by its settings. Puts the size back where neither these nor the
    /// command line give one, and marks it as a default. Call it after the command line has been
    /// read.
    void Put_Back(POVMSObject& options) const;

private:
    std::optional<POVMSInt> width, height;
};

/// After parsing: sets the options' size to that of the scene's integral camera. Returns whether it
/// has changed; the picture in memory must be made anew then.
bool Use_Integral_Size(POVMS_Object& options);

}

#endif
