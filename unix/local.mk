# SPDX-License-Identifier: AGPL-3.0-or-later
# Builds POV-Ray: assembles the pinned source with our files and patches in build/povray, and
# compiles it there with upstream's make. The scripts in unix/ do this and skip what has not
# changed.

povray_environment = TOP='$(abs_top_srcdir)' BUILD='$(abs_top_builddir)/build' \
  CXX='$(CXX)' sysconfdir='$(POVRAY_SYSCONFDIR)' datadir='$(POVRAY_DATADIR)'

.PHONY: povray-integral pristine refresh check-patches

all-local: povray-integral $(python_of_all)

povray-integral: build/lib/libintegral.a
	@$(povray_environment) $(abs_top_srcdir)/unix/assemble `$(povray_environment) \
	    $(abs_top_srcdir)/unix/fetch-upstream '$(POVRAY_SOURCE)'`
	+@$(povray_environment) $(abs_top_srcdir)/unix/build-povray povray $(abs_top_builddir)/build/lib/libintegral.a
	@$(MKDIR_P) build/bin
	@cmp -s build/povray/unix/povray build/bin/povray-integral || \
	    { cp build/povray/unix/povray build/bin/.povray-integral.new && \
	      mv build/bin/.povray-integral.new build/bin/povray-integral && echo built build/bin/povray-integral; }
	@$(povray_environment) $(abs_top_srcdir)/unix/stage-share

# Unpatched upstream, compiled with the same flags, for comparison in check-long and bench.
pristine: povray-integral
	+@$(povray_environment) $(abs_top_srcdir)/unix/build-povray pristine

# The edit loop (doc/patches.md): edit below build/povray, make, make refresh, make check-patches.
refresh:
	@$(povray_environment) $(abs_top_srcdir)/unix/refresh

check-patches: povray-integral
	@$(povray_environment) $(abs_top_srcdir)/unix/check-patches

# All installed names are our own, so that an installed povray is not touched.
shareddir = $(datadir)/povray-integral-3.7
legaldir = $(datadir)/doc/povray-integral
dist_man_MANS = unix/povray-integral.1

install-exec-local: povray-integral
	$(MKDIR_P) '$(DESTDIR)$(bindir)'
	$(INSTALL_PROGRAM) build/bin/povray-integral '$(DESTDIR)$(bindir)/povray-integral'

install-data-local: povray-integral install-libintegral $(python_of_install)
	$(MKDIR_P) '$(DESTDIR)$(shareddir)' '$(DESTDIR)$(legaldir)'
	cp -RL build/share/povray-integral-3.7/. '$(DESTDIR)$(shareddir)'
	chmod -R u+rwX,go+rX,go-w '$(DESTDIR)$(shareddir)'
	$(INSTALL_DATA) $(top_srcdir)/LICENSE build/pristine/distribution/agpl-3.0.txt build/pristine/unix/AUTHORS \
	    '$(DESTDIR)$(legaldir)'
	cp -R $(top_srcdir)/doc/. '$(DESTDIR)$(legaldir)'
	chmod -R u+rwX,go+rX,go-w '$(DESTDIR)$(legaldir)'

uninstall-local: uninstall-libintegral $(python_of_uninstall)
	rm -f '$(DESTDIR)$(bindir)/povray-integral'
	rm -rf '$(DESTDIR)$(shareddir)' '$(DESTDIR)$(legaldir)'

# clean keeps the downloaded tarball; distclean deletes it.
clean-local:
	@edits=`$(povray_environment) $(abs_top_srcdir)/unix/edits`; test -z "$$edits" || \
	    { echo "build/povray has edits that are not in the queue:" \
	      $$edits"; run make refresh first, or delete them" >&2; exit 1; }
	rm -rf build/povray build/povray.* build/pristine build/pristine.* build/share build/tests \
	    build/sanitized build/fuzz build/bin

distclean-local:
	@edits=`$(povray_environment) $(abs_top_srcdir)/unix/edits`; test -z "$$edits" || \
	    { echo "build/povray has edits that are not in the queue:" \
	      $$edits"; run make refresh first, or delete them" >&2; exit 1; }
	rm -rf build

EXTRA_DIST += unix/upstream.pin unix/series.upstream unix/series.camera unix/queue.sh \
  unix/fetch-upstream unix/apt-source unix/assemble unix/edits unix/refresh unix/check-patches \
  unix/lint-patches unix/make-settings unix/build-povray unix/stage-share unix/packages unix/packages-test \
  unix/texts-as-strings source vfe
