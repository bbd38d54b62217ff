// SPDX-License-Identifier: AGPL-3.0-or-later
// Message attributes of the integral camera, between POV-Ray's front end and back end.
#ifndef POVRAY_BASE_INTEGRALMSGID_H
#define POVRAY_BASE_INTEGRALMSGID_H

enum
{
    kIntegralAttrib_Camera = 'IgCa',       ///< option: the words of Integral_Camera=
    kIntegralAttrib_Audit = 'IgAu',        ///< option Integral_Audit=: on, off or a percentage
    kIntegralAttrib_Seed = 'IgSd',         ///< option Integral_Seed=: seed of random numbers
    kIntegralAttrib_ErrorPicture = 'IgEp', ///< option Integral_Error_Image=: file
    kIntegralAttrib_DepthPicture = 'IgDp', ///< option Integral_Depth_Image=: file
    kIntegralAttrib_Antialiasing = 'IgAa', ///< option Integral_Antialiasing=: light_field or pixels
    kIntegralAttrib_Reconstruction = 'IgRe', ///< option Integral_Reconstruction=: on or off
    kIntegralAttrib_Sharing = 'IgSh', ///< option Integral_Sharing=: auto, on, off or a number of
                                      ///< patches
    kIntegralAttrib_Rows = 'IgRo', ///< option Integral_Rows=: the first and the last row that count
    kIntegralAttrib_Sheet = 'IgSf',       ///< option Integral_Sheet=: file with a lens sheet
    kIntegralAttrib_TargetError = 'IgTE', ///< option Integral_Target_Error= of an INI file
    kIntegralAttrib_Draft = 'IgDr', ///< option Integral_Draft=: side of a draft's pixel, in pixels
                                    ///< of the final
    kIntegralAttrib_Fit = 'IgFi',   ///< option Integral_Fit=: depth budgets on either side of the
                                    ///< sheet
    kIntegralAttrib_FreeWidth = 'IgFw',    ///< Width is a default, which print_size may replace
    kIntegralAttrib_FreeHeight = 'IgFh',   ///< Height is a default, which print_size may replace
    kIntegralAttrib_Quilt = 'IgQu',        ///< option Integral_Quilt=: views across and up
    kIntegralAttrib_Phase = 'IgPa',        ///< option Integral_Phase=: part of the viewing zone
    kIntegralAttrib_Metadata = 'IgMd',     ///< option Integral_Metadata=: full or repeatable
    kIntegralAttrib_Panel = 'IgPn',        ///< option Integral_Panel=: a panel's name or file; the
                                           ///< front end replaces it by other options
    kIntegralAttrib_PanelProblem = 'IgPp', ///< what is wrong with Integral_Panel=, for the user
    // statistics
    kIntegralAttrib_FilmPoints = 'IgFp',        ///< number of film points
    kIntegralAttrib_Imaged = 'IgIm',            ///< film points that are imaged
    kIntegralAttrib_Searched = 'IgSe',          ///< imaged points whose lens the search found
    kIntegralAttrib_OutsideAperture = 'IgOa',   ///< not imaged: the ray misses the aperture
    kIntegralAttrib_TotalReflection = 'IgTr',   ///< not imaged: totally reflected
    kIntegralAttrib_Rays = 'IgRy',              ///< rays traced
    kIntegralAttrib_ContainerSearches = 'IgCs', ///< rays whose start was searched for objects
    kIntegralAttrib_SharedShadings = 'IgSs',    ///< ray hits that used a shared colour
    kIntegralAttrib_PatchShadings = 'IgPs',     ///< shared shadings that had to be computed
    kIntegralAttrib_Containers = 'IgCo',        ///< objects inside which rays may start
    kIntegralAttrib_Objects = 'IgOb',           ///< objects in the scene
    kIntegralAttrib_PrintWidth = 'IgPw',        ///< mm across the picture
    kIntegralAttrib_PrintHeight = 'IgPh',       ///< mm down the picture
    kIntegralAttrib_ViewingDistance = 'IgVd',   ///< mm from the eye to the sheet
    kIntegralAttrib_Parallax = 'IgPx', ///< mm that the scene's eye moves for 1 mm of the viewer's;
                                       ///< absent: the eyes are the same
    kIntegralAttrib_SceneDistance = 'IgVs', ///< mm from the scene's eye to the sheet; only with
                                            ///< parallax or move_eye
    kIntegralAttrib_FitWords = 'IgFt',      ///< the words that the fit chose; absent: no fit
    kIntegralAttrib_OneColour = 'IgOc',     ///< whether all pixels have the same colour
    kIntegralAttrib_Seconds = 'IgSc',  ///< seconds from the view's start to the end of rendering
    kIntegralAttrib_Error = 'IgEr',    ///< estimated RMS error in the output encoding; absent: not
                                       ///< estimated
    kIntegralAttrib_ErrorLow = 'IgEl', ///< ends of its interval
    kIntegralAttrib_ErrorHigh = 'IgEh',
    kIntegralAttrib_ErrorSeconds = 'IgEs',   ///< seconds that the estimate took
    kIntegralAttrib_ErrorPixels = 'IgEx',    ///< pixels examined
    kIntegralAttrib_ErrorLitPixels = 'IgEt', ///< lit pixels in the frame
    kIntegralAttrib_ErrorSamples = 'IgEn',   ///< samples of each examined pixel
    kIntegralAttrib_ErrorMethod = 'IgEm',    ///< integral::ErrorMethod
    kIntegralAttrib_Continued = 'IgEk'       ///< whether pixels come from an earlier run (+C)
};

/// The integral camera's rows in the front end's table of INI keywords.
#define INTEGRAL_INI_KEYWORDS                                                                      \
    {"Integral_Camera", kIntegralAttrib_Camera, kPOVMSType_UCS2String},                            \
        {"Integral_Sheet", kIntegralAttrib_Sheet, kPOVMSType_UCS2String},                          \
        {"Integral_Panel", kIntegralAttrib_Panel, kPOVMSType_UCS2String},                          \
        {"Integral_Draft", kIntegralAttrib_Draft, kPOVMSType_UCS2String},                          \
        {"Integral_Fit", kIntegralAttrib_Fit, kPOVMSType_UCS2String},                              \
        {"Integral_Target_Error", kIntegralAttrib_TargetError, kPOVMSType_UCS2String},             \
        {"Integral_Audit", kIntegralAttrib_Audit, kPOVMSType_UCS2String},                          \
        {"Integral_Seed", kIntegralAttrib_Seed, kPOVMSType_Int},                                   \
        {"Integral_Depth_Image", kIntegralAttrib_DepthPicture, kPOVMSType_UCS2String},             \
        {"Integral_Error_Image", kIntegralAttrib_ErrorPicture, kPOVMSType_UCS2String},             \
        {"Integral_Antialiasing", kIntegralAttrib_Antialiasing, kPOVMSType_UCS2String},            \
        {"Integral_Reconstruction", kIntegralAttrib_Reconstruction, kPOVMSType_UCS2String},        \
        {"Integral_Sharing", kIntegralAttrib_Sharing, kPOVMSType_UCS2String},                      \
        {"Integral_Quilt", kIntegralAttrib_Quilt, kPOVMSType_UCS2String},                          \
        {"Integral_Phase", kIntegralAttrib_Phase, kPOVMSType_UCS2String},                          \
        {"Integral_Rows", kIntegralAttrib_Rows, kPOVMSType_UCS2String},                            \
        {"Integral_Metadata", kIntegralAttrib_Metadata, kPOVMSType_UCS2String},

#endif
