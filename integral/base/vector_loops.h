// SPDX-License-Identifier: AGPL-3.0-or-later
// Compiles the plain loops over arrays in a source file to vector instructions. Include it after
// everything else: the code that follows is compiled with -O3, since gcc 12 does not vectorise such
// loops at -O2. INTEGRAL_VECTORS before a function also compiles a version for AVX2, which runs on
// processors with AVX2. That version has no fused multiply-add, so that it rounds as SSE does.
#ifndef INTEGRAL_BASE_VECTOR_LOOPS_H
#define INTEGRAL_BASE_VECTOR_LOOPS_H

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O3")
// A sanitizer's runtime is not ready yet when the loader chooses between the two versions.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_ADDRESS__) &&             \
    !defined(__SANITIZE_THREAD__)
#define INTEGRAL_VECTORS __attribute__((target_clones("avx2", "default")))
#endif
#endif
#ifndef INTEGRAL_VECTORS
#define INTEGRAL_VECTORS
#endif

#endif
