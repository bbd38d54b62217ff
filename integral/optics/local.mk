# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/optics: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/optics/aperture.cpp \
  integral/optics/aperture.h \
  integral/optics/aperture_error.h \
  integral/optics/beam.cpp \
  integral/optics/beam.h \
  integral/optics/camera.cpp \
  integral/optics/camera.h \
  integral/optics/camera_parameters.cpp \
  integral/optics/camera_parameters.h \
  integral/optics/collineation.h \
  integral/optics/coverage.cpp \
  integral/optics/coverage.h \
  integral/optics/film.h \
  integral/optics/film_in_sight.cpp \
  integral/optics/film_in_sight.h \
  integral/optics/film_seen.cpp \
  integral/optics/film_seen.h \
  integral/optics/lens_box.cpp \
  integral/optics/lens_box.h \
  integral/optics/lens_mapping.cpp \
  integral/optics/lens_mapping.h \
  integral/optics/lens_model.cpp \
  integral/optics/lens_model.h \
  integral/optics/lens_search.cpp \
  integral/optics/lens_sheet.cpp \
  integral/optics/lens_sheet.h \
  integral/optics/lens_surface.cpp \
  integral/optics/lens_surface.h \
  integral/optics/pixel_run.cpp \
  integral/optics/pixel_run.h \
  integral/optics/projection.h \
  integral/optics/ray_gradient.cpp \
  integral/optics/ray_gradient.h \
  integral/optics/refraction.h \
  integral/optics/slit.cpp \
  integral/optics/slit.h \
  integral/optics/subpixels.cpp \
  integral/optics/subpixels.h \
  integral/optics/vec.h \
  integral/optics/visual_pitch.cpp \
  integral/optics/visual_pitch.h
