// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included
#include "base/configbase.h"
#include "frontend/integralstatistics.h"
#include "base/integralframe.h"
#include "base/integralmsgid.h"
#include "base/povmsgid.h"
#include "base/stringutilities.h"

#include <cmath>
#include <cstdio>
#include <cstring>

// this must be the last file included
#include "base/povdebug.h"

namespace pov_frontend
{

using namespace pov_base;

static const char state_mark[] = "povray-integral:";

/// Prints the estimated error and how it was estimated.
static void Print_Error(POVMS_Object& statistics, TextStreamBuffer *out)
{
    if (!statistics.Exist(kIntegralAttrib_Error))
        return;
    const auto number = [&](POVMSType key) { return double(statistics.TryGetFloat(key, 0)); };
    const double rms = number(kIntegralAttrib_Error);
    out->printf("%-19s %15.5f   95%%: %.5f to %.5f", "RMS error:", rms,
                number(kIntegralAttrib_ErrorLow), number(kIntegralAttrib_ErrorHigh));
    if (rms > 0)
        out->printf("   PSNR %.1f dB", -20 * std::log10(rms));
    out->printf("\n");
    const double pixels = double(statistics.TryGetLong(kIntegralAttrib_ErrorPixels, 0));
    const int samples = statistics.TryGetInt(kIntegralAttrib_ErrorSamples, 0);
    if (statistics.TryGetInt(kIntegralAttrib_ErrorMethod, 0) == int(integral::ErrorMethod::audit))
        out->printf("  by an audit of %.0f of %.0f lit pixels, %d samples each, in %.3f seconds\n",
                    pixels, double(statistics.TryGetLong(kIntegralAttrib_ErrorLitPixels, 0)),
                    samples, number(kIntegralAttrib_ErrorSeconds));
    else
        out->printf("  by the two halves of the %d samples of each of %.0f lit pixels\n", samples,
                    pixels);
    if (statistics.TryGetBool(kIntegralAttrib_Continued, false))
        out->printf(
            "  of the pixels that this run rendered (+C); that of the others is not known\n");
    if (statistics.TryGetLong(kPOVAttrib_RadGatherCount, 0) > 0)
        out->printf("  with the noise of radiosity's points, but for those of the pretrace\n");
}

/// Prints the picture's size and the viewing distance.
static void Print_Geometry(POVMS_Object& statistics, TextStreamBuffer *out)
{
    const auto number = [&](POVMSType key) { return double(statistics.TryGetFloat(key, 0)); };
    out->printf("%-19s %15.1f x %.1f mm\n", "Picture size:", number(kIntegralAttrib_PrintWidth),
                number(kIntegralAttrib_PrintHeight));
    if (const int draft = statistics.TryGetInt(kIntegralAttrib_Draft, 1); draft > 1)
        out->printf("%-19s %15d   times fewer pixels across and down\n",
                    "  a draft, with:", draft);
    out->printf("%-19s %15.1f   mm\n", "Viewing distance:",
                number(kIntegralAttrib_ViewingDistance));
    if (statistics.Exist(kIntegralAttrib_FitWords))
        out->printf("%-19s %s\n", "Fit chose:",
                    statistics.GetString(kIntegralAttrib_FitWords).c_str());
    if (statistics.Exist(kIntegralAttrib_Parallax))
        out->printf("%-19s %15.5g   mm a mm of the viewer's; its distance is %.1f mm\n",
                    "  scene's eye moves:", number(kIntegralAttrib_Parallax),
                    number(kIntegralAttrib_SceneDistance));
}

/// Prints that +C has not continued radiosity's points.
static void Print_Continued(POVMS_Object& statistics, TextStreamBuffer *out)
{
    if (statistics.TryGetBool(kIntegralAttrib_Continued, false) &&
        statistics.TryGetLong(kPOVAttrib_RadGatherCount, 0) > 0)
        out->printf("Continued (+C) with radiosity: its points are gathered anew, so that the "
                    "pixels of\nthis run may differ slightly from those of a render without a "
                    "break.\n");
}

/// Warns of a picture that shows nothing.
static void Print_One_Colour(POVMS_Object& statistics, TextStreamBuffer *out)
{
    if (!statistics.TryGetBool(kIntegralAttrib_OneColour, false))
        return;
    out->printf("Warning: all pixels have the same colour. ");
    if (statistics.Exist(kIntegralAttrib_SceneDistance) &&
        !statistics.Exist(kIntegralAttrib_Parallax))
        out->printf("move_eye may have moved the eye into fog, or out of a\n"
                    "room; viewing_distance %.4g leaves it where the scene has it.\n",
                    double(statistics.GetFloat(kIntegralAttrib_SceneDistance)));
    else
        out->printf("If the scene's own camera shows more, `integral sheet\n"
                    "--report` says how far from the sheet its surfaces are.\n");
}

void Print_Integral_Statistics(POVMS_Object& statistics, TextStreamBuffer *out)
{
    if (!statistics.Exist(kIntegralAttrib_FilmPoints))
        return;
    const auto count = [&](POVMSType key) { return double(statistics.TryGetLong(key, 0)); };
    const double points = count(kIntegralAttrib_FilmPoints), imaged = count(kIntegralAttrib_Imaged);
    const double searched = count(kIntegralAttrib_Searched), rays = count(kIntegralAttrib_Rays);
    const double seconds = statistics.TryGetFloat(kIntegralAttrib_Seconds, 0);
    const auto line = [&](const char *label, double number, double of)
    { out->printf("%-19s %15.0f   %6.2f%%\n", label, number, of > 0 ? 100 * number / of : 0); };

    out->printf("----------------------------------------------------------------------------\n");
    out->printf("Integral Camera\n");
    out->printf("----------------------------------------------------------------------------\n");
    out->printf("%-19s %15.0f\n", "Film points:", points);
    line("  imaged:", imaged, points);
    line("    by the rule:", imaged - searched, points);
    line("    by the search:", searched, points);
    const double outside = count(kIntegralAttrib_OutsideAperture),
                 reflected = count(kIntegralAttrib_TotalReflection);
    line("  left empty:", outside + reflected, points);
    line("    aperture missed:", outside, points);
    line("    total reflection:", reflected, points);
    out->printf("%-19s %15.0f   %6.2f an imaged point", "Rays:", rays,
                imaged > 0 ? rays / imaged : 0);
    if (seconds > 0)
        out->printf(", %.0f a second", rays / seconds);
    out->printf("\n");
    line("  containers sought:", count(kIntegralAttrib_ContainerSearches), rays);
    out->printf("%-19s %15d   of %d objects\n",
                "    among:", statistics.TryGetInt(kIntegralAttrib_Containers, 0),
                statistics.TryGetInt(kIntegralAttrib_Objects, 0));
    Print_Geometry(statistics, out);
    if (const double shared = count(kIntegralAttrib_SharedShadings))
    {
        out->printf("%-19s %15.0f\n", "Shared shadings:", shared);
        line("  worked out:", count(kIntegralAttrib_PatchShadings), shared);
    }
    Print_Error(statistics, out);
    Print_Continued(statistics, out);
    Print_One_Colour(statistics, out);
}

void Mark_Render_State(unsigned char *reserved, std::size_t size)
{
    const std::string mark = state_mark + IntegralFrame::Fingerprint();
    std::memset(reserved, 0, size);
    std::memcpy(reserved, mark.c_str(), mark.size());
}

void Check_Render_State(const Path& file, std::size_t reserved_offset)
{
    std::FILE *stream = std::fopen(UCS2toASCIIString(file()).c_str(), "rb");
    if (stream == NULL)
        return;
    const std::string expected = state_mark + IntegralFrame::Fingerprint();
    char found[sizeof(state_mark) + 16] = "";
    const bool read = std::fseek(stream, long(reserved_offset), SEEK_SET) == 0 &&
                      std::fread(found, 1, sizeof(found) - 1, stream) == sizeof(found) - 1;
    std::fclose(stream);
    if (!read)
        return; // not a state file, or a damaged one: POV-Ray itself reports that
    // A state file of an unmodified POV-Ray has no mark; it belongs to one of POV-Ray's own
    // cameras.
    const bool marked = std::strncmp(found, state_mark, sizeof(state_mark) - 1) == 0;
    const std::string mark = marked ? std::string(found) : std::string(state_mark);
    if (mark != expected)
        throw POV_EXCEPTION(
            kCannotHandleRequestErr,
            "Cannot continue the trace: it was begun with another camera. Render anew without +C, "
            "or put the camera back as it was.");
}

}
