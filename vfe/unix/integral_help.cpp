// SPDX-License-Identifier: AGPL-3.0-or-later
// See integral_help.h.
#include "integral_help.h"

#include <cstdio>

#include "integral/base/first_steps.h"

namespace vfePlatform
{
void PrintIntegralHelp()
{
    std::fputs(
        "Keywords of the integral camera, on the command line or in INI files (man povray-integral,\n"
        "doc/guide.md):\n"
        "\n"
        "    Integral_Camera=\"WORDS\"          make the scene's own camera integral:\n"
        "                                     lens_sheet { ... } film { ... } and others\n"
        "    Integral_Sheet=FILE.json         the lens sheet, as measured (integral print --even)\n"
        "    Integral_Panel=NAME|FILE.json    render for a light-field panel (integral lcd --list)\n"
        "    Integral_Draft=N                 the same print with N times fewer pixels across and down\n"
        "    Integral_Fit=on|off|F            fit the scene's depth to F depth budgets (on: 2)\n"
        "    Integral_Target_Error=E          find the settings for an error (0.02), render with them;\n"
        "                                     on the command line only\n"
        "    Integral_Phase=A,B               only what the part A to B of the zone sees, 0 to 1\n"
        "    Integral_Quilt=CxR               views of C x R eyes in place of the frame\n"
        "    Integral_Quilt=draft|good|best   the quilt of Integral_Panel, in three sizes\n"
        "    Integral_Audit=on|off|PERCENT    estimate the frame's error, by so many of its pixels\n"
        "    Integral_Error_Image=FILE        write a picture of the local error\n"
        "    Integral_Depth_Image=FILE.exr    write each pixel's distance from the sheet, mm\n"
        "    Integral_Antialiasing=light_field|pixels   what +A does; pixels: as POV-Ray does\n"
        "    Integral_Reconstruction=on|off             whether +A's pixels help each other\n"
        "    Integral_Sharing=auto|on|off|N   whether rays share the shading of surfaces\n"
        "    Integral_Rows=FIRST,LAST         the rows that count; others are only neighbours\n"
        "    Integral_Seed=N                  seed of the random numbers\n"
        "    Integral_Metadata=full|repeatable   repeatable: files without date, machine and run time\n"
        "\n",
        stderr);
    std::fputs(integral::first_steps(), stderr);
}
}
