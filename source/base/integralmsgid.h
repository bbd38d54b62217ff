// SPDX-License-Identifier: AGPL-3.0-or-later
// Message attributes of the integral camera, between POV-Ray's front end and back end.
#ifndef POVRAY_BASE_INTEGRALMSGID_H
#define POVRAY_BASE_INTEGRALMSGID_H

enum
{
    kIntegralAttrib_Camera          = 'IgCa', ///< option: the words of Integral_Camera=
    kIntegralAttrib_FilmPoints      = 'IgFp', ///< statistics: film points asked for
    kIntegralAttrib_Rays            = 'IgRy', ///< statistics: of these, traced
    kIntegralAttrib_Searched        = 'IgSe', ///< statistics: of the rays, those found by the search
    kIntegralAttrib_OutsideAperture = 'IgOa', ///< statistics: empty, as the aperture is missed
    kIntegralAttrib_TotalReflection = 'IgTr', ///< statistics: empty, by total reflection
    kIntegralAttrib_Seconds         = 'IgSc'  ///< statistics: seconds since the view began
};

#endif
