# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/lightfield: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/lightfield/frame.cpp \
  integral/lightfield/frame.h \
  integral/lightfield/frame_metadata.cpp \
  integral/lightfield/frame_metadata.h \
  integral/lightfield/image.cpp \
  integral/lightfield/image.h \
  integral/lightfield/names.cpp \
  integral/lightfield/names.h \
  integral/lightfield/parallel.cpp \
  integral/lightfield/parallel.h \
  integral/lightfield/sheet_figures.cpp \
  integral/lightfield/sheet_figures.h
