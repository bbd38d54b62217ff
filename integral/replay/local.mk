# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/replay: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/replay/arrange.cpp \
  integral/replay/arrange.h \
  integral/replay/compare_seen.cpp \
  integral/replay/compare_seen.h \
  integral/replay/draft_frame.cpp \
  integral/replay/draft_frame.h \
  integral/replay/fit_part.cpp \
  integral/replay/fit_part.h \
  integral/replay/interpolate.h \
  integral/replay/replay.cpp \
  integral/replay/replay.h \
  integral/replay/replay_files.cpp \
  integral/replay/replay_files.h \
  integral/replay/replay_page.cpp \
  integral/replay/replay_page.h \
  integral/replay/replay_series.cpp \
  integral/replay/replay_series.h \
  integral/replay/suite_comparators.cpp \
  integral/replay/suite_comparators.h

# The interactive page's own files.
page_files += \
  integral/replay/comparison_page.js \
  integral/replay/comparison_part.html \
  integral/replay/replay_drawing.js \
  integral/replay/replay_page.glsl \
  integral/replay/replay_page.html \
  integral/replay/replay_page.js \
  integral/replay/report_comparator.js \
  integral/replay/sheet_optics.glsl
page_objects += integral/replay/replay_page.$(OBJEXT) \
  integral/replay/build_sanitized_libintegral_a-replay_page.$(OBJEXT) \
  integral/replay/suite_comparators.$(OBJEXT) \
  integral/replay/build_sanitized_libintegral_a-suite_comparators.$(OBJEXT)
