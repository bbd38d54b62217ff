# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/multiview: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/multiview/multiview.cpp \
  integral/multiview/multiview.h \
  integral/multiview/multiview_text.cpp \
  integral/multiview/multiview_text.h \
  integral/multiview/scene_pictures.cpp \
  integral/multiview/scene_pictures.h \
  integral/multiview/view_figures.cpp \
  integral/multiview/view_figures.h \
  integral/multiview/view_switching.cpp \
  integral/multiview/view_switching.h
