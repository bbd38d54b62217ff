# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/studio: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/studio/approval.cpp \
  integral/studio/approval.h \
  integral/studio/approval_page.cpp \
  integral/studio/approval_page.h \
  integral/studio/placement_settings.cpp \
  integral/studio/placement_settings.h \
  integral/studio/probe.cpp \
  integral/studio/probe.h \
  integral/studio/scene_renders.cpp \
  integral/studio/scene_renders.h \
  integral/studio/server.h \
  integral/studio/studio.cpp \
  integral/studio/studio.h \
  integral/studio/studio_page.cpp

if HAVE_HTTPLIB
build_lib_libintegral_a_SOURCES += integral/studio/server.cpp
else
build_lib_libintegral_a_SOURCES += integral/studio/without_server.cpp
endif

# The page's own files, as C++ strings named like them: studio_page.html is studio_page_html.
studio_page_files = \
  integral/studio/live_view.glsl \
  integral/studio/live_view.js \
  integral/studio/studio_controls.js \
  integral/studio/studio_page.html \
  integral/studio/studio_page.js

EXTRA_DIST += $(studio_page_files)
CLEANFILES += build/generated/studio_page_text.h
build/generated/studio_page_text.h: $(studio_page_files)
	$(AM_V_GEN)$(MKDIR_P) build/generated && $(srcdir)/unix/texts-as-strings $(studio_page_files:%=$(srcdir)/%) > $@.tmp && \
	    mv $@.tmp $@
integral/studio/studio_page.$(OBJEXT): build/generated/studio_page_text.h build/generated/replay_page_text.h
integral/studio/build_sanitized_libintegral_a-studio_page.$(OBJEXT): build/generated/studio_page_text.h build/generated/replay_page_text.h
