# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/panel: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/panel/blended_values.cpp \
  integral/panel/blended_values.h \
  integral/panel/interlace.cpp \
  integral/panel/interlace.h \
  integral/panel/interlace_avx2.cpp \
  integral/panel/interlace_avx2.h \
  integral/panel/interlace_rows.cpp \
  integral/panel/interlace_rows.h \
  integral/panel/lens_cards.cpp \
  integral/panel/lens_cards.h \
  integral/panel/lens_readings.cpp \
  integral/panel/lens_readings.h \
  integral/panel/panel_cards.cpp \
  integral/panel/panel_cards.h \
  integral/panel/panel_files.cpp \
  integral/panel/panel_files.h \
  integral/panel/panel_images.cpp \
  integral/panel/panel_images.h \
  integral/panel/panel_likeness.cpp \
  integral/panel/panel_likeness.h \
  integral/panel/panel_mapping.cpp \
  integral/panel/panel_mapping.h \
  integral/panel/panel_page.cpp \
  integral/panel/panel_page.h \
  integral/panel/quilt_sequence.cpp \
  integral/panel/quilt_sequence.h

# The page's own files.
page_files += \
  integral/panel/panel_page.glsl \
  integral/panel/panel_page.html \
  integral/panel/panel_page.js
page_objects += integral/panel/panel_page.$(OBJEXT) \
  integral/panel/build_sanitized_libintegral_a-panel_page.$(OBJEXT)
