# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/studio: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/studio/approval.cpp \
  integral/studio/approval.h \
  integral/studio/approval_page.cpp \
  integral/studio/approval_page.h \
  integral/studio/background_work.h \
  integral/studio/file_stamp.h \
  integral/studio/mesh_input.cpp \
  integral/studio/mesh_input.h \
  integral/studio/panel_window.cpp \
  integral/studio/panel_window.h \
  integral/studio/picture_input.cpp \
  integral/studio/picture_input.h \
  integral/studio/placement_settings.cpp \
  integral/studio/placement_settings.h \
  integral/studio/probe.cpp \
  integral/studio/probe.h \
  integral/studio/scene_input.cpp \
  integral/studio/scene_input.h \
  integral/studio/server.h \
  integral/studio/studio.cpp \
  integral/studio/studio.h \
  integral/studio/studio_input.h \
  integral/studio/studio_page.cpp \
  integral/studio/studio_renders.cpp \
  integral/studio/studio_renders.h

if HAVE_HTTPLIB
build_lib_libintegral_a_SOURCES += integral/studio/server.cpp
else
build_lib_libintegral_a_SOURCES += integral/studio/without_server.cpp
endif

# The page's own files.
page_files += \
  integral/studio/live_view.glsl \
  integral/studio/live_view.js \
  integral/studio/studio_controls.js \
  integral/studio/studio_page.html \
  integral/studio/studio_page.js
page_objects += integral/studio/studio_page.$(OBJEXT) \
  integral/studio/build_sanitized_libintegral_a-studio_page.$(OBJEXT)
