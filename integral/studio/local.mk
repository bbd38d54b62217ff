# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/studio: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/studio/approval.cpp \
  integral/studio/approval.h \
  integral/studio/approval_page.cpp \
  integral/studio/approval_page.h \
  integral/studio/server.h

if HAVE_HTTPLIB
build_lib_libintegral_a_SOURCES += integral/studio/server.cpp
else
build_lib_libintegral_a_SOURCES += integral/studio/without_server.cpp
endif
