// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must be the first POV-Ray file included
#include "base/configbase.h"
#include "frontend/integralstatistics.h"
#include "base/integralframe.h"
#include "base/integralmsgid.h"
#include "base/stringutilities.h"

#include <cstdio>
#include <cstring>

// this must be the last file included
#include "base/povdebug.h"

namespace pov_frontend
{

using namespace pov_base;

static const char state_mark[] = "povray-integral:";

void Print_Integral_Statistics(POVMS_Object& statistics, TextStreamBuffer *out)
{
    if (!statistics.Exist(kIntegralAttrib_FilmPoints))
        return;
    const auto count = [&](POVMSType key) { return double(statistics.TryGetLong(key, 0)); };
    const double points = count(kIntegralAttrib_FilmPoints), rays = count(kIntegralAttrib_Rays);
    const double searched = count(kIntegralAttrib_Searched);
    const double seconds = statistics.TryGetFloat(kIntegralAttrib_Seconds, 0);
    const auto percent = [&](double part) { return points > 0 ? 100 * part / points : 0; };

    out->printf("----------------------------------------------------------------------------\n");
    out->printf("Integral Camera\n");
    out->printf("----------------------------------------------------------------------------\n");
    out->printf("Film points:        %15.0f\n", points);
    out->printf("  imaged (rays):    %15.0f   %6.2f%%\n", rays, percent(rays));
    out->printf("    by the rule:    %15.0f   %6.2f%%\n", rays - searched, percent(rays - searched));
    out->printf("    by the search:  %15.0f   %6.2f%%\n", searched, percent(searched));
    const double outside = count(kIntegralAttrib_OutsideAperture), reflected = count(kIntegralAttrib_TotalReflection);
    out->printf("  left empty:       %15.0f   %6.2f%%\n", outside + reflected, percent(outside + reflected));
    out->printf("    aperture missed:%15.0f   %6.2f%%\n", outside, percent(outside));
    out->printf("    total reflection:%14.0f   %6.2f%%\n", reflected, percent(reflected));
    out->printf("Seconds:            %15.3f", seconds);
    if (seconds > 0)
        out->printf("   %.0f rays a second", rays / seconds);
    out->printf("\n");
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
    const bool read = std::fseek(stream, long(reserved_offset), SEEK_SET) == 0
                   && std::fread(found, 1, sizeof(found) - 1, stream) == sizeof(found) - 1;
    std::fclose(stream);
    if (!read)
        return; // not a state file, or a damaged one: POV-Ray has its own words for that
    // a file of an unmodified POV-Ray has no mark: it can only be of one of POV-Ray's own cameras
    const bool marked = std::strncmp(found, state_mark, sizeof(state_mark) - 1) == 0;
    const std::string mark = marked ? std::string(found) : std::string(state_mark);
    if (mark != expected)
        throw POV_EXCEPTION(kCannotHandleRequestErr,
                            "Cannot continue the trace: it was begun with another camera. Render anew without +C, "
                            "or put the camera back as it was.");
}

}
