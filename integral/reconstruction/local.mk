# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/reconstruction: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/reconstruction/beam_footprint.cpp \
  integral/reconstruction/beam_footprint.h \
  integral/reconstruction/beam_samples.cpp \
  integral/reconstruction/beam_samples.h \
  integral/reconstruction/block_window.h \
  integral/reconstruction/clipped_pixel.cpp \
  integral/reconstruction/clipped_pixel.h \
  integral/reconstruction/layer_occlusion.cpp \
  integral/reconstruction/layer_occlusion.h \
  integral/reconstruction/layer_plane.h \
  integral/reconstruction/light_field_image.cpp \
  integral/reconstruction/light_field_image.h \
  integral/reconstruction/noise_filter.cpp \
  integral/reconstruction/noise_filter.h \
  integral/reconstruction/pass_rows.cpp \
  integral/reconstruction/pass_rows.h \
  integral/reconstruction/pass_schedule.cpp \
  integral/reconstruction/pass_schedule.h \
  integral/reconstruction/reconstruction.cpp \
  integral/reconstruction/reconstruction.h \
  integral/reconstruction/refinement.cpp \
  integral/reconstruction/refinement.h \
  integral/reconstruction/sample_fit.cpp \
  integral/reconstruction/sample_fit.h \
  integral/reconstruction/sample_layers.cpp \
  integral/reconstruction/sample_layers.h \
  integral/reconstruction/signal_and_noise.h \
  integral/reconstruction/split_half_error.cpp \
  integral/reconstruction/split_half_error.h \
  integral/reconstruction/view_reuse.cpp \
  integral/reconstruction/view_reuse.h \
  integral/reconstruction/weighted_samples.cpp \
  integral/reconstruction/weighted_samples.h
