# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/sheet: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/sheet/camera_words.cpp \
  integral/sheet/camera_words.h \
  integral/sheet/cubevi.cpp \
  integral/sheet/cubevi.h \
  integral/sheet/depth_advice.cpp \
  integral/sheet/depth_advice.h \
  integral/sheet/known_panels.cpp \
  integral/sheet/known_sheets.cpp \
  integral/sheet/known_sheets.h \
  integral/sheet/looking_glass.cpp \
  integral/sheet/looking_glass.h \
  integral/sheet/panel.cpp \
  integral/sheet/panel.h \
  integral/sheet/panel_quilt.cpp \
  integral/sheet/panel_quilt.h \
  integral/sheet/panel_render.cpp \
  integral/sheet/panel_render.h \
  integral/sheet/panel_text.cpp \
  integral/sheet/panel_text.h \
  integral/sheet/sampling_forecast.cpp \
  integral/sheet/sampling_forecast.h \
  integral/sheet/scene_depth_report.cpp \
  integral/sheet/scene_depth_report.h \
  integral/sheet/scene_fit.cpp \
  integral/sheet/scene_fit.h \
  integral/sheet/sheet_figures.cpp \
  integral/sheet/sheet_figures.h \
  integral/sheet/sheet_list.cpp \
  integral/sheet/sheet_list.h \
  integral/sheet/sheet_plots.cpp \
  integral/sheet/sheet_plots.h \
  integral/sheet/sheet_report.cpp \
  integral/sheet/sheet_report.h \
  integral/sheet/zone_shares.cpp \
  integral/sheet/zone_shares.h
