# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/lightfield: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/lightfield/beam_overlaps.cpp \
  integral/lightfield/beam_overlaps.h \
  integral/lightfield/camera_words.cpp \
  integral/lightfield/camera_words.h \
  integral/lightfield/depth_advice.cpp \
  integral/lightfield/depth_advice.h \
  integral/lightfield/depth_range.cpp \
  integral/lightfield/depth_range.h \
  integral/lightfield/encoding.h \
  integral/lightfield/error_estimate.cpp \
  integral/lightfield/error_estimate.h \
  integral/lightfield/eye_place.h \
  integral/lightfield/first_samples.cpp \
  integral/lightfield/first_samples.h \
  integral/lightfield/frame.cpp \
  integral/lightfield/frame.h \
  integral/lightfield/frame_metadata.cpp \
  integral/lightfield/frame_metadata.h \
  integral/lightfield/geometry_json.cpp \
  integral/lightfield/geometry_json.h \
  integral/lightfield/image.cpp \
  integral/lightfield/image.h \
  integral/lightfield/known_sheets.cpp \
  integral/lightfield/known_sheets.h \
  integral/lightfield/lens_profile.cpp \
  integral/lightfield/lens_profile.h \
  integral/lightfield/names.cpp \
  integral/lightfield/names.h \
  integral/lightfield/pass_schedule.cpp \
  integral/lightfield/pass_schedule.h \
  integral/lightfield/pixel_sampler.cpp \
  integral/lightfield/pixel_sampler.h \
  integral/lightfield/quilt_name.cpp \
  integral/lightfield/quilt_name.h \
  integral/lightfield/quilt_sampler.cpp \
  integral/lightfield/quilt_sampler.h \
  integral/lightfield/reconstruction.cpp \
  integral/lightfield/reconstruction.h \
  integral/lightfield/refinement.cpp \
  integral/lightfield/refinement.h \
  integral/lightfield/sample_points.cpp \
  integral/lightfield/sample_points.h \
  integral/lightfield/sampling_forecast.cpp \
  integral/lightfield/sampling_forecast.h \
  integral/lightfield/scene_depth_report.cpp \
  integral/lightfield/scene_depth_report.h \
  integral/lightfield/sheet_figures.cpp \
  integral/lightfield/sheet_figures.h \
  integral/lightfield/sheet_list.cpp \
  integral/lightfield/sheet_list.h \
  integral/lightfield/sheet_report.cpp \
  integral/lightfield/sheet_report.h \
  integral/lightfield/tabulated_curve.h \
  integral/lightfield/view_grid.h
