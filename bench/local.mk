# SPDX-License-Identifier: AGPL-3.0-or-later
# Measurements: built and run on request (make bench), never asserted.

EXTRA_PROGRAMS += build/bench/optics_rays
build_bench_optics_rays_SOURCES = bench/optics_rays.cpp
build_bench_optics_rays_LDADD = $(LIBINTEGRAL_LIBS)

EXTRA_PROGRAMS += build/bench/replay_speed
build_bench_replay_speed_SOURCES = bench/replay_speed.cpp
build_bench_replay_speed_LDADD = $(LIBINTEGRAL_LIBS)

EXTRA_PROGRAMS += build/bench/compare_speed
build_bench_compare_speed_SOURCES = bench/compare_speed.cpp
build_bench_compare_speed_LDADD = $(LIBINTEGRAL_LIBS)

EXTRA_PROGRAMS += build/bench/interlace_speed
build_bench_interlace_speed_SOURCES = bench/interlace_speed.cpp
build_bench_interlace_speed_LDADD = $(LIBINTEGRAL_LIBS)

# Wireframes of 100,000 edges (doc/thesis.md).
EXTRA_PROGRAMS += build/bench/wireframe_speed
build_bench_wireframe_speed_SOURCES = bench/wireframe_speed.cpp
build_bench_wireframe_speed_LDADD = $(LIBINTEGRAL_LIBS)

# Seconds and memory of commands for a frame of 12000 x 8400 pixels. Takes minutes and gigabytes of
# disk; its test uses a small frame.
check_PROGRAMS += build/bench/large_frames
build_bench_large_frames_SOURCES = bench/large_frames.cpp bench/program.h
build_bench_large_frames_LDADD = $(LIBINTEGRAL_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS)

.PHONY: large-frames
large-frames: all build/bench/large_frames
	build/bench/large_frames

# The fraction of a quilt that interlacing reads, and the costs of panel images rendered natively
# and from views (doc/panels.md). Takes minutes.
EXTRA_PROGRAMS += build/bench/quilt_use
build_bench_quilt_use_SOURCES = bench/quilt_use.cpp
build_bench_quilt_use_LDADD = $(LIBINTEGRAL_LIBS)

.PHONY: panel-tables
panel-tables: all pristine build/bench/quilt_use
	build/bench/quilt_use
	$(srcdir)/bench/native_against_quilt

# How well integral depth measures rendered scenes (doc/depth.md). Takes some 20 minutes.
EXTRA_PROGRAMS += build/bench/depth_truth
build_bench_depth_truth_SOURCES = bench/depth_truth.cpp
build_bench_depth_truth_LDADD = $(LIBINTEGRAL_LIBS)

EXTRA_PROGRAMS += build/bench/depth_limit
build_bench_depth_limit_SOURCES = bench/depth_limit.cpp
build_bench_depth_limit_LDADD = $(LIBINTEGRAL_LIBS)

# The picture of method A's ghost points.
EXTRA_PROGRAMS += build/bench/depth_ghosts
build_bench_depth_ghosts_SOURCES = bench/depth_ghosts.cpp
build_bench_depth_ghosts_LDADD = $(LIBINTEGRAL_LIBS)

# OpenCV's stereo matcher beside it, where OpenCV is (Debian: libopencv-calib3d-dev,
# libopencv-imgcodecs-dev); else the table says that it is missing.
if HAVE_OPENCV
EXTRA_PROGRAMS += build/bench/depth_matcher
build_bench_depth_matcher_SOURCES = bench/depth_matcher.cpp
build_bench_depth_matcher_CPPFLAGS = $(AM_CPPFLAGS) -isystem /usr/include/opencv4
build_bench_depth_matcher_LDADD = $(LIBINTEGRAL_LIBS) -lopencv_calib3d -lopencv_imgcodecs -lopencv_core
depth_matcher = build/bench/depth_matcher
endif

.PHONY: depth-scores
depth-scores: all pristine build/bench/depth_truth build/bench/depth_limit $(depth_matcher)
	$(srcdir)/bench/depth_scores $(abs_builddir)/build/bench/depth-scores
	$(srcdir)/bench/depth_remade $(abs_builddir)/build/bench/depth-scores

# What integral rectify finds in scans whose lattice is known (doc/commands/rectify.md). Takes some 20
# minutes.
.PHONY: rectify-truth
rectify-truth: all build/tests/scan
	$(srcdir)/bench/rectify_truth $(abs_builddir)/build/bench/rectify-truth

.PHONY: bench
bench: all pristine build/bench/optics_rays build/bench/replay_speed build/bench/interlace_speed \
  build/bench/wireframe_speed
	build/bench/optics_rays
	build/bench/replay_speed
	build/bench/interlace_speed
	build/bench/wireframe_speed
	$(srcdir)/bench/start_and_end
	$(srcdir)/bench/camera_cost
	$(srcdir)/bench/strip_cost
	$(srcdir)/bench/batch_throughput

# Anti-aliasing against brute force on POV-Ray's own sample scenes (doc/error-against-time.md):
# hours; what is measured is kept and not measured again.
EXTRA_PROGRAMS += build/bench/strangers
build_bench_strangers_SOURCES = bench/pictures.cpp bench/pictures.h bench/program.h \
  bench/renderer.cpp bench/renderer.h bench/strangers.cpp bench/strangers.h bench/strangers_figures.cpp \
  bench/strangers_report.cpp bench/strangers_table.cpp bench/views.cpp bench/views.h
build_bench_strangers_LDADD = $(LIBINTEGRAL_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS)

.PHONY: strangers
strangers: all build/bench/strangers
	build/bench/strangers -o build/bench/strangers-tables

# Frames judged by an eye that moves past them: bench/moving_eye REFERENCE FRAME...
EXTRA_PROGRAMS += build/bench/moving_eye
build_bench_moving_eye_SOURCES = bench/moving_eye.cpp bench/pictures.cpp bench/pictures.h \
  bench/program.h bench/renderer.cpp bench/renderer.h bench/views.cpp bench/views.h
build_bench_moving_eye_LDADD = $(LIBINTEGRAL_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS)

# Other routes to a frame, with an unmodified POV-Ray, on three of its sample scenes.
.PHONY: other-routes
other-routes: all build/tests/oracle
	$(srcdir)/bench/other_routes

# The thesis's table 4-1 (doc/table-4-1.md): doc/images/table-4-1.png and the figures. Takes a few
# minutes of rendering.
EXTRA_PROGRAMS += build/bench/table_4_1
build_bench_table_4_1_SOURCES = bench/table_4_1.cpp bench/pictures.cpp bench/pictures.h \
  bench/program.h bench/renderer.cpp bench/renderer.h bench/views.cpp bench/views.h
build_bench_table_4_1_LDADD = $(LIBINTEGRAL_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS)

.PHONY: table-4-1
table-4-1: all build/bench/table_4_1
	build/bench/table_4_1 build/bench/table-4-1 $(srcdir)/bench/scenes

# What 25 eyes see of a frame, and the limits that lenses and pixels set (doc/eyes.md). Takes
# minutes of rendering; its test runs a small part.
EXTRA_PROGRAMS += build/bench/eyes
build_bench_eyes_SOURCES = \
  bench/camera_array.cpp \
  bench/camera_array.h \
  bench/eyes.cpp \
  bench/pictures.cpp \
  bench/pictures.h \
  bench/program.h \
  bench/renderer.cpp \
  bench/renderer.h \
  bench/views.cpp \
  bench/views.h
build_bench_eyes_LDADD = $(LIBINTEGRAL_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS)

.PHONY: eyes
eyes: all pristine build/bench/eyes
	build/bench/eyes --scenes $(srcdir)/bench/scenes -o build/bench/eyes-tables

# The studio's live picture without a browser, where EGL and OpenGL ES 3 are, against exact frames of
# upstream's scenes.
if HAVE_GLES
EXTRA_PROGRAMS += build/bench/live_view
build_bench_live_view_SOURCES = bench/live_drawing.cpp bench/live_drawing.h bench/live_view.cpp bench/program.h
build_bench_live_view_LDADD = $(LIBINTEGRAL_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS) -lEGL -lGLESv2
bench/live_view.$(OBJEXT): build/generated/page_texts.h

live-against-exact: all build/bench/live_view
	$(srcdir)/bench/live_against_exact
endif
.PHONY: live-against-exact

# What integral rectify --calibration measures in a hundred simulated photographs
# (doc/commands/rectify.md). Takes some 20 minutes. Needs Python with numpy and PIL.
.PHONY: calibration-table
calibration-table: all
	$(srcdir)/bench/calibration $(abs_builddir)/build/bench/calibration
