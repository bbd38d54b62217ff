// SPDX-License-Identifier: AGPL-3.0-or-later
// Introductory text that povray-integral and integral print for new users.
#ifndef INTEGRAL_BASE_FIRST_STEPS_H
#define INTEGRAL_BASE_FIRST_STEPS_H

namespace integral {

/// The commands that lead from a scene, SCENE.pov, to an interactive page, a print and an image for
/// a panel; ten lines.
const char* first_steps();

} // namespace integral

#endif
