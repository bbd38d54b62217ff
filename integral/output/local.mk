# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/output: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/output/device_text.cpp \
  integral/output/device_text.h \
  integral/output/pitch_chart.cpp \
  integral/output/pitch_chart.h \
  integral/output/pitch_wizard.cpp \
  integral/output/pitch_wizard.h \
  integral/output/quilt.cpp \
  integral/output/quilt.h
