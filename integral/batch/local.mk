# SPDX-License-Identifier: AGPL-3.0-or-later
# Sources of integral/batch: one line per file, headers too.

build_lib_libintegral_a_SOURCES += \
  integral/batch/batch_folder.cpp \
  integral/batch/batch_folder.h \
  integral/batch/batch_memory.cpp \
  integral/batch/batch_memory.h \
  integral/batch/batch_report.cpp \
  integral/batch/batch_report.h \
  integral/batch/batch_run.cpp \
  integral/batch/batch_run.h \
  integral/batch/batch_schedule.cpp \
  integral/batch/batch_schedule.h \
  integral/batch/batch_steps.cpp \
  integral/batch/batch_steps.h \
  integral/batch/batch_strips.cpp \
  integral/batch/batch_strips.h \
  integral/batch/child_process.cpp \
  integral/batch/child_process.h \
  integral/batch/cluster.cpp \
  integral/batch/cluster.h \
  integral/batch/cluster_queue.cpp \
  integral/batch/cluster_queue.h \
  integral/batch/content_hash.cpp \
  integral/batch/content_hash.h \
  integral/batch/located_json.cpp \
  integral/batch/located_json.h \
  integral/batch/lock_file.cpp \
  integral/batch/lock_file.h \
  integral/batch/manifest.cpp \
  integral/batch/manifest.h \
  integral/batch/manifest_fields.cpp \
  integral/batch/manifest_fields.h \
  integral/batch/plan.cpp \
  integral/batch/plan.h \
  integral/batch/planned_batch.cpp \
  integral/batch/planned_batch.h \
  integral/batch/renderer.cpp \
  integral/batch/renderer.h \
  integral/batch/renderer_options.cpp \
  integral/batch/renderer_options.h \
  integral/batch/running_steps.cpp \
  integral/batch/running_steps.h \
  integral/batch/scene_depths.cpp \
  integral/batch/scene_depths.h \
  integral/batch/scene_files.cpp \
  integral/batch/scene_files.h \
  integral/batch/slurm.cpp \
  integral/batch/slurm.h \
  integral/batch/step_record.cpp \
  integral/batch/step_record.h \
  integral/batch/strips.cpp \
  integral/batch/strips.h \
  integral/batch/tune.cpp \
  integral/batch/tune.h \
  integral/batch/tune_report.cpp \
  integral/batch/tune_report.h
