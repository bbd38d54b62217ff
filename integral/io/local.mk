# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/io: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/io/animation.cpp \
  integral/io/animation.h \
  integral/io/codecs.cpp \
  integral/io/codecs.h \
  integral/io/exr_codec.cpp \
  integral/io/exr_header.cpp \
  integral/io/exr_header.h \
  integral/io/html_page.cpp \
  integral/io/html_page.h \
  integral/io/image_file.cpp \
  integral/io/image_file.h \
  integral/io/image_writer.cpp \
  integral/io/input_file.cpp \
  integral/io/input_file.h \
  integral/io/jpeg_codec.cpp \
  integral/io/markup.cpp \
  integral/io/markup.h \
  integral/io/memory.cpp \
  integral/io/memory.h \
  integral/io/mpo_file.cpp \
  integral/io/mpo_file.h \
  integral/io/picture_series.cpp \
  integral/io/picture_series.h \
  integral/io/pdf_file.cpp \
  integral/io/pdf_file.h \
  integral/io/pfm_file.cpp \
  integral/io/pfm_file.h \
  integral/io/plot.cpp \
  integral/io/plot.h \
  integral/io/plot_axis.cpp \
  integral/io/plot_axis.h \
  integral/io/plot_canvas.cpp \
  integral/io/plot_canvas.h \
  integral/io/plot_names.cpp \
  integral/io/plot_names.h \
  integral/io/plot_series.cpp \
  integral/io/plot_series.h \
  integral/io/png_codec.cpp \
  integral/io/png_spans.cpp \
  integral/io/png_spans.h \
  integral/io/release.h \
  integral/io/sheet_plots.cpp \
  integral/io/sheet_plots.h \
  integral/io/tiff_codec.cpp \
  integral/io/video.cpp \
  integral/io/video.h
