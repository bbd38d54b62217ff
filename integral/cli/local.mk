# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of the integral program: one line per file, headers too.

build_bin_integral_SOURCES += \
  integral/cli/batch_check.cpp \
  integral/cli/batch_check.h \
  integral/cli/batch_command.cpp \
  integral/cli/choices.h \
  integral/cli/combine_command.cpp \
  integral/cli/command.cpp \
  integral/cli/command.h \
  integral/cli/command_pages.cpp \
  integral/cli/command_pages.h \
  integral/cli/compare_command.cpp \
  integral/cli/compare_options.cpp \
  integral/cli/compare_options.h \
  integral/cli/compare_suite.cpp \
  integral/cli/depth_command.cpp \
  integral/cli/fit_options.cpp \
  integral/cli/fit_options.h \
  integral/cli/flip_command.cpp \
  integral/cli/geometry_options.cpp \
  integral/cli/geometry_options.h \
  integral/cli/layers_command.cpp \
  integral/cli/lcd_command.cpp \
  integral/cli/lcd_options.cpp \
  integral/cli/lcd_options.h \
  integral/cli/main.cpp \
  integral/cli/mask_command.cpp \
  integral/cli/multiview_command.cpp \
  integral/cli/page_commands.cpp \
  integral/cli/page_commands.h \
  integral/cli/print_chart.cpp \
  integral/cli/print_chart.h \
  integral/cli/print_command.cpp \
  integral/cli/print_options.cpp \
  integral/cli/print_options.h \
  integral/cli/progress.cpp \
  integral/cli/progress.h \
  integral/cli/rectify_command.cpp \
  integral/cli/replay_command.cpp \
  integral/cli/replay_options.cpp \
  integral/cli/replay_options.h \
  integral/cli/resolve_command.cpp \
  integral/cli/series_options.cpp \
  integral/cli/series_options.h \
  integral/cli/sheet_command.cpp \
  integral/cli/studio_command.cpp \
  integral/cli/thread_options.cpp \
  integral/cli/thread_options.h \
  integral/cli/tune_command.cpp \
  integral/cli/values.cpp \
  integral/cli/values.h \
  integral/cli/views_command.cpp \
  integral/cli/views_options.h \
  integral/cli/views_to_frame.cpp \
  integral/cli/wireframe_command.cpp
