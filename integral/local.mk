# SPDX-License-Identifier: AGPL-3.0-or-later
# libintegral (what POV-Ray's hooks and the integral program share) and the program itself.

noinst_LIBRARIES += build/lib/libintegral.a
build_lib_libintegral_a_SOURCES =

bin_PROGRAMS += build/bin/integral
build_bin_integral_SOURCES =
build_bin_integral_LDADD = $(LIBINTEGRAL_LIBS) $(SDL2_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS)

include $(srcdir)/integral/base/local.mk
include $(srcdir)/integral/optics/local.mk
include $(srcdir)/integral/lightfield/local.mk
include $(srcdir)/integral/replay/local.mk
include $(srcdir)/integral/compare/local.mk
include $(srcdir)/integral/output/local.mk
include $(srcdir)/integral/analysis/local.mk
include $(srcdir)/integral/depth/local.mk
include $(srcdir)/integral/fabrication/local.mk
include $(srcdir)/integral/io/local.mk
include $(srcdir)/integral/wireframe/local.mk
include $(srcdir)/integral/batch/local.mk
include $(srcdir)/integral/resolution/local.mk
include $(srcdir)/integral/multiview/local.mk
include $(srcdir)/integral/cli/local.mk

# Its man page says what its parser knows.
man_MANS += build/share/man/integral.1
CLEANFILES += build/share/man/integral.1
build/share/man/integral.1: build/bin/integral
	$(AM_V_GEN)$(MKDIR_P) build/share/man && build/bin/integral help --man > $@.tmp && mv $@.tmp $@

# The same sources under AddressSanitizer and UndefinedBehaviorSanitizer, for the tests' sanitized
# layer. Automake puts the user's CXXFLAGS, -O2, behind a program's own, and -O2 doubles what these
# take to compile: so they have CXXFLAGS of their own. The commands, templates of Boost's and JSON's
# for the most part, take half as long without optimizing, and no test waits for them.
SANITIZE = -g1 -fno-omit-frame-pointer -fsanitize=address,undefined,float-cast-overflow \
  -fno-sanitize-recover=undefined,float-cast-overflow

EXTRA_LIBRARIES += build/sanitized/libintegral.a
build_sanitized_libintegral_a_SOURCES = $(build_lib_libintegral_a_SOURCES)
build_sanitized_libintegral_a_CXXFLAGS = $(AM_CXXFLAGS) $(SANITIZE)
$(build_sanitized_libintegral_a_OBJECTS): CXXFLAGS = -O1

EXTRA_PROGRAMS += build/sanitized/integral
build_sanitized_integral_SOURCES = $(build_bin_integral_SOURCES)
build_sanitized_integral_CXXFLAGS = $(AM_CXXFLAGS) $(SANITIZE)
build_sanitized_integral_LDADD = build/sanitized/libintegral.a $(FILE_LIBS) $(SDL2_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS)
$(build_sanitized_integral_OBJECTS): CXXFLAGS = -O0
