// SPDX-License-Identifier: AGPL-3.0-or-later
// For source files of plain loops over arrays that the compiler is to make vector instructions of.
// Include it after everything else: what follows is compiled with -O3, since gcc 12 makes no
// vectors of
// such loops at -O2. INTEGRAL_VECTORS before a function compiles it for AVX2, too, and takes that
// where the processor has it; without fused multiply-add it rounds as SSE does.
#ifndef INTEGRAL_BASE_VECTOR_LOOPS_H
#define INTEGRAL_BASE_VECTOR_LOOPS_H

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O3")
// A sanitizer's runtime is not there yet when the loader chooses between the two.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_ADDRESS__) &&             \
    !defined(__SANITIZE_THREAD__)
#define INTEGRAL_VECTORS __attribute__((target_clones("avx2", "default")))
#endif
#endif
#ifndef INTEGRAL_VECTORS
#define INTEGRAL_VECTORS
#endif

#endif
