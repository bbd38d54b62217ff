// SPDX-License-Identifier: AGPL-3.0-or-later
// Places the loops of a function at the start of cache lines. The interpreter of functions fetches and
// dispatches an instruction with 33 bytes of code; if the linker places these across two cache lines, scenes
// take up to 1.7 times as long.
#ifndef POVRAY_BACKEND_ALIGNEDLOOP_H
#define POVRAY_BACKEND_ALIGNEDLOOP_H

#if defined(__GNUC__) && !defined(__clang__)
#define POV_ALIGNED_LOOPS __attribute__((optimize("align-loops=64")))
#else
#define POV_ALIGNED_LOOPS
#endif

#endif
