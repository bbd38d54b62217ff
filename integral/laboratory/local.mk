# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/laboratory: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/laboratory/lens_shape.cpp \
  integral/laboratory/lens_shape.h \
  integral/laboratory/mask_picture.cpp \
  integral/laboratory/mask_picture.h \
  integral/laboratory/multiview.cpp \
  integral/laboratory/multiview.h \
  integral/laboratory/multiview_text.cpp \
  integral/laboratory/multiview_text.h \
  integral/laboratory/resolution.cpp \
  integral/laboratory/resolution.h \
  integral/laboratory/resolution_text.cpp \
  integral/laboratory/resolution_text.h \
  integral/laboratory/response.cpp \
  integral/laboratory/response.h \
  integral/laboratory/scene_pictures.cpp \
  integral/laboratory/scene_pictures.h \
  integral/laboratory/view_figures.cpp \
  integral/laboratory/view_figures.h \
  integral/laboratory/view_switching.cpp \
  integral/laboratory/view_switching.h
