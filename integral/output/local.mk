# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/output: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/output/colour_profile.cpp \
  integral/output/colour_profile.h \
  integral/output/cups_raster.cpp \
  integral/output/cups_raster.h \
  integral/output/device_text.cpp \
  integral/output/device_text.h \
  integral/output/interlace.cpp \
  integral/output/interlace.h \
  integral/output/interlace_avx2.h \
  integral/output/interlace_rays.cpp \
  integral/output/interlace_rays.h \
  integral/output/interlace_rows.cpp \
  integral/output/interlace_rows.h \
  integral/output/known_panels.cpp \
  integral/output/looking_glass.cpp \
  integral/output/looking_glass.h \
  integral/output/page.cpp \
  integral/output/page.h \
  integral/output/page_marks.cpp \
  integral/output/page_marks.h \
  integral/output/page_pdf.cpp \
  integral/output/page_pdf.h \
  integral/output/page_raster.cpp \
  integral/output/page_raster.h \
  integral/output/panel.cpp \
  integral/output/panel.h \
  integral/output/panel_cards.cpp \
  integral/output/panel_cards.h \
  integral/output/paper.cpp \
  integral/output/paper.h \
  integral/output/pitch_chart.cpp \
  integral/output/pitch_chart.h \
  integral/output/pitch_wizard.cpp \
  integral/output/pitch_wizard.h \
  integral/output/print_media.cpp \
  integral/output/print_media.h \
  integral/output/print_queue.cpp \
  integral/output/print_queue.h \
  integral/output/quilt.cpp \
  integral/output/quilt.h \
  integral/output/screen_picture.cpp \
  integral/output/screen_picture.h \
  integral/output/screen_play.cpp \
  integral/output/screen_window.cpp \
  integral/output/screen_window.h \
  integral/output/screens.cpp \
  integral/output/screens.h \
  integral/output/screens_x.cpp \
  integral/output/spool.cpp \
  integral/output/spool.h
