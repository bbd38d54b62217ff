# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/output: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/output/cups_raster.cpp \
  integral/output/cups_raster.h \
  integral/output/print_media.cpp \
  integral/output/print_media.h \
  integral/output/print_queue.cpp \
  integral/output/print_queue.h \
  integral/output/quilt.cpp \
  integral/output/quilt.h \
  integral/output/spool.cpp \
  integral/output/spool.h
