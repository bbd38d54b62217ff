# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/fabrication: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/fabrication/lens_shape.cpp \
  integral/fabrication/lens_shape.h \
  integral/fabrication/mask_picture.cpp \
  integral/fabrication/mask_picture.h \
  integral/fabrication/response.cpp \
  integral/fabrication/response.h
