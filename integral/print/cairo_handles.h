// SPDX-License-Identifier: AGPL-3.0-or-later
// Owns cairo's surfaces and contexts.
#ifndef INTEGRAL_PRINT_CAIRO_HANDLES_H
#define INTEGRAL_PRINT_CAIRO_HANDLES_H

#include <cairo.h>

#include <memory>

namespace integral {

struct ReleaseCairo {
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using CairoHandle = std::unique_ptr<cairo_t, ReleaseCairo>;
using SurfaceHandle = std::unique_ptr<cairo_surface_t, ReleaseCairo>;

} // namespace integral

#endif
