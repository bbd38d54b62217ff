# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/screen: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/screen/screen_picture.cpp \
  integral/screen/screen_picture.h \
  integral/screen/screen_play.cpp \
  integral/screen/screen_show.cpp \
  integral/screen/screen_show.h \
  integral/screen/screen_text.cpp \
  integral/screen/screen_text.h \
  integral/screen/screen_window.cpp \
  integral/screen/screen_window.h \
  integral/screen/screens.cpp \
  integral/screen/screens.h \
  integral/screen/screens_x.cpp
