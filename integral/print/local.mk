# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/print: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/print/cairo_handles.h \
  integral/print/calibration_layout.cpp \
  integral/print/calibration_layout.h \
  integral/print/calibration_page.cpp \
  integral/print/calibration_page.h \
  integral/print/chart_lines.cpp \
  integral/print/chart_lines.h \
  integral/print/chart_page.cpp \
  integral/print/chart_page.h \
  integral/print/colour_profile.cpp \
  integral/print/colour_profile.h \
  integral/print/cups_raster.cpp \
  integral/print/cups_raster.h \
  integral/print/frame_print.cpp \
  integral/print/frame_print.h \
  integral/print/gang.cpp \
  integral/print/gang.h \
  integral/print/lens_halftone.cpp \
  integral/print/lens_halftone.h \
  integral/print/page.cpp \
  integral/print/page.h \
  integral/print/page_marks.cpp \
  integral/print/page_marks.h \
  integral/print/page_pdf.cpp \
  integral/print/page_pdf.h \
  integral/print/page_raster.cpp \
  integral/print/page_raster.h \
  integral/print/page_text.cpp \
  integral/print/page_text.h \
  integral/print/paper.cpp \
  integral/print/paper.h \
  integral/print/pdfx.cpp \
  integral/print/pdfx.h \
  integral/print/pitch_chart.cpp \
  integral/print/pitch_chart.h \
  integral/print/pitch_report.cpp \
  integral/print/pitch_report.h \
  integral/print/pitch_wizard.cpp \
  integral/print/pitch_wizard.h \
  integral/print/print_media.cpp \
  integral/print/print_media.h \
  integral/print/print_queue.cpp \
  integral/print/print_queue.h \
  integral/print/relief_chart.cpp \
  integral/print/relief_chart.h \
  integral/print/seen_error.cpp \
  integral/print/seen_error.h \
  integral/print/spool.cpp \
  integral/print/spool.h \
  integral/print/spool_document.cpp \
  integral/print/spool_document.h
