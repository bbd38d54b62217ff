# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/sampling: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/sampling/lens_profile.cpp \
  integral/sampling/lens_profile.h \
  integral/sampling/pixel_beam.cpp \
  integral/sampling/pixel_sampler.cpp \
  integral/sampling/pixel_sampler.h \
  integral/sampling/quilt_sampler.cpp \
  integral/sampling/quilt_sampler.h \
  integral/sampling/sample_points.cpp \
  integral/sampling/sample_points.h
