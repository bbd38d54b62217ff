# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/analysis: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/analysis/band_blocks.cpp \
  integral/analysis/band_blocks.h \
  integral/analysis/band_phases.cpp \
  integral/analysis/border_fit.cpp \
  integral/analysis/border_fit.h \
  integral/analysis/border_slope.cpp \
  integral/analysis/border_slope.h \
  integral/analysis/calibration_fit.cpp \
  integral/analysis/calibration_fit.h \
  integral/analysis/calibration_light.cpp \
  integral/analysis/calibration_light.h \
  integral/analysis/calibration_report.cpp \
  integral/analysis/calibration_report.h \
  integral/analysis/edge_response.cpp \
  integral/analysis/edge_response.h \
  integral/analysis/lattice_candidates.cpp \
  integral/analysis/lattice_candidates.h \
  integral/analysis/lattice_phases.cpp \
  integral/analysis/lattice_phases.h \
  integral/analysis/lattice_search.cpp \
  integral/analysis/lattice_search.h \
  integral/analysis/least_squares.cpp \
  integral/analysis/least_squares.h \
  integral/analysis/lens_borders.cpp \
  integral/analysis/lens_borders.h \
  integral/analysis/page_code.cpp \
  integral/analysis/page_code.h \
  integral/analysis/page_corners.cpp \
  integral/analysis/page_corners.h \
  integral/analysis/page_targets.cpp \
  integral/analysis/page_targets.h \
  integral/analysis/part_fits.cpp \
  integral/analysis/part_fits.h \
  integral/analysis/photo_camera.cpp \
  integral/analysis/photo_camera.h \
  integral/analysis/photo_plane.cpp \
  integral/analysis/photo_plane.h \
  integral/analysis/rectify.cpp \
  integral/analysis/rectify.h \
  integral/analysis/rectify_report.cpp \
  integral/analysis/rectify_report.h \
  integral/analysis/scan_colour.cpp \
  integral/analysis/scan_colour.h \
  integral/analysis/scan_map.h \
  integral/analysis/sheet_calibration.cpp \
  integral/analysis/sheet_calibration.h \
  integral/analysis/sheet_view.cpp \
  integral/analysis/sheet_view.h \
  integral/analysis/spectrum.cpp \
  integral/analysis/spectrum.h \
  integral/analysis/sure_lattice.cpp
