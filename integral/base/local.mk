# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/base: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/base/atomic_file.cpp \
  integral/base/atomic_file.h \
  integral/base/avx2.h \
  integral/base/constants.h \
  integral/base/eight_floats.h \
  integral/base/file_bytes.cpp \
  integral/base/file_bytes.h \
  integral/base/first_steps.cpp \
  integral/base/first_steps.h \
  integral/base/folders.cpp \
  integral/base/folders.h \
  integral/base/four_floats.h \
  integral/base/interrupt.cpp \
  integral/base/interrupt.h \
  integral/base/json.cpp \
  integral/base/json.h \
  integral/base/json_difference.cpp \
  integral/base/json_difference.h \
  integral/base/json_fields.cpp \
  integral/base/json_fields.h \
  integral/base/memory.cpp \
  integral/base/memory.h \
  integral/base/message_text.cpp \
  integral/base/message_text.h \
  integral/base/notices.cpp \
  integral/base/notices.h \
  integral/base/number_text.cpp \
  integral/base/number_text.h \
  integral/base/parallel.cpp \
  integral/base/parallel.h \
  integral/base/programs.cpp \
  integral/base/programs.h \
  integral/base/tabulated_curve.h \
  integral/base/text_columns.h \
  integral/base/vector_loops.h
