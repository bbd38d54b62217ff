# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/views: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/views/combine.cpp \
  integral/views/combine.h \
  integral/views/covered_means.cpp \
  integral/views/covered_means.h \
  integral/views/deghost.cpp \
  integral/views/deghost.h \
  integral/views/flip.cpp \
  integral/views/flip.h \
  integral/views/frame_of_layers.cpp \
  integral/views/frame_of_layers.h \
  integral/views/frame_of_shares.cpp \
  integral/views/frame_of_shares.h \
  integral/views/frame_of_views.cpp \
  integral/views/frame_of_views.h \
  integral/views/layer_picture.h \
  integral/views/layers.cpp \
  integral/views/layers.h \
  integral/views/layers_text.cpp \
  integral/views/light_field.cpp \
  integral/views/light_field.h \
  integral/views/made_frame.h \
  integral/views/parallel_views.cpp \
  integral/views/parallel_views.h \
  integral/views/perspective_views.cpp \
  integral/views/perspective_views.h \
  integral/views/quilt.cpp \
  integral/views/quilt.h \
  integral/views/rgbd.cpp \
  integral/views/rgbd.h \
  integral/views/view_export.cpp \
  integral/views/view_export.h \
  integral/views/view_files.cpp \
  integral/views/view_files.h \
  integral/views/view_input.cpp \
  integral/views/view_input.h \
  integral/views/view_lenses.cpp \
  integral/views/view_lenses.h \
  integral/views/views_loss.cpp \
  integral/views/zone_view.cpp \
  integral/views/zone_view.h \
  integral/views/zone_view_text.cpp
