# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/base: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/base/json.cpp \
  integral/base/json.h \
  integral/base/message_text.cpp \
  integral/base/message_text.h
