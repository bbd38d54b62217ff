# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/resolution: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/resolution/resolution.cpp \
  integral/resolution/resolution.h \
  integral/resolution/resolution_text.cpp \
  integral/resolution/resolution_text.h
