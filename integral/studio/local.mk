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

# The studio page's own files, as C++ strings named like them: live_view.js is live_view_js.
studio_page_files = \
  integral/studio/live_view.glsl \
  integral/studio/live_view.js

EXTRA_DIST += $(studio_page_files)
CLEANFILES += build/generated/studio_page_text.h
build/generated/studio_page_text.h: $(studio_page_files)
	$(AM_V_GEN)$(MKDIR_P) build/generated && { \
	  for file in $(studio_page_files); do \
	    if test -f $$file; then path=$$file; else path=$(srcdir)/$$file; fi; \
	    echo "const char `basename $$file | tr . _`[] = R\"page(" && cat $$path && echo ')page";' || exit 1; \
	  done; } > $@.tmp && mv $@.tmp $@
