# SPDX-License-Identifier: AGPL-3.0-or-later
# Measurements: built and run on request (make bench), never asserted.

EXTRA_PROGRAMS += build/bench/optics_rays
build_bench_optics_rays_SOURCES = bench/optics_rays.cpp
build_bench_optics_rays_LDADD = $(LIBINTEGRAL_LIBS)

.PHONY: bench
bench: all build/bench/optics_rays
	build/bench/optics_rays
	$(srcdir)/bench/camera_cost

EXTRA_DIST += bench
