# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/wireframe: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/wireframe/block_mesh.cpp \
  integral/wireframe/block_mesh.h \
  integral/wireframe/depth_limits.h \
  integral/wireframe/far_things.cpp \
  integral/wireframe/film_loops.cpp \
  integral/wireframe/film_loops.h \
  integral/wireframe/lens_bins.cpp \
  integral/wireframe/lens_bins.h \
  integral/wireframe/lens_drawing.cpp \
  integral/wireframe/lens_drawing.h \
  integral/wireframe/lens_faces.cpp \
  integral/wireframe/lens_pixels.cpp \
  integral/wireframe/lens_pixels.h \
  integral/wireframe/lens_raster.cpp \
  integral/wireframe/lens_raster.h \
  integral/wireframe/lens_rays.cpp \
  integral/wireframe/lens_rays.h \
  integral/wireframe/mesh.cpp \
  integral/wireframe/mesh.h \
  integral/wireframe/mesh_file.cpp \
  integral/wireframe/mesh_file.h \
  integral/wireframe/mesh_scene.cpp \
  integral/wireframe/mesh_scene.h \
  integral/wireframe/obj_file.cpp \
  integral/wireframe/obj_file.h \
  integral/wireframe/point_squares.cpp \
  integral/wireframe/point_squares.h \
  integral/wireframe/vertex_film.cpp \
  integral/wireframe/vertex_film.h \
  integral/wireframe/wireframe.cpp \
  integral/wireframe/wireframe.h \
  integral/wireframe/wireframe_report.cpp \
  integral/wireframe/wireframe_report.h

if HAVE_ASSIMP
build_lib_libintegral_a_SOURCES += integral/wireframe/assimp_file.cpp
else
build_lib_libintegral_a_SOURCES += integral/wireframe/without_assimp.cpp
endif
