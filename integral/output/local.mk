# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/output: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/output/quilt.cpp \
  integral/output/quilt.h
