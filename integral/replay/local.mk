# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/replay: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/replay/arrange.cpp \
  integral/replay/arrange.h \
  integral/replay/compare.cpp \
  integral/replay/compare.h \
  integral/replay/interpolate.h \
  integral/replay/parallel_views.cpp \
  integral/replay/parallel_views.h \
  integral/replay/perspective_views.cpp \
  integral/replay/perspective_views.h \
  integral/replay/replay.cpp \
  integral/replay/replay.h
