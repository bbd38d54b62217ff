// SPDX-License-Identifier: AGPL-3.0-or-later
// Owns objects of C libraries.
#ifndef INTEGRAL_IO_RELEASE_H
#define INTEGRAL_IO_RELEASE_H

namespace integral {

/// A deleter for std::unique_ptr that calls the library's own release function.
template <class Object, void (*release)(Object*)> struct Release {
    void operator()(Object* object) const { release(object); }
};

} // namespace integral

#endif
