# SPDX-License-Identifier: AGPL-3.0-or-later
# The tests: tests/unit is one Boost.Test program; the other layers are scripts that tests/run finds
# by itself.

EXTRA_PROGRAMS += build/tests/unit
build_tests_unit_SOURCES = $(unit_sources)
build_tests_unit_CPPFLAGS = $(AM_CPPFLAGS) -DBOOST_TEST_DYN_LINK
build_tests_unit_LDADD = $(LIBINTEGRAL_LIBS) $(SDL2_LIBS) $(BOOST_TEST_LIBS)
# Templates of Boost's for the most part, whose compiling takes longer than their tests.
$(build_tests_unit_OBJECTS): CXXFLAGS = -Og

EXTRA_PROGRAMS += build/tests/centroid
build_tests_centroid_SOURCES = tests/replay/centroid.cpp
build_tests_centroid_LDADD = -lpng

EXTRA_PROGRAMS += build/tests/parallax
build_tests_parallax_SOURCES = tests/replay/parallax.cpp
build_tests_parallax_LDADD = $(LIBINTEGRAL_LIBS)

# For tests/cli/print_cups.test, which skips where they are missing.
if HAVE_CUPS
cups_programs = build/tests/spool build/tests/raster build/tests/dyesub
EXTRA_PROGRAMS += $(cups_programs)
build_tests_spool_SOURCES = tests/cli/helpers/spool.cpp
build_tests_spool_LDADD = $(LIBINTEGRAL_LIBS)
build_tests_raster_SOURCES = tests/cli/helpers/raster.cpp
build_tests_raster_LDADD = $(CUPS_LIBS)
build_tests_dyesub_SOURCES = tests/cli/helpers/dyesub.cpp
endif

# For tests/cli/lcd_show.test, likewise.
if HAVE_SDL2
screen_programs = build/tests/screen
EXTRA_PROGRAMS += $(screen_programs)
build_tests_screen_SOURCES = tests/cli/helpers/screen.cpp
build_tests_screen_LDADD = $(LIBINTEGRAL_LIBS) -lX11
endif

# A simulated scanner, for tests/cli/integral_rectify.test.
EXTRA_PROGRAMS += build/tests/scan
build_tests_scan_SOURCES = tests/cli/helpers/scan.cpp
build_tests_scan_LDADD = -lpng -ljpeg

# The same tests with the sanitized library, which goes first: its functions count where a header's
# are in both. The tests are not compiled twice; their 100 digits would take minutes.
EXTRA_PROGRAMS += build/sanitized/unit
build_sanitized_unit_SOURCES =
build_sanitized_unit_LINK = $(CXXLD) $(AM_CXXFLAGS) $(SANITIZE) -Wl,--whole-archive build/sanitized/libintegral.a -Wl,--no-whole-archive -o $@
build_sanitized_unit_LDADD = $(build_tests_unit_OBJECTS) $(FILE_LIBS) $(SDL2_LIBS) $(BOOST_TEST_LIBS)
build_sanitized_unit_DEPENDENCIES = $(build_tests_unit_OBJECTS) build/sanitized/libintegral.a

# Likewise under ThreadSanitizer, for check-long alone.
EXTRA_PROGRAMS += build/threads/unit
build_threads_unit_SOURCES =
build_threads_unit_LINK = $(CXXLD) $(AM_CXXFLAGS) $(THREAD_SANITIZE) -Wl,--whole-archive build/threads/libintegral.a -Wl,--no-whole-archive -o $@
build_threads_unit_LDADD = $(build_tests_unit_OBJECTS) $(FILE_LIBS) $(SDL2_LIBS) $(BOOST_TEST_LIBS)
build_threads_unit_DEPENDENCIES = $(build_tests_unit_OBJECTS) build/threads/libintegral.a

# One line per file.
unit_sources = \
  tests/unit/analysis_calibration.cpp \
  tests/unit/analysis_lattice.cpp \
  tests/unit/analysis_scan.cpp \
  tests/unit/base_eight_floats.cpp \
  tests/unit/base_json.cpp \
  tests/unit/base_message_text.cpp \
  tests/unit/batch_files.cpp \
  tests/unit/batch_progress.cpp \
  tests/unit/batch_renderer_options.cpp \
  tests/unit/batch_scene_look.cpp \
  tests/unit/batch_slurm.cpp \
  tests/unit/batch_strips.cpp \
  tests/unit/batch_tune.cpp \
  tests/unit/compare_flip.cpp \
  tests/unit/compare_pictures.cpp \
  tests/unit/compare_regions.cpp \
  tests/unit/compare_seen.cpp \
  tests/unit/compare_tolerances.cpp \
  tests/unit/depth_multibaseline.cpp \
  tests/unit/depth_surface_fill.cpp \
  tests/unit/depth_stereo_pair.cpp \
  tests/unit/depth_view_order.cpp \
  tests/unit/depth_votes.cpp \
  tests/unit/flip_oracle.h \
  tests/unit/frame_depth_range.cpp \
  tests/unit/frame_error_estimate.cpp \
  tests/unit/frame_image.cpp \
  tests/unit/frame_linear_colour.cpp \
  tests/unit/frame_metadata.cpp \
  tests/unit/io_as_shown.cpp \
  tests/unit/io_device_text.cpp \
  tests/unit/io_embedded_depth.cpp \
  tests/unit/io_html_page.cpp \
  tests/unit/io_image_files.cpp \
  tests/unit/io_jpeg_forms.cpp \
  tests/unit/io_lists_of_views.cpp \
  tests/unit/io_memory.cpp \
  tests/unit/io_mpo.cpp \
  tests/unit/io_pfm.cpp \
  tests/unit/io_plot.cpp \
  tests/unit/io_rows.cpp \
  tests/unit/io_tiff_forms.cpp \
  tests/unit/laboratory_fabrication.cpp \
  tests/unit/looking_glass_devices.h \
  tests/unit/main.cpp \
  tests/unit/numerics_table.cpp \
  tests/unit/numerics_table.h \
  tests/unit/optics_beam.cpp \
  tests/unit/optics_beam_oracle.h \
  tests/unit/optics_cells.cpp \
  tests/unit/optics_collineation.cpp \
  tests/unit/optics_fill.cpp \
  tests/unit/optics_film.cpp \
  tests/unit/optics_film_in_sight.cpp \
  tests/unit/optics_lattice.cpp \
  tests/unit/optics_film_seen.cpp \
  tests/unit/optics_lens_box.cpp \
  tests/unit/optics_mapping.cpp \
  tests/unit/optics_models.cpp \
  tests/unit/optics_oracle.h \
  tests/unit/optics_pixel_run.cpp \
  tests/unit/optics_projection.cpp \
  tests/unit/optics_properties.cpp \
  tests/unit/optics_properties.h \
  tests/unit/optics_ray_gradient.cpp \
  tests/unit/optics_rays.cpp \
  tests/unit/optics_sheets.h \
  tests/unit/optics_subpixels.cpp \
  tests/unit/optics_surface.cpp \
  tests/unit/optics_symmetries.cpp \
  tests/unit/optics_visual_pitch.cpp \
  tests/unit/panel_interlace.cpp \
  tests/unit/panel_lens_cards.cpp \
  tests/unit/picture_bytes.h \
  tests/unit/picture_files.h \
  tests/unit/pixel_origins.h \
  tests/unit/print_gang.cpp \
  tests/unit/print_lens_halftone.cpp \
  tests/unit/print_media.cpp \
  tests/unit/print_page.cpp \
  tests/unit/print_pitch_chart.cpp \
  tests/unit/print_pitch_wizard.cpp \
  tests/unit/print_relief_chart.cpp \
  tests/unit/reconstruction_beam_footprint.cpp \
  tests/unit/reconstruction_clipped_pixel.cpp \
  tests/unit/reconstruction_frames.cpp \
  tests/unit/reconstruction_layer_plane.cpp \
  tests/unit/reconstruction_noise_filter.cpp \
  tests/unit/reconstruction_pass_rows.cpp \
  tests/unit/reconstruction_pass_schedule.cpp \
  tests/unit/reconstruction_quilts.cpp \
  tests/unit/reconstruction_refinement.cpp \
  tests/unit/replay_comparators.cpp \
  tests/unit/replay_draft.cpp \
  tests/unit/replay_eyes.cpp \
  tests/unit/replay_frames.h \
  tests/unit/replay_lying_lenses.cpp \
  tests/unit/replay_page.cpp \
  tests/unit/replay_parallax.cpp \
  tests/unit/replay_paths.cpp \
  tests/unit/replay_views.cpp \
  tests/unit/sampled_frame.h \
  tests/unit/sampling_lens_profile.cpp \
  tests/unit/sampling_pixel_beam.cpp \
  tests/unit/sampling_pixel_sampler.cpp \
  tests/unit/sampling_sample_points.cpp \
  tests/unit/sampling_sample_spread.cpp \
  tests/unit/screen_displays.cpp \
  tests/unit/sheet_cubevi.cpp \
  tests/unit/sheet_figures.cpp \
  tests/unit/sheet_known_sheets.cpp \
  tests/unit/sheet_looking_glass.cpp \
  tests/unit/sheet_panel_quilt.cpp \
  tests/unit/sheet_panels.cpp \
  tests/unit/sheet_sampling_forecast.cpp \
  tests/unit/sheet_scene_fit.cpp \
  tests/unit/sheet_zone_shares.cpp \
  tests/unit/studio_placement.cpp \
  tests/unit/views_light_field.cpp \
  tests/unit/views_parallel_views.cpp \
  tests/unit/views_picture_fit.cpp \
  tests/unit/wireframe.cpp \
  tests/unit/wireframe_far.cpp \
  tests/unit/wireframe_scene.cpp

# Programs for the scripts of tests/render: an oracle that shares nothing with libintegral, and a
# comparer of PNGs.
EXTRA_PROGRAMS += build/tests/oracle build/tests/frames build/tests/depths
build_tests_oracle_SOURCES = \
  tests/render/helpers/oracle.h \
  tests/render/helpers/oracle_camera.cpp \
  tests/render/helpers/oracle_lenses.cpp \
  tests/render/helpers/oracle_lenses.h \
  tests/render/helpers/oracle_main.cpp \
  tests/render/helpers/oracle_optics.cpp
build_tests_frames_SOURCES = \
  tests/render/helpers/frames.cpp \
  tests/render/helpers/frames.h \
  tests/render/helpers/frames_compare.cpp \
  tests/render/helpers/frames_files.cpp \
  tests/render/helpers/frames_oracle.cpp
build_tests_frames_LDADD = $(FRAME_LIBS)

build_tests_depths_SOURCES = \
  tests/render/helpers/depths.cpp \
  tests/render/helpers/frames.h \
  tests/render/helpers/frames_files.cpp
build_tests_depths_LDADD = $(FRAME_LIBS)

# The program of tests/sanitized/fuzz.test: everything that reads files, with sanitized objects.
fuzz_sources = \
  tests/sanitized/fuzz/commands.cpp \
  tests/sanitized/fuzz/integral_main.cpp \
  tests/sanitized/fuzz/main.cpp \
  tests/sanitized/fuzz/png_mutation.cpp \
  tests/sanitized/fuzz/seeds.cpp \
  tests/sanitized/fuzz/targets.cpp
EXTRA_PROGRAMS += build/sanitized/mutations
build_sanitized_mutations_SOURCES = $(fuzz_sources) \
  tests/sanitized/fuzz/mutations.cpp tests/sanitized/fuzz/target.h
build_sanitized_mutations_CXXFLAGS = $(AM_CXXFLAGS) $(SANITIZE)
build_sanitized_mutations_LDADD = $(sanitized_commands) build/sanitized/libintegral.a \
  $(FILE_LIBS) $(SDL2_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS)
$(build_sanitized_mutations_OBJECTS): CXXFLAGS = -Og
sanitized_commands = $(filter-out %-main.$(OBJEXT),$(build_sanitized_integral_OBJECTS))
build_sanitized_mutations_DEPENDENCIES = $(sanitized_commands) build/sanitized/libintegral.a

test_environment = TOP='$(abs_top_srcdir)' BUILD='$(abs_top_builddir)/build' CXX='$(CXX)' MAKE='$(MAKE)'
# Programs by layer, so that a layer needs only the programs that it uses.
programs_of_unit = build/tests/unit
programs_of_render = build/tests/oracle build/tests/frames build/tests/depths build/tests/centroid
programs_of_quick = $(programs_of_unit) $(programs_of_render)
programs_of_replay = $(programs_of_render) build/tests/parallax build/bench/eyes
programs_of_cli = $(programs_of_render) build/tests/scan build/bench/large_frames $(cups_programs) $(screen_programs) $(python_tests)
programs_of_sanitized = $(programs_of_render) build/sanitized/unit build/sanitized/integral \
  build/sanitized/mutations
chosen_layers = $(or $(LAYERS),unit render replay cli days sanitized)
test_programs = $(sort $(foreach layer,$(chosen_layers),$(programs_of_$(layer))))

# The unmodified POV-Ray that the tests compare with (tests/unmodified): compiled here only where
# the distribution has none of this version.
.PHONY: unmodified test-programs quick-programs check-quick check-long
unmodified: povray-integral
	@$(test_environment) $(abs_top_srcdir)/tests/unmodified --path > /dev/null 2>&1 || $(MAKE) pristine

test-programs: all $(test_programs) unmodified
quick-programs: all $(programs_of_quick) unmodified

check-local: test-programs
	@$(test_environment) $(abs_top_srcdir)/tests/run $(LAYERS)

# Runs the tests marked "# quick: yes", for an answer in minutes.
check-quick: quick-programs
	@$(test_environment) $(abs_top_srcdir)/tests/run --quick $(LAYERS)

# The same tests at full size (see tests/README): hours. They compare with POV-Ray as compiled here,
# whatever is installed.
thread_programs = $(if $(filter sanitized,$(chosen_layers)),build/threads/unit build/threads/integral build/threads/povray-integral)
check-long: all $(test_programs) $(thread_programs) pristine
	@$(test_environment) $(abs_top_srcdir)/tests/run --long $(LAYERS)
	@$(MAKE) mutate

# Small faults that a test should notice (tests/README).
.PHONY: mutate
mutate: build/bin/integral build/tests/unit
	@$(test_environment) $(abs_top_srcdir)/tests/mutate --number=$(or $(MUTATIONS),50) --seed=$(or $(SEED),1)

# The table of doc/numerics.md, as measured: LONG=1 make numerics, twenty minutes, when the optics
# change.
.PHONY: numerics
numerics: build/tests/unit
	NUMERICS_TABLE=build/tests/numerics.md build/tests/unit --run_test=optics_rays,optics_beam
	sed -i -e '/^<!-- table/,/^<!-- end/{//!d}' -e '/^<!-- table/r build/tests/numerics.md' $(srcdir)/doc/numerics.md

EXTRA_DIST += tests

# The program of fuzz.test under check-long: everything again, compiled by clang for libFuzzer. GNU
# make's rules, for clang's own flags.
FUZZ_CXX = clang++
FUZZ_CXXFLAGS = -std=c++17 -O1 -g1 -fno-omit-frame-pointer -fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow \
  -fno-sanitize-recover=undefined,float-cast-overflow
fuzz_objects = $(patsubst %.cpp,build/fuzz/%.o,$(filter %.cpp,$(build_lib_libintegral_a_SOURCES) \
  $(filter-out integral/cli/main.cpp,$(build_bin_integral_SOURCES)) $(fuzz_sources)))
build/fuzz/readers: $(fuzz_objects)
	$(AM_V_CXXLD)$(FUZZ_CXX) -fsanitize=fuzzer,address,undefined -o $@ $(fuzz_objects) $(FILE_LIBS) $(SDL2_LIBS) $(BOOST_PROGRAM_OPTIONS_LIBS) -lpthread
build/fuzz/%.o: %.cpp build/generated/page_texts.h
	$(AM_V_CXX)$(MKDIR_P) $(@D) && $(FUZZ_CXX) $(DEFS) $(AM_CPPFLAGS) $(FUZZ_CXXFLAGS) -MMD -MP -c -o $@ $<
-include $(fuzz_objects:.o=.d)
