# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/depth: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/depth/depth_files.cpp \
  integral/depth/depth_files.h \
  integral/depth/depth_input.cpp \
  integral/depth/depth_input.h \
  integral/depth/depth_page.cpp \
  integral/depth/depth_page.h \
  integral/depth/depth_picture.cpp \
  integral/depth/depth_picture.h \
  integral/depth/depth_picture_scale.cpp \
  integral/depth/depth_picture_scale.h \
  integral/depth/depth_quality.cpp \
  integral/depth/depth_quality.h \
  integral/depth/depth_report.cpp \
  integral/depth/depth_report.h \
  integral/depth/depth_scores.cpp \
  integral/depth/depth_scores.h \
  integral/depth/disparity_search.cpp \
  integral/depth/disparity_search.h \
  integral/depth/edge_filter.cpp \
  integral/depth/edge_filter.h \
  integral/depth/frame_views.cpp \
  integral/depth/multibaseline.cpp \
  integral/depth/multibaseline.h \
  integral/depth/plane_filter.cpp \
  integral/depth/plane_filter.h \
  integral/depth/ray_trace.cpp \
  integral/depth/ray_trace.h \
  integral/depth/reflections.cpp \
  integral/depth/reflections.h \
  integral/depth/relief.cpp \
  integral/depth/relief.h \
  integral/depth/relief_frame.cpp \
  integral/depth/relief_frame.h \
  integral/depth/relief_input.cpp \
  integral/depth/relief_input.h \
  integral/depth/row_loops.cpp \
  integral/depth/row_loops.h \
  integral/depth/spread.cpp \
  integral/depth/spread.h \
  integral/depth/texture.cpp \
  integral/depth/texture.h \
  integral/depth/view_order.cpp \
  integral/depth/view_order.h \
  integral/depth/view_set.cpp \
  integral/depth/view_set.h \
  integral/depth/votes.cpp \
  integral/depth/votes.h
