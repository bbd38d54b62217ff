// SPDX-License-Identifier: AGPL-3.0-or-later
// Message attributes of the integral camera, between POV-Ray's front end and back end.
#ifndef POVRAY_BASE_INTEGRALMSGID_H
#define POVRAY_BASE_INTEGRALMSGID_H

enum
{
    kIntegralAttrib_Camera = 'IgCa',       ///< option: the words of Integral_Camera=
    kIntegralAttrib_Audit = 'IgAu',        ///< option Integral_Audit=: on, off or a percentage
    kIntegralAttrib_Seed = 'IgSd',         ///< option Integral_Seed=: of all random choices
    kIntegralAttrib_ErrorPicture = 'IgEp', ///< option Integral_Error_Image=: file
    kIntegralAttrib_DepthPicture = 'IgDp', ///< option Integral_Depth_Image=: file
    kIntegralAttrib_Antialiasing = 'IgAa', ///< option Integral_Antialiasing=: light_field or pixels
    kIntegralAttrib_Sharing = 'IgSh', ///< option Integral_Sharing=: auto, on, off or a number of
                                      ///< patches
    kIntegralAttrib_Rows = 'IgRo', ///< option Integral_Rows=: the first and the last row that count
    // statistics
    kIntegralAttrib_FilmPoints = 'IgFp',        ///< film points asked for
    kIntegralAttrib_Imaged = 'IgIm',            ///< of these, imaged
    kIntegralAttrib_Searched = 'IgSe',          ///< of the imaged, those found by the search
    kIntegralAttrib_OutsideAperture = 'IgOa',   ///< empty, as the aperture is missed
    kIntegralAttrib_TotalReflection = 'IgTr',   ///< empty, by total reflection
    kIntegralAttrib_Rays = 'IgRy',              ///< traced
    kIntegralAttrib_ContainerSearches = 'IgCs', ///< rays that were looked for containers of
    kIntegralAttrib_SharedShadings = 'IgSs', ///< surfaces that rays met and took a shared colour of
    kIntegralAttrib_PatchShadings = 'IgPs',  ///< of these, those for which it was worked out
    kIntegralAttrib_Containers = 'IgCo',     ///< objects that rays may start inside of
    kIntegralAttrib_Objects = 'IgOb',        ///< objects in the scene
    kIntegralAttrib_ViewingDistance = 'IgVd', ///< mm from the eye to the sheet
    kIntegralAttrib_SceneDistance = 'IgVs',   ///< the same as the scene has it; absent: it is that
    kIntegralAttrib_Seconds = 'IgSc',  ///< seconds from the view's start to the end of rendering
    kIntegralAttrib_Error = 'IgEr',    ///< estimated RMS error in the output encoding; absent: not
                                       ///< estimated
    kIntegralAttrib_ErrorLow = 'IgEl', ///< its interval
    kIntegralAttrib_ErrorHigh = 'IgEh',
    kIntegralAttrib_ErrorSeconds = 'IgEs',   ///< seconds that it took
    kIntegralAttrib_ErrorPixels = 'IgEx',    ///< pixels looked at
    kIntegralAttrib_ErrorLitPixels = 'IgEt', ///< of these many lit ones
    kIntegralAttrib_ErrorSamples = 'IgEn',   ///< samples of each
    kIntegralAttrib_ErrorMethod = 'IgEm'     ///< integral::ErrorMethod
};

/// The rows of our keywords in the front end's table of INI keywords.
#define INTEGRAL_INI_KEYWORDS                                                                      \
    {"Integral_Camera", kIntegralAttrib_Camera, kPOVMSType_UCS2String},                            \
        {"Integral_Audit", kIntegralAttrib_Audit, kPOVMSType_UCS2String},                          \
        {"Integral_Seed", kIntegralAttrib_Seed, kPOVMSType_Int},                                   \
        {"Integral_Depth_Image", kIntegralAttrib_DepthPicture, kPOVMSType_UCS2String},             \
        {"Integral_Error_Image", kIntegralAttrib_ErrorPicture, kPOVMSType_UCS2String},             \
        {"Integral_Antialiasing", kIntegralAttrib_Antialiasing, kPOVMSType_UCS2String},            \
        {"Integral_Sharing", kIntegralAttrib_Sharing, kPOVMSType_UCS2String},                      \
        {"Integral_Rows", kIntegralAttrib_Rows, kPOVMSType_UCS2String},

#endif
