// SPDX-License-Identifier: AGPL-3.0-or-later
// Owners of what C libraries hand out.
#ifndef INTEGRAL_IO_RELEASE_H
#define INTEGRAL_IO_RELEASE_H

namespace integral {

/// For std::unique_ptr: gives an object back by the library's own function.
template <class Object, void (*release)(Object*)> struct Release {
    void operator()(Object* object) const { release(object); }
};

} // namespace integral

#endif
