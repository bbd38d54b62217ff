// SPDX-License-Identifier: AGPL-3.0-or-later
// What both programs tell somebody who does not know where to begin.
#ifndef INTEGRAL_BASE_FIRST_STEPS_H
#define INTEGRAL_BASE_FIRST_STEPS_H

namespace integral {

/// The commands from a scene, SCENE.pov, to a look, a print and an image for a panel; ten lines.
const char* first_steps();

} // namespace integral

#endif
