# SPDX-License-Identifier: AGPL-3.0-or-later
# libintegral (what POV-Ray's hooks and the integral program share) and the program itself.

lib_LIBRARIES = build/lib/libintegral.a
build_lib_libintegral_a_SOURCES =

bin_PROGRAMS += build/bin/integral
build_bin_integral_SOURCES =
build_bin_integral_LDADD = $(LIBINTEGRAL_LIBS) $(SDL2_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS)

# Pages' own files, and the objects that contain them.
page_files =
page_objects =

include $(srcdir)/integral/base/local.mk
include $(srcdir)/integral/optics/local.mk
include $(srcdir)/integral/frame/local.mk
include $(srcdir)/integral/io/local.mk
include $(srcdir)/integral/sampling/local.mk
include $(srcdir)/integral/reconstruction/local.mk
include $(srcdir)/integral/sheet/local.mk
include $(srcdir)/integral/compare/local.mk
include $(srcdir)/integral/replay/local.mk
include $(srcdir)/integral/views/local.mk
include $(srcdir)/integral/panel/local.mk
include $(srcdir)/integral/print/local.mk
include $(srcdir)/integral/screen/local.mk
include $(srcdir)/integral/depth/local.mk
include $(srcdir)/integral/analysis/local.mk
include $(srcdir)/integral/wireframe/local.mk
include $(srcdir)/integral/batch/local.mk
include $(srcdir)/integral/laboratory/local.mk
include $(srcdir)/integral/studio/local.mk
include $(srcdir)/integral/python/local.mk
include $(srcdir)/integral/cli/local.mk

# The pages' files as C++ strings named like them: replay_page.html is replay_page_html.
EXTRA_DIST += $(page_files)
CLEANFILES += build/generated/page_texts.h
build/generated/page_texts.h: $(page_files)
	$(AM_V_GEN)$(MKDIR_P) build/generated && $(srcdir)/unix/texts-as-strings $(page_files:%=$(srcdir)/%) > $@.tmp && \
	    mv $@.tmp $@
$(page_objects): build/generated/page_texts.h

# Man pages and completion for bash say what its commands declare.
integral_commands = studio sheet replay views flip layers combine print lcd depth compare tune batch wireframe rectify mask resolve multiview
integral_pages = build/share/man/integral.1 $(patsubst %,build/share/man/integral-%.1,$(integral_commands))
man_MANS += $(integral_pages)
build/share/man/integral.1: build/bin/integral
	$(AM_V_GEN)$(MKDIR_P) build/share/man && build/bin/integral help --man > $@.tmp && mv $@.tmp $@
build/share/man/integral-%.1: build/bin/integral
	$(AM_V_GEN)$(MKDIR_P) build/share/man && build/bin/integral help --man $* > $@.tmp && mv $@.tmp $@

completionsdir = $(datadir)/bash-completion/completions
completions_DATA = build/share/bash-completion/integral
build/share/bash-completion/integral: build/bin/integral
	$(AM_V_GEN)$(MKDIR_P) $(@D) && build/bin/integral help --bash > $@.tmp && mv $@.tmp $@
CLEANFILES += $(integral_pages) $(completions_DATA)

# The heads of the commands' pages in the manual; what is written by hand below them is kept.
.PHONY: command-pages
command-pages: build/bin/integral
	@for command in $(integral_commands); do \
	    page=$(srcdir)/doc/commands/$$command.md; \
	    { build/bin/integral help --markdown $$command; \
	      test ! -e $$page || sed '1,/^<!-- Above: written by/d' $$page; } > $$page.new && \
	    mv $$page.new $$page || exit 1; done

# The messages of doc/messages.md, from the sources; what it says of each is kept.
.PHONY: messages-page
messages-page:
	$(srcdir)/doc/messages/make-page $(srcdir) > $(srcdir)/doc/messages.md.new && \
	    mv $(srcdir)/doc/messages.md.new $(srcdir)/doc/messages.md

# The INI files of papers and panels, from the program's tables.
.PHONY: settings
settings: build/bin/integral
	INTEGRAL=build/bin/integral $(srcdir)/unix/make-settings $(srcdir)/include/integral

# The words that editors colour, from the sources.
.PHONY: editor-words
editor-words:
	$(srcdir)/doc/editors/make-words $(srcdir)/doc/editors

# The gallery: minutes of rendering for each scene. What is there already is kept.
.PHONY: gallery
gallery: all
	$(srcdir)/doc/gallery/make-gallery build/gallery

# The manual as HTML pages that work from a folder.
.PHONY: manual
manual:
	rm -rf build/manual && $(srcdir)/doc/html/make-manual $(srcdir) build/manual
	@echo build/manual/index.html is the manual

# For programs of others: the headers that doc/library.md is about, those that they include, and how to
# compile and link with them. All other headers are private.
interface_headers = base/file_bytes.h base/parallel.h optics/lens_sheet.h optics/camera.h optics/lens_mapping.h \
  optics/beam.h optics/film_in_sight.h sheet/sheet_figures.h frame/frame.h frame/recorded_camera.h io/image_file.h replay/replay.h views/view_input.h \
  views/perspective_views.h views/light_field.h views/parallel_views.h sheet/panel.h panel/interlace.h depth/depth_input.h depth/view_set.h \
  depth/depth_quality.h depth/multibaseline.h depth/depth_files.h
pkgconfigdir = $(libdir)/pkgconfig
install-libintegral:
	cd $(srcdir) && headers=`for header in $(interface_headers); do echo "#include <integral/$$header>"; done | \
	    $(CXX) -std=c++17 -I. $(FRAME_CFLAGS) -M -x c++ - | tr ' ' '\n' | grep '^integral/'` && \
	for header in $$headers; do \
	    $(MKDIR_P) "$(DESTDIR)$(includedir)/$${header%/*}" && \
	    $(INSTALL_DATA) $$header "$(DESTDIR)$(includedir)/$$header" || exit 1; done
	$(MKDIR_P) '$(DESTDIR)$(pkgconfigdir)'
	sed -e 's|%prefix%|$(prefix)|' -e 's|%includedir%|$(includedir)|' -e 's|%libdir%|$(libdir)|' \
	    -e 's|%version%|$(PACKAGE_VERSION)|' -e 's|%libraries%|$(FILE_LIBS) $(SDL2_LIBS) -lpthread|' \
	    $(srcdir)/integral/libintegral.pc.in > '$(DESTDIR)$(pkgconfigdir)/libintegral.pc'

uninstall-libintegral:
	rm -rf '$(DESTDIR)$(includedir)/integral'
	rm -f '$(DESTDIR)$(pkgconfigdir)/libintegral.pc'
.PHONY: install-libintegral uninstall-libintegral
EXTRA_DIST += integral/libintegral.pc.in

# The same sources under AddressSanitizer and UndefinedBehaviorSanitizer, for the tests' sanitized
# layer. Automake puts the user's CXXFLAGS, -O2, behind a program's own, and -O2 doubles what these
# take to compile: so they have CXXFLAGS of their own. The commands, templates of Boost's and JSON's
# for the most part, take half as long without optimizing, and no test waits for them. Checks of
# pointers for null, alignment and type would be a sixth of the compiler's time: AddressSanitizer
# reports a null pointer that is used.
SANITIZE = -g1 -fno-omit-frame-pointer -fsanitize=address,undefined,float-cast-overflow \
  -fno-sanitize=null,alignment,vptr -fno-sanitize-recover=undefined,float-cast-overflow

EXTRA_LIBRARIES += build/sanitized/libintegral.a
build_sanitized_libintegral_a_SOURCES = $(build_lib_libintegral_a_SOURCES)
build_sanitized_libintegral_a_CXXFLAGS = $(AM_CXXFLAGS) $(SANITIZE)
$(build_sanitized_libintegral_a_OBJECTS): CXXFLAGS = -Og

EXTRA_PROGRAMS += build/sanitized/integral
build_sanitized_integral_SOURCES = $(build_bin_integral_SOURCES)
build_sanitized_integral_CXXFLAGS = $(AM_CXXFLAGS) $(SANITIZE)
build_sanitized_integral_LDADD = build/sanitized/libintegral.a $(FILE_LIBS) $(SDL2_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS)
$(build_sanitized_integral_OBJECTS): CXXFLAGS = -O0

# The same sources under ThreadSanitizer, for check-long (tests/sanitized/threads.test). POV-Ray's own
# objects, which are linked below, are not instrumented: only what libintegral's threads do is seen.
THREAD_SANITIZE = -g1 -fno-omit-frame-pointer -fsanitize=thread

EXTRA_LIBRARIES += build/threads/libintegral.a
build_threads_libintegral_a_SOURCES = $(build_lib_libintegral_a_SOURCES)
build_threads_libintegral_a_CXXFLAGS = $(AM_CXXFLAGS) $(THREAD_SANITIZE)
$(build_threads_libintegral_a_OBJECTS): CXXFLAGS = -O1

EXTRA_PROGRAMS += build/threads/integral
build_threads_integral_SOURCES = $(build_bin_integral_SOURCES)
build_threads_integral_CXXFLAGS = $(AM_CXXFLAGS) $(THREAD_SANITIZE)
build_threads_integral_LDADD = build/threads/libintegral.a $(FILE_LIBS) $(SDL2_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS)
$(build_threads_integral_OBJECTS): CXXFLAGS = -O0

build/threads/povray-integral: povray-integral build/threads/libintegral.a
	$(MAKE) -s -C build/povray/unix EXEEXT=.threads CXXFLAGS='-O2 -w -fsanitize=thread' \
	    LDADD='$$(top_builddir)/vfe/libvfe.a $$(top_builddir)/source/libpovray.a $(abs_builddir)/build/threads/libintegral.a' \
	    povray_DEPENDENCIES= povray.threads
	mv build/povray/unix/povray.threads $@
