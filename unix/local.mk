# SPDX-License-Identifier: AGPL-3.0-or-later
# POV-Ray itself: the pinned source assembled with our files and patches under build/povray and compiled there by
# upstream's own make. unix/*'s scripts do the work and skip what has not changed.

povray_environment = TOP='$(abs_top_srcdir)' BUILD='$(abs_top_builddir)/build' \
  CXX='$(CXX)' sysconfdir='$(POVRAY_SYSCONFDIR)' datadir='$(POVRAY_DATADIR)'

.PHONY: povray-integral pristine refresh check-patches

all-local: povray-integral

povray-integral: build/lib/libintegral.a
	@$(povray_environment) $(abs_top_srcdir)/unix/assemble `$(povray_environment) \
	    $(abs_top_srcdir)/unix/fetch-upstream '$(POVRAY_SOURCE)'`
	+@$(povray_environment) $(abs_top_srcdir)/unix/build-povray povray $(abs_top_builddir)/build/lib/libintegral.a
	@$(MKDIR_P) build/bin
	@cmp -s build/povray/unix/povray build/bin/povray-integral || \
	    { cp build/povray/unix/povray build/bin/.povray-integral.new && \
	      mv build/bin/.povray-integral.new build/bin/povray-integral && echo built build/bin/povray-integral; }
	@$(povray_environment) $(abs_top_srcdir)/unix/stage-share

# Upstream without a patch, compiled with the same flags: what check-long and the benches compare with.
pristine: povray-integral
	+@$(povray_environment) $(abs_top_srcdir)/unix/build-povray pristine

# The edit loop (doc/patches.md): edit below build/povray, make, make refresh, make check-patches.
refresh:
	@$(povray_environment) $(abs_top_srcdir)/unix/refresh

check-patches: povray-integral
	@$(povray_environment) $(abs_top_srcdir)/unix/check-patches

# Beside a stock povray: names of our own only.
shareddir = $(datadir)/povray-integral-3.7
legaldir = $(datadir)/doc/povray-integral
dist_man_MANS = unix/povray-integral.1

install-exec-local: povray-integral
	$(MKDIR_P) '$(DESTDIR)$(bindir)'
	$(INSTALL_PROGRAM) build/bin/povray-integral '$(DESTDIR)$(bindir)/povray-integral'

install-data-local: povray-integral
	$(MKDIR_P) '$(DESTDIR)$(shareddir)' '$(DESTDIR)$(legaldir)'
	cp -RL build/share/povray-integral-3.7/. '$(DESTDIR)$(shareddir)'
	chmod -R u+rwX,go+rX,go-w '$(DESTDIR)$(shareddir)'
	$(INSTALL_DATA) $(top_srcdir)/LICENSE build/pristine/distribution/agpl-3.0.txt build/pristine/unix/AUTHORS \
	    '$(DESTDIR)$(legaldir)'

uninstall-local:
	rm -f '$(DESTDIR)$(bindir)/povray-integral'
	rm -rf '$(DESTDIR)$(shareddir)' '$(DESTDIR)$(legaldir)'

# What was downloaded stays for the next build; distclean drops it.
clean-local:
	@edits=`$(povray_environment) $(abs_top_srcdir)/unix/edits`; test -z "$$edits" || \
	    { echo "build/povray has edits that are not in the queue:" $$edits"; run make refresh first, or delete them" >&2; exit 1; }
	rm -rf build/povray build/povray.* build/pristine build/pristine.* build/share build/tests build/sanitized build/fuzz build/bin

distclean-local:
	@edits=`$(povray_environment) $(abs_top_srcdir)/unix/edits`; test -z "$$edits" || \
	    { echo "build/povray has edits that are not in the queue:" $$edits"; run make refresh first, or delete them" >&2; exit 1; }
	rm -rf build

EXTRA_DIST += unix/upstream.pin unix/series.upstream unix/series.camera unix/queue.sh unix/fetch-upstream unix/apt-source unix/assemble unix/edits \
  unix/refresh unix/check-patches unix/lint-patches unix/build-povray unix/stage-share unix/packages unix/packages-test source vfe
