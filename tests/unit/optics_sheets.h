// SPDX-License-Identifier: AGPL-3.0-or-later
// Random sheets over the ranges of optics.md section 7, for the tests of integral/optics.
#ifndef TESTS_UNIT_OPTICS_SHEETS_H
#define TESTS_UNIT_OPTICS_SHEETS_H

#include "integral/optics/lens_mapping.h"

#include <cstdlib>
#include <ostream>
#include <random>

/// Null where the program is not linked with AddressSanitizer. (The same objects are linked with
/// and without it.)
extern "C" void __asan_init() __attribute__((weak));

namespace random_sheets {

/// `few` in CI, `many` under make check-long (LONG=1). The sanitized program, which looks for bad
/// memory accesses and is slow, takes a quarter of `few`.
inline int count(int few, int many)
{
    if (std::getenv("LONG") && *std::getenv("LONG") == '1')
        return many;
    return __asan_init ? (few + 3) / 4 : few;
}

class Generator {
public:
    explicit Generator(unsigned seed) : engine_(seed) {}
    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    double log_between(double low, double high)
    {
        return std::exp(between(std::log(low), std::log(high)));
    }
    bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(engine_) == 1; }

    /// p 1e-4..1e3, t/p 0.02..1e4, n 1 (exactly)..4, slant -90..90.
    integral::LensSheet sheet()
    {
        integral::LensSheet sheet;
        sheet.arrangement = integral::Arrangement(
            std::uniform_int_distribution<int>(0, 2)(engine_));
        sheet.pitch = log_between(1e-4, 1e3);
        sheet.thickness = sheet.pitch * log_between(0.02, 1e4);
        sheet.ior = one_in(6) ? 1 : one_in(6) ? 1 + log_between(1e-12, 1e-1) : between(1, 4);
        sheet.slant = one_in(3)   ? 0
                      : one_in(8) ? (one_in(2) ? 1 : -1) * (one_in(2) ? 90 : 89.99)
                                  : between(-90, 90);
        sheet.offset = {one_in(2) ? 0 : between(-3, 3) * sheet.pitch,
                        one_in(2) ? 0 : between(-3, 3) * sheet.pitch};
        return sheet;
    }
    /// d 1e-2..1e9 mm.
    double distance() { return log_between(1e-2, 1e9); }

private:
    std::mt19937_64 engine_;
};

} // namespace random_sheets

namespace integral {

inline std::ostream& operator<<(std::ostream& out, const LensSheet& s)
{
    return out.precision(17), out << "arrangement " << int(s.arrangement) << " pitch " << s.pitch
                                  << " thickness " << s.thickness << " ior " << s.ior << " slant "
                                  << s.slant << " offset <" << s.offset.x << ", " << s.offset.y
                                  << ">";
}

} // namespace integral

#endif
