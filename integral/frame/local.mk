# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/frame: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/frame/depth_attribute.h \
  integral/frame/depth_range.cpp \
  integral/frame/depth_range.h \
  integral/frame/encoding.h \
  integral/frame/error_estimate.cpp \
  integral/frame/error_estimate.h \
  integral/frame/eye_place.h \
  integral/frame/frame.cpp \
  integral/frame/frame.h \
  integral/frame/frame_metadata.cpp \
  integral/frame/frame_metadata.h \
  integral/frame/geometry_difference.cpp \
  integral/frame/geometry_difference.h \
  integral/frame/geometry_json.cpp \
  integral/frame/geometry_json.h \
  integral/frame/image.cpp \
  integral/frame/image.h \
  integral/frame/linear_colour.cpp \
  integral/frame/linear_colour.h \
  integral/frame/linear_writer.cpp \
  integral/frame/linear_writer.h \
  integral/frame/names.cpp \
  integral/frame/names.h \
  integral/frame/picture_fit.cpp \
  integral/frame/picture_fit.h \
  integral/frame/quilt_geometry.h \
  integral/frame/quilt_name.cpp \
  integral/frame/quilt_name.h \
  integral/frame/recorded_camera.cpp \
  integral/frame/recorded_camera.h \
  integral/frame/view_eyes.h \
  integral/frame/view_grid.h
