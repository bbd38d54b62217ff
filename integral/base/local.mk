# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/base: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/base/avx2.h \
  integral/base/command_pages.cpp \
  integral/base/command_pages.h \
  integral/base/constants.h \
  integral/base/file_bytes.cpp \
  integral/base/file_bytes.h \
  integral/base/first_steps.cpp \
  integral/base/first_steps.h \
  integral/base/folders.cpp \
  integral/base/folders.h \
  integral/base/interrupt.cpp \
  integral/base/interrupt.h \
  integral/base/json.cpp \
  integral/base/json.h \
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
  integral/base/program_path.cpp \
  integral/base/program_path.h \
  integral/base/unfinished_file.cpp \
  integral/base/unfinished_file.h \
  integral/base/vector_loops.h
