// SPDX-License-Identifier: AGPL-3.0-or-later
#include "integral/batch/planned_batch.h"

#include "integral/batch/batch_steps.h"

namespace integral {

PlannedBatch::PlannedBatch(Manifest read)
    : manifest(std::move(read)),
      plan(plan_of(manifest)),
      programs(batch_programs()),
      folder(batch_folder(manifest.output)),
      inputs(manifest, programs)
{
}

} // namespace integral
