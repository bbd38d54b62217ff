# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/batch: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/batch/strips.cpp \
  integral/batch/strips.h
