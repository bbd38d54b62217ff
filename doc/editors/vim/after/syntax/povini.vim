" SPDX-License-Identifier: AGPL-3.0-or-later
" Written by doc/editors/make-words from the sources; do not edit.
syn case ignore
syn keyword povintegralOption Integral_Camera Integral_Sheet Integral_Panel Integral_Draft Integral_Fit Integral_Target_Error Integral_Audit Integral_Seed Integral_Depth_Image Integral_Error_Image Integral_Antialiasing Integral_Reconstruction Integral_Sharing Integral_Quilt Integral_Phase Integral_Rows Integral_Metadata
hi def link povintegralOption Keyword
