// SPDX-License-Identifier: AGPL-3.0-or-later
// Detects at run time whether the processor has AVX2. AVX2 is used only if INTEGRAL_HAS_AVX2 is
// defined.
#ifndef INTEGRAL_BASE_AVX2_H
#define INTEGRAL_BASE_AVX2_H

#if defined(__x86_64__) && defined(__GNUC__)
#define INTEGRAL_HAS_AVX2

namespace integral {

inline bool has_avx2()
{
    static const bool has = __builtin_cpu_supports("avx2");
    return has;
}

} // namespace integral

#endif

#endif
