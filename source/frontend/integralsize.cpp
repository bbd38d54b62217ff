// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included
#include "base/configbase.h"
#include "frontend/integralsize.h"
#include "frontend/integralpanel.h"
#include "base/integralframe.h"
#include "base/integralmsgid.h"
#include "base/povmscpp.h"
#include "base/povmsgid.h"

// this must be the last file included
#include "base/povdebug.h"

namespace pov_frontend
{

using namespace pov_base;

namespace
{

std::optional<POVMSInt> Take(POVMSObject& options, POVMSType key)
{
    POVMSInt value = 0;
    if (POVMSUtil_GetInt(&options, key, &value) != kNoErr)
        return std::nullopt;
    POVMSObject_Remove(&options, key);
    return value;
}

void Put(POVMSObject& options, POVMSType key, std::optional<POVMSInt> value, POVMSType mark)
{
    POVMSInt given = 0;
    if (POVMSUtil_GetInt(&options, key, &given) == kNoErr)
        return;
    if (value)
        POVMSUtil_SetInt(&options, key, *value);
    POVMSUtil_SetBool(&options, mark, true);
}

}

DefaultSize::DefaultSize(POVMSObject& options)
    : width(Take(options, kPOVAttrib_Width)), height(Take(options, kPOVAttrib_Height))
{
}

void DefaultSize::Put_Back(POVMSObject& options) const
{
    Use_Integral_Panel(options);
    Put(options, kPOVAttrib_Width, width, kIntegralAttrib_FreeWidth);
    Put(options, kPOVAttrib_Height, height, kIntegralAttrib_FreeHeight);
}

bool Use_Integral_Size(POVMS_Object& options)
{
    const auto size = IntegralFrame::Expected_Size();
    if (!size || (options.TryGetInt(kPOVAttrib_Width, 0) == size->width &&
                  options.TryGetInt(kPOVAttrib_Height, 0) == size->height))
        return false;
    options.SetInt(kPOVAttrib_Width, size->width);
    options.SetInt(kPOVAttrib_Height, size->height);
    return true;
}

}
