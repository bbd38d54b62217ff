# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/compare: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/compare/compare.cpp \
  integral/compare/compare.h \
  integral/compare/compare_files.cpp \
  integral/compare/compare_files.h \
  integral/compare/compare_geometry.cpp \
  integral/compare/compare_geometry.h \
  integral/compare/compare_limits.cpp \
  integral/compare/compare_limits.h \
  integral/compare/comparison_rules.cpp \
  integral/compare/comparison_rules.h \
  integral/compare/figures_json.cpp \
  integral/compare/figures_json.h \
  integral/compare/figures_text.cpp \
  integral/compare/figures_text.h \
  integral/compare/flip.cpp \
  integral/compare/flip.h \
  integral/compare/flip_kernels.cpp \
  integral/compare/flip_kernels.h \
  integral/compare/flip_loops.cpp \
  integral/compare/flip_loops.h \
  integral/compare/flip_map.cpp \
  integral/compare/flip_map.h \
  integral/compare/pixel_weights.cpp \
  integral/compare/pixel_weights.h \
  integral/compare/seen.cpp \
  integral/compare/seen.h \
  integral/compare/similarity.cpp \
  integral/compare/similarity.h \
  integral/compare/suite_accept.cpp \
  integral/compare/suite_accept.h \
  integral/compare/suite_pair.cpp \
  integral/compare/suite_pair.h \
  integral/compare/suite_pictures.cpp \
  integral/compare/suite_pictures.h \
  integral/compare/suite_renames.cpp \
  integral/compare/suite_renames.h \
  integral/compare/suite_report.cpp \
  integral/compare/suite_report.h \
  integral/compare/suite_run.cpp \
  integral/compare/suite_run.h \
  integral/compare/suite_summary.cpp \
  integral/compare/suite_summary.h \
  integral/compare/tolerances.cpp \
  integral/compare/tolerances.h
